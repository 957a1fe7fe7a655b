// What may be typed into a number field.
#include "ui/arithmetic.h"

#include <gtest/gtest.h>

#include <string>

namespace splineloft::ui {
namespace {

TEST(Arithmetic, readsNumbersAndSums) {
    EXPECT_EQ(valueOf("3"), 3);
    EXPECT_EQ(valueOf(" -4.375 "), -4.375);
    EXPECT_EQ(valueOf("−4.375"), -4.375) << "a true minus sign";
    EXPECT_EQ(valueOf("+.5"), 0.5);
    EXPECT_EQ(valueOf("1e3"), 1000);
    EXPECT_EQ(valueOf("3+0.1"), 3.1);
    EXPECT_EQ(valueOf("2 - 3 - 4"), -5);
    EXPECT_EQ(valueOf("1/3*3"), 1);
    EXPECT_EQ(valueOf("-2*(1 + 3)/4"), -2);
    EXPECT_EQ(valueOf("2*-3"), -6);
    EXPECT_EQ(valueOf("--2"), 2);
}

TEST(Arithmetic, readsNothingElse) {
    for (const auto* text : {"", " ", "x", "3+", "(1", "1)", "1 2", "1,5", "1/0", "nan", "inf",
                             "0x10", "1e999", "*2", "()"}) {
        EXPECT_FALSE(valueOf(text)) << '"' << text << '"';
    }
    EXPECT_FALSE(valueOf(std::string(1000, '(') + "1" + std::string(1000, ')')))
        << "too deep, but no crash";
    EXPECT_EQ(valueOf("((((1))))"), 1);
}

} // namespace
} // namespace splineloft::ui
