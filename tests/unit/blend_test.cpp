#include "core/spline/blend.h"

#include <gtest/gtest.h>

namespace splineloft {
namespace {

TEST(Blend, isASparseSumOrderedByControl) {
    const Blend blend = 0.25 * Blend::of(7) + 0.5 * Blend::of(2) + 0.25 * Blend::of(7);
    ASSERT_EQ(blend.shares().size(), 2u);
    EXPECT_EQ(blend.shares()[0], (Share{2, 0.5}));
    EXPECT_EQ(blend.shares()[1], (Share{7, 0.5}));
    EXPECT_EQ(blend.weight(2), 0.5);
    EXPECT_EQ(blend.weight(3), 0);
    EXPECT_EQ(blend.weight(100), 0);
}

TEST(Blend, dropsWhatCancels) {
    const Blend one = Blend::of(1) + Blend::of(4);
    EXPECT_EQ(one - Blend::of(4), Blend::of(1));
    EXPECT_EQ(one - one, Blend());
    EXPECT_EQ(0.0 * one, Blend());
}

TEST(Blend, sumsWeightsBelowAControl) {
    const Blend blend = 2.0 * Blend::of(0) - Blend::of(3) + 5.0 * Blend::of(9);
    EXPECT_EQ(blend.sumBelow(10), 6);
    EXPECT_EQ(blend.sumBelow(9), 1);
    EXPECT_EQ(blend.sumBelow(0), 0);
    EXPECT_EQ(Blend().sumBelow(3), 0);
}

TEST(Blend, isLinear) {
    const Blend a = 3.0 * Blend::of(1) + 2.0 * Blend::of(2);
    const Blend b = Blend::of(2) - 4.0 * Blend::of(5);
    EXPECT_EQ(2.0 * (a + b), 2.0 * a + 2.0 * b);
    EXPECT_EQ(a + b, b + a);
    EXPECT_EQ(a - b, a + -1.0 * b);
}

TEST(Lerp, isExactAtBothEnds) {
    for (const double a : {0.1, -7.3, 1e300}) {
        for (const double b : {0.3, 5.9, -1e-300}) {
            EXPECT_EQ(lerp(a, b, 0.0), a);
            EXPECT_EQ(lerp(a, b, 1.0), b);
        }
    }
    EXPECT_EQ(lerp(Blend::of(3), Blend::of(4), 0.0), Blend::of(3));
    EXPECT_EQ(lerp(Blend::of(3), Blend::of(4), 1.0), Blend::of(4));
}

} // namespace
} // namespace splineloft
