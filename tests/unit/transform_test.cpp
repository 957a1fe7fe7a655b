// Maps of the plane, and selections mapped by them.
#include "core/document/edits.h"
#include "core/document/plane_map.h"

#include "tests/documents.h"
#include "tests/property/random_curves.h"

#include <cmath>
#include <numbers>

namespace splineloft {
namespace {

using namespace testing_curves;

constexpr double quarterTurn = std::numbers::pi / 2;

void expectNear(PlanePlace ours, PlanePlace wanted) {
    EXPECT_NEAR(ours.x, wanted.x, 1e-12);
    EXPECT_NEAR(ours.y, wanted.y, 1e-12);
}

TEST(PlaneMap, movesScalesAndTurnsToTheLeft) {
    expectNear(PlaneMap::moved(2, -3).apply({10, 20}), {12, 17});
    expectNear(PlaneMap::scaledAbout({10, 20}, 2, -1).apply({13, 24}), {16, 16});
    expectNear(PlaneMap::rotatedAbout({10, 20}, quarterTurn).apply({13, 24}), {6, 23});
    expectNear(PlaneMap::rotatedAbout({10, 20}, 0.7).apply({10, 20}), {10, 20});
    EXPECT_EQ(PlaneMap{}.apply({4, 5}), (PlanePlace{4, 5}));
    expectNear(PlaneMap::rotatedAbout({10, 20}, quarterTurn).applyLinear({3, 4}), {-4, 3});
}

TEST(PlaneMap, composesTheSecondAfterTheFirst) {
    const auto turn = PlaneMap::rotatedAbout({1, 2}, 0.4);
    const auto stretch = PlaneMap::scaledAbout({-3, 5}, 2, 0.5);
    for (const PlanePlace place : {PlanePlace{7, -1}, PlanePlace{0, 0}, PlanePlace{-4, 9}}) {
        expectNear(composed(stretch, turn).apply(place), stretch.apply(turn.apply(place)));
    }
}

TEST(TransformPoints, mapsTwoCoordinatesOfTheSelectedPoints) {
    Curve curve = emptyCurve({"cardinal", false, Ends::doubled}, 3);
    curve.points = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
    const auto turn = PlaneMap::rotatedAbout({4, 6}, quarterTurn);
    const Document after =
        transformPoints(documentOf(curve), std::vector<PointId>{{0, 0}, {0, 1}}, turn, 0, 2);
    EXPECT_EQ(firstOf(after).points, (Points{{7, 2, 3}, {4, 5, 6}, {7, 8, 9}}))
        << "rounded to 14 digits";
}

TEST(TransformPoints, leavesNoDustOfBinaryFractions) {
    Curve curve = emptyCurve({"cardinal", false, Ends::doubled}, 2);
    curve.points = {{0.1, 0.7}, {3, 4}};
    const auto map = PlaneMap::moved(0.2, 0.1);
    const std::vector<PointId> ids = {{0, 0}};
    EXPECT_EQ(firstOf(transformPoints(documentOf(curve), ids, map, 0, 1)).points.at(0),
              Point({0.3, 0.8}));
    EXPECT_EQ(transformPoints(documentOf(curve), ids, PlaneMap{}, 0, 1), documentOf(curve));
}

TEST(TransformPoints, doesWhatMovingDoes) {
    for (const auto& form : everyForm()) {
        Dice dice(5);
        Curve curve = emptyCurve(form, 2);
        rollPoints(curve, 7, {20, -7}, 9, dice);
        const Document before = documentOf(curve);
        const std::vector<PointId> ids = {{0, 3}, {0, 5}};
        EXPECT_EQ(transformPoints(before, ids, PlaneMap::moved(3, 0.5), 0, 1),
                  movePoints(before, ids, {3, 0.5}))
            << wordsOf(curve);
    }
}

TEST(TransformPoints, aCurveOfOneCoordinateFollowsUpAlone) {
    Curve curve = emptyCurve({"cardinal", false, Ends::doubled}, 1);
    curve.points = {{3}, {8}};
    const std::vector<PointId> ids = {{0, 0}, {0, 1}};
    const auto map = [&](const PlaneMap& by) {
        return firstOf(transformPoints(documentOf(curve), ids, by, 0, 1)).points;
    };
    EXPECT_EQ(map(PlaneMap::moved(7, 2)), (Points{{5}, {10}}));
    EXPECT_EQ(map(PlaneMap::scaledAbout({100, 8}, 5, 2)), (Points{{-2}, {8}}));
    EXPECT_EQ(map(PlaneMap::rotatedAbout({0, 8}, 0.3)), curve.points) << "it cannot turn";
}

TEST(TransformPoints, tangentsTurnWithTheirPoints) {
    Curve curve = emptyCurve({"hermite", false, Ends::none}, 2);
    curve.points = {{1, 2}, {4, 6}, {8, 1}};
    curve.tangents = {{3, 0}, {2, 2}, {5, -1}};
    const auto turn = PlaneMap::rotatedAbout({4, 6}, quarterTurn);
    const std::vector<PointId> ids = {{0, 0}, {0, 2, Part::tangent}};
    const Curve after = firstOf(transformPoints(documentOf(curve), ids, turn, 0, 1));
    EXPECT_EQ(after.points, (Points{{8, 3}, {4, 6}, {8, 1}}));
    EXPECT_EQ(after.tangents, (Points{{0, 3}, {2, 2}, {1, 5}}));
}

TEST(TransformPoints, handlesTurnWithTheirAnchors) {
    Curve curve = emptyCurve({"bezier-spline", false, Ends::none}, 2);
    curve.points = {{0, 0}, {1, 2}, {3, 4}, {4, 4}, {5, 5}, {8, 1}, {9, 0}};
    const auto turn = PlaneMap::rotatedAbout({4, 4}, quarterTurn);
    const Curve after =
        firstOf(transformPoints(documentOf(curve), std::vector<PointId>{{0, 3}}, turn, 0, 1));
    EXPECT_EQ(after.points, (Points{{0, 0}, {1, 2}, {4, 3}, {4, 4}, {3, 5}, {8, 1}, {9, 0}}));
}

} // namespace
} // namespace splineloft
