// Moving points: what goes along with them, and to which digits.
#include "core/document/edits.h"

#include "tests/unit/edited_curves.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

namespace splineloft {
namespace {

using namespace testing_curves;

/// Sums of coordinates of some hundreds, when rounded to 14 digits.
constexpr double digits = 5e-12;

TEST(MovePoints, leavesNoDustOfBinaryFractions) {
    Curve curve = emptyCurve({"cardinal", false, Ends::doubled}, 2);
    curve.points = {{0.1, 0.7}, {3, 4}};
    const Document after =
        movePoints(besideBystander(curve), std::vector<PointId>{{0, 0}}, {0.2, 0.1});
    EXPECT_EQ(firstOf(after).points.at(0), Point({0.3, 0.8}));
}

TEST(MovePoints, movesThoseByTheTotalAndNoOthers) {
    const Document before = besideBystander(planeCurve("cardinal", 6));
    const std::vector<PointId> ids = {{0, 1}, {0, 4}};
    const Document after = movePoints(before, ids, {3, -5});
    expectPlausible(before, after, "move");
    for (std::size_t i = 0; i < 6; ++i) {
        const Point was = firstOf(before).points.at(i);
        if (i == 1 || i == 4) {
            expectNear(firstOf(after).points.at(i), was + Point{3, -5}, digits, std::to_string(i));
        } else {
            EXPECT_EQ(firstOf(after).points.at(i), was) << i;
        }
    }
    EXPECT_EQ(movePoints(before, ids, {0, 0}), before) << "no way is no change";
    EXPECT_EQ(movePoints(before, {}, {3, -5}), before);
}

TEST(MovePoints, namedTwiceMovesOnce) {
    const Document before = besideBystander(planeCurve("cardinal", 4));
    const std::vector<PointId> twice = {{0, 2}, {0, 2}};
    EXPECT_EQ(movePoints(before, twice, {3, -5}),
              movePoints(before, std::vector<PointId>{{0, 2}}, {3, -5}));
}

TEST(MovePoints, leavesOutCoordinatesThatACurveLacks) {
    Document document = besideBystander(planeCurve("cardinal", 4));
    Curve flat = emptyCurve({"cardinal", false, Ends::doubled}, 1);
    flat.points = {{3}, {8}};
    document.curves[0] = std::make_shared<Curve>(flat);
    const Document after = movePoints(document, std::vector<PointId>{{0, 1}}, {3, -5});
    EXPECT_EQ(firstOf(after).points.at(1), Point{11});
}

TEST(MovePoints, movesTipsOfTangents) {
    const Document before = besideBystander(planeCurve("hermite", 4));
    const std::vector<PointId> tip = {{0, 2, Part::tangent}};
    const Document after = movePoints(before, tip, {3, -5});
    EXPECT_EQ(firstOf(after).points, firstOf(before).points);
    expectNear(firstOf(after).tangents.at(2), firstOf(before).tangents.at(2) + Point{3, -5}, digits,
               "tip");
}

TEST(MovePoints, anAnchorTakesItsHandlesWithIt) {
    const Document before = besideBystander(smoothBezierSpline());
    const Document after = movePoints(before, std::vector<PointId>{{0, 3}}, {7, 9});
    for (std::size_t i = 0; i < 7; ++i) {
        const Point was = firstOf(before).points.at(i);
        EXPECT_EQ(firstOf(after).points.at(i), i >= 2 && i <= 4 ? was + Point({7, 9}) : was) << i;
    }
}

TEST(MovePoints, aHandleTurnsItsPartnerAlong) {
    const Document before = besideBystander(smoothBezierSpline());
    // From (110, 56) to (113, 55): below the anchor, so the partner ends up above it, as far as
    // ever.
    const Document after = movePoints(before, std::vector<PointId>{{0, 2}}, {3, -1});
    expectNear(firstOf(after).points.at(2), {113, 55}, 0, "the handle itself");
    expectNear(firstOf(after).points.at(4), {113, 70}, 1e-12, "its partner");
    EXPECT_EQ(firstOf(after).points.at(3), Point({113, 60}));
}

TEST(MovePoints, aHandleOfACornerMovesAlone) {
    Curve curve = smoothBezierSpline();
    curve.points.set(4, {113, 68});
    const Document before = besideBystander(curve);
    const Document after = movePoints(before, std::vector<PointId>{{0, 2}}, {3, -1});
    EXPECT_EQ(firstOf(after).points.at(4), Point({113, 68}));
}

TEST(MovePoints, leavesFourteenDigits) {
    // As read back from their decimals, of sums of any size.
    std::mt19937_64 engine(4);
    const auto random = [&] { return static_cast<double>(engine() >> 11) * 0x1p-53 - 0.5; };
    for (int k = 0; k < 20'000; ++k) {
        const double size = std::pow(10.0, static_cast<int>(engine() % 26) - 16);
        const double a = k % 3 == 0 ? std::round(1e5 * random()) / 1e3 : size * random();
        const double b = k % 3 == 0 ? std::round(1e5 * random()) / 1e3 : size * random();
        Curve curve = planeCurve("cardinal", 4);
        curve.points.set(0, {a, 1});
        const Document after =
            movePoints(besideBystander(curve), std::vector<PointId>{{0, 0}}, {b, 0});
        std::array<char, 40> text{};
        std::snprintf(text.data(), text.size(), "%.13e", a + b);
        EXPECT_EQ(after.curves[0]->points[0][0], b == 0 ? a : std::strtod(text.data(), nullptr))
            << text.data();
    }
}

} // namespace
} // namespace splineloft
