// Refusals in the words of the window.
#include "ui/refusal.h"

#include "hand.h"

#include <gtest/gtest.h>

namespace splineloft::ui {
namespace {

TEST(Refusals, nameThePlaceAsTheWindowDoes) {
    Curve curve = curveOf("hermite");
    curve.coordinates = {"x", "height"};
    const Document document = documentOf({curve, curveOf("kochanek-bartels")});
    const auto place = [&](const char* pointer) {
        const auto words = refusalOf("Set it", {pointer, "|", ""}, document);
        return words.substr(0, words.find(" |"));
    };
    const std::string refused = "Set it is not possible: ";
    EXPECT_EQ(place("/curves/0/points/2/1"), refused + "height of P₂");
    EXPECT_EQ(place("/curves/0/points/2"), refused + "P₂");
    EXPECT_EQ(place("/curves/0/points"), refused + "points");
    EXPECT_EQ(place("/curves/0/tangents/1/0"), refused + "x of the tangent at P₁");
    EXPECT_EQ(place("/curves/1/parameters/tension"), refused + "Tension");
    EXPECT_EQ(place("/curves/1/local/tension/6"), refused + "Tension of P₆");
    EXPECT_EQ(place("/curves/1/weights/3"), refused + "weight of P₃");
    EXPECT_EQ(place("/curves/1/knots/3"), refused + "knots");
    EXPECT_EQ(place("/curves/1/family"), refused + "family");
    EXPECT_EQ(place("/curves/7/points"), refused + "/curves/7/points") << "there is no such curve";
    EXPECT_EQ(place("/curves/0/points/70"), refused + "points");
}

} // namespace
} // namespace splineloft::ui
