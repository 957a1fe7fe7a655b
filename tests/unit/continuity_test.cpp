// Joints made by hand: what is measured there, and in which words it is said.
#include "core/spline/continuity.h"

#include "core/spline/curve.h"
#include "core/spline/problem.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace splineloft {
namespace {

/// Two cubic pieces end to end over the given knots.
Joint jointOf(const std::vector<Point>& bezier, std::vector<double> knots = {0, 1, 2}) {
    std::vector<double> coordinates;
    for (const auto& p : bezier) {
        coordinates.insert(coordinates.end(), p.coordinates().begin(), p.coordinates().end());
    }
    const Pieces pieces(3, bezier[0].dimension(), KnotLine(std::move(knots)), coordinates);
    const auto joints = jointsOf(pieces, false);
    EXPECT_EQ(joints.size(), 1u);
    return joints.front();
}

const std::vector<Point> first = {{100, 50}, {101, 50}, {102, 51}, {104, 53}};

std::vector<Point> followedBy(const std::vector<Point>& after) {
    auto both = first;
    both.insert(both.end(), after.begin(), after.end());
    return both;
}

TEST(Joint, gap) {
    const Joint joint = jointOf(followedBy({{104, 57}, {106, 55}, {109, 58}, {110, 50}}));
    EXPECT_EQ(joint.c, -1);
    EXPECT_EQ(joint.g, -1);
    EXPECT_DOUBLE_EQ(joint.gap, 4);
    EXPECT_EQ(describe(joint), "broken: a gap of 4");
}

TEST(Joint, corner) {
    // Arrives along (2, 2), leaves along (-2, 2): a quarter turn.
    const Joint joint = jointOf(followedBy({{104, 53}, {102, 55}, {109, 58}, {110, 50}}));
    EXPECT_EQ(joint.c, 0);
    EXPECT_EQ(joint.g, 0);
    EXPECT_NEAR(joint.turn, std::numbers::pi / 2, 1e-14);
    EXPECT_DOUBLE_EQ(joint.firstJump, 12);
    EXPECT_EQ(describe(joint), "C⁰, a corner: the direction turns by 90°");
}

TEST(Joint, sameWayAtAnotherSpeed) {
    const Joint joint = jointOf(followedBy({{104, 53}, {110, 59}, {109, 50}, {110, 50}}));
    EXPECT_EQ(joint.c, 0);
    EXPECT_EQ(joint.g, 1);
    EXPECT_NEAR(joint.speedRatio, 3, 1e-14);
    EXPECT_NE(describe(joint).find("factor 3"), std::string::npos) << describe(joint);
}

TEST(Joint, speedIsByTheParameterNotByThePiece) {
    // Three times the handle over three times the interval.
    const auto bezier = followedBy({{104, 53}, {110, 59}, {109, 58}, {110, 50}});
    const Joint joint = jointOf(bezier, {5, 6, 9});
    EXPECT_EQ(joint.c, 1);
    EXPECT_NEAR(joint.speedRatio, 1, 1e-14);
    EXPECT_EQ(joint.t, 6);
    EXPECT_EQ(joint.before, 0u);
    EXPECT_EQ(joint.after, 1u);
}

TEST(Joint, aPieceCutInTwoIsSmooth) {
    const std::vector<Point> whole = {{100, 50}, {104, 58}, {112, 58}, {116, 42}};
    const Ladder<Point> ladder(whole, 0.25);
    const std::vector<Point> halves = {ladder.level(0)[0], ladder.level(1)[0], ladder.level(2)[0],
                                       ladder.tip(),       ladder.tip(),       ladder.level(2)[1],
                                       ladder.level(1)[2], ladder.level(0)[3]};
    const Joint byLength = jointOf(halves, {0, 0.25, 1});
    EXPECT_EQ(byLength.c, 2) << describe(byLength);
    EXPECT_EQ(byLength.g, 2);
    EXPECT_EQ(describe(byLength), "C²");
    const Joint evenly = jointOf(halves);
    EXPECT_EQ(evenly.c, 0) << "at the same pace by piece, the speed jumps";
    EXPECT_EQ(evenly.g, 2) << describe(evenly);
    EXPECT_NEAR(evenly.speedRatio, 3, 1e-13);
}

TEST(Joint, atRestInACorner) {
    const std::vector<Point> bezier = {{100, 50}, {101, 50}, {104, 53}, {104, 53},
                                       {104, 53}, {104, 53}, {103, 58}, {110, 50}};
    const Joint joint = jointOf(bezier);
    EXPECT_EQ(joint.c, 1);
    EXPECT_EQ(joint.g, 0);
    EXPECT_NE(describe(joint).find("rest"), std::string::npos) << describe(joint);
}

TEST(Joint, ofAClosedCurveComesLast) {
    const Pieces pieces(1, 2, KnotLine({0, 1, 2, 3}), {5, 5, 9, 5, 9, 5, 7, 8, 7, 8, 5, 5});
    const auto joints = jointsOf(pieces, true);
    ASSERT_EQ(joints.size(), 3u);
    EXPECT_EQ(joints.back().t, 3);
    EXPECT_EQ(joints.back().before, 2u);
    EXPECT_EQ(joints.back().after, 0u);
    EXPECT_EQ(joints.back().c, 0);
    EXPECT_TRUE(jointsOf(Pieces(), true).empty());
}

TEST(Joint, curvatureJumps) {
    // The same tangent, straight before and bent after by 2/3 * 6 / 6^2 of the cross product.
    const std::vector<Point> bezier = {{10, 20}, {12, 20}, {14, 20}, {16, 20},
                                       {16, 20}, {18, 20}, {20, 23}, {21, 30}};
    const Joint joint = jointOf(bezier);
    EXPECT_EQ(joint.g, 1);
    // |P' x P''| / |P'|^3 with P' = (6, 0) and P'' = 6 ((20, 23) - 2 (18, 20) + (16, 20)) = (0,
    // 18).
    EXPECT_NEAR(joint.curvatureJump, 0.5, 1e-14);
}

/// Two parabolas of a B-spline with the knots 0, 0, 0, k / 2, k, k, k.
Joint jointOverInterval(double k) {
    Curve curve;
    curve.family = "b-spline";
    curve.parameters["degree"] = 2;
    curve.coordinates = {"x", "y"};
    curve.points = Points{{1, 0}, {1, 3}, {2, 2}, {4, 1}};
    curve.ends = Ends::none;
    curve.knots = {0, 0, 0, k / 2, k, k, k};
    EXPECT_FALSE(problemOf(curve)) << problemOf(curve)->what;
    const auto joints = jointsOf(piecesOf(curve), false);
    EXPECT_EQ(joints.size(), 1u);
    return joints.front();
}

TEST(Joint, isAsSmoothWhateverTheUnitOfT) {
    // By u, P' = (1, -1), and P'' = (1, -7) before and (3, -1) after: P' x P'' is -6, then 2, and
    // |P'|^3 is sqrt(8).
    for (const double k : {1e-300, 1e-160, 1e-150, 1e-9, 1.0, 2.0, 1e9, 1e160, 1e200, 1e300}) {
        const Joint joint = jointOverInterval(k);
        EXPECT_EQ(joint.c, 1) << k;
        EXPECT_EQ(joint.g, 1) << k;
        EXPECT_NEAR(joint.curvatureJump, 8 / std::sqrt(8), 1e-14) << k;
        EXPECT_NEAR(joint.speedRatio, 1, 1e-14) << k;
        EXPECT_FALSE(joint.atRest) << k;
    }
}

TEST(Joint, saysWhenAJumpByTIsNoNumber) {
    EXPECT_EQ(describe(jointOverInterval(1e-300)),
              "C¹: the second derivative jumps by more than any number");
    EXPECT_EQ(describe(jointOverInterval(1e300)),
              "C¹: the second derivative jumps by less than any number");
}

} // namespace
} // namespace splineloft
