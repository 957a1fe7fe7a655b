// The badges of ordinary curves.
#include "core/spline/traits.h"

#include "tests/property/random_curves.h"

namespace splineloft {
namespace {

using namespace testing_curves;

Traits measured(const Curve& curve) {
    return traitsOf(curve, piecesOf(curve), blendsOf(curve));
}

/// Nine scattered points.
Curve scattered(const std::string& family, bool closed = false) {
    Dice dice(21);
    Curve curve = emptyCurve({family, closed, formsOf(family).front().ends}, 2);
    rollPoints(curve, 9, {300, -200}, 10, dice);
    return curve;
}

struct Wanted {
    std::string family;
    bool throughAll, throughEnds, inHull;
    std::size_t reach;
};

TEST(Traits, ofTheFamilies) {
    const std::vector<Wanted> all = {
        {"linear", true, true, true, 2},       {"bezier", false, true, true, 1},
        {"hermite", true, true, false, 2},     {"cardinal", true, true, false, 4},
        {"catmull-rom", true, true, false, 4}, {"natural", true, true, false, 8},
        {"b-spline", false, false, true, 4},   {"duff", false, false, true, 4},
        {"beta", false, false, true, 4},
    };
    for (const auto& wanted : all) {
        const Traits traits = measured(scattered(wanted.family));
        EXPECT_EQ(traits.throughAll, wanted.throughAll) << wanted.family;
        EXPECT_EQ(traits.throughEnds, wanted.throughEnds) << wanted.family;
        EXPECT_EQ(traits.inHull, wanted.inHull) << wanted.family;
        EXPECT_EQ(traits.reach, wanted.reach) << wanted.family;
        EXPECT_TRUE(traits.affine) << wanted.family;
        EXPECT_EQ(traits.global, wanted.family == "natural" || wanted.family == "bezier")
            << wanted.family;
    }
}

TEST(Traits, clampedBSplineGoesThroughItsEndsAlone) {
    Curve curve = scattered("b-spline");
    curve.ends = Ends::clamped;
    const Traits traits = measured(curve);
    EXPECT_TRUE(traits.throughEnds);
    EXPECT_FALSE(traits.throughAll);
    EXPECT_TRUE(traits.onCurve.front() && traits.onCurve.back());
    EXPECT_FALSE(traits.onCurve[4]);
}

TEST(Traits, bezierSplinePassesThroughItsAnchors) {
    Curve curve = scattered("bezier-spline");
    curve.points.append({290, -190});
    const Traits traits = measured(curve);
    for (std::size_t i = 0; i < traits.onCurve.size(); ++i) {
        EXPECT_EQ(traits.onCurve[i], i % 3 == 0) << i;
    }
}

TEST(Traits, openEndsPassByTheirEndPoints) {
    Curve curve = scattered("cardinal");
    curve.ends = Ends::open;
    const Traits traits = measured(curve);
    EXPECT_FALSE(traits.onCurve.front());
    EXPECT_TRUE(traits.onCurve[1]);
    EXPECT_FALSE(traits.throughEnds);
}

TEST(Traits, ofTooFewPointsAreNone) {
    Curve curve = emptyCurve({"cardinal", false, Ends::doubled}, 2);
    curve.points.append({3, 4});
    const Traits traits = measured(curve);
    EXPECT_FALSE(traits.throughAll || traits.throughEnds || traits.inHull || traits.global);
    EXPECT_EQ(traits.onCurve.size(), 1u);
    EXPECT_TRUE(traits.joints.empty());
}

/// Cardinal splines of tension 0 are straight, uneven in pace, and stay in the hull.
TEST(Traits, areMeasuredNotDeclared) {
    Curve curve = scattered("cardinal");
    curve.parameters["tension"] = 0;
    EXPECT_TRUE(measured(curve).inHull);
    EXPECT_EQ(measured(curve).reach, 2u);
    curve.parameters["tension"] = 0.01;
    EXPECT_FALSE(measured(curve).inHull);
    Curve duff = scattered("duff");
    duff.parameters["tension"] = 0;
    EXPECT_TRUE(measured(duff).throughAll) << "tightened onto the polygon";
}

} // namespace
} // namespace splineloft
