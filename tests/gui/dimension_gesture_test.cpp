// Curves of one, three and six coordinates, and several curves of different ones at once.
#include "hand.h"

#include "core/document/edits.h"
#include "core/spline/catalog.h"

#include <gtest/gtest.h>

namespace splineloft::ui {
namespace {

TEST(DimensionGesture, onAGraphAPointOnlyMovesUpAndDown) {
    for (const auto& family : catalog()) {
        Hand hand(documentOf({curveOf(family.id, 1)}));
        const PlanePoint from = hand.place(3);
        hand.drag(from, {from.x + 1, 2});
        EXPECT_EQ(hand.curve().points.at(3), Point{2}) << family.id;
        EXPECT_EQ(hand.steps(), 1) << family.id;
    }
}

TEST(DimensionGesture, aDragMovesOnlyTheTwoCoordinatesThatAreShown) {
    for (const int dimension : {3, 6}) {
        for (const Axes axes : {Axes{0, 1}, Axes{0, 2}, Axes{2, 1}, Axes{1, dimension - 1}}) {
            Hand hand(documentOf({curveOf("cardinal", dimension)}));
            hand.session.view.axes = axes;
            const Point before = hand.curve().points.at(4);
            const PlanePoint from = hand.place(4);
            hand.drag(from, {from.x + 0.5, from.y - 0.25});
            Point wanted = before;
            wanted[axes.across] += 0.5;
            wanted[axes.up] -= 0.25;
            EXPECT_LE(distance(hand.curve().points.at(4), wanted), 1e-12)
                << dimension << " coordinates, axes " << axes.across << " " << axes.up;
        }
    }
}

TEST(DimensionGesture, axesThatACurveLacksShowItsLastCoordinate) {
    Hand hand(documentOf({curveOf("cardinal")}));
    hand.session.view.axes = {0, 4};
    const PlanePoint from = hand.place(2);
    hand.drag(from, {from.x + 0.5, from.y + 0.25});
    EXPECT_LE(distance(hand.curve().points.at(2), Point{0.75, -0.25}), 1e-12);
}

TEST(DimensionGesture, selectedPointsOfDifferentSpacesMoveAlikeOnTheCanvas) {
    Curve low = curveOf("cardinal", 1);
    for (std::size_t i = 0; i < low.points.size(); ++i) {
        low.points.set(i, low.points.at(i) + Point{6}); // out of the others' way
    }
    for (const std::size_t grabbed : {0, 1, 2}) {
        Hand hand(documentOf({low, curveOf("cardinal"), curveOf("cardinal", 3)}));
        hand.session.view.axes = {0, 2};
        hand.session.view.activeCurve = grabbed;
        hand.session.view.selection = {{0, 1}, {1, 4}, {2, 4}};
        std::vector<PlanePoint> before;
        for (const auto& id : hand.session.view.selection) {
            before.push_back(hand.place(id.index, id.curve));
        }
        const PlanePoint from = before[grabbed];
        hand.drag(from, {from.x + 0.5, from.y + 0.25});
        for (std::size_t k = 0; k < 3; ++k) {
            const PlanePoint now = hand.place(k == 0 ? 1 : 4, k);
            EXPECT_NEAR(now.x - before[k].x, k == 0 ? 0 : 0.5, 1e-12)
                << "curve " << k << " with curve " << grabbed << " in hand";
            EXPECT_NEAR(now.y - before[k].y, 0.25, 1e-12)
                << "curve " << k << " with curve " << grabbed << " in hand";
        }
        EXPECT_EQ(hand.steps(), 1);
    }
}

TEST(DimensionGesture, arrowsMovePointsOfDifferentSpacesAlike) {
    Hand hand(documentOf({curveOf("cardinal", 1), curveOf("cardinal"), curveOf("cardinal", 3)}));
    hand.session.view.selection = {{0, 1}, {1, 4}, {2, 4}};
    const Document before = hand.session.document();
    hand.key(Key::up, withShift);
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t i = k == 0 ? 1 : 4;
        const Point way = hand.curve(k).points.at(i) - before.curves[k]->points.at(i);
        EXPECT_GT(way[k == 0 ? 0 : 1], 0) << "curve " << k;
        if (k > 0) {
            EXPECT_EQ(way[0], 0) << "curve " << k;
        }
    }
}

TEST(DimensionGesture, thePenWorksInEverySpace) {
    for (const auto& family : catalog()) {
        for (const int dimension : {1, 3, 6}) {
            Hand hand(documentOf({curveOf(family.id, dimension)}));
            hand.key(Key::p);
            hand.drag({-1, 2}, {-0.5, 2.75});
            const auto n = hand.curve().points.size();
            EXPECT_EQ(n, family.hasHandles ? 10U : 8U) << family.id << dimension;
            EXPECT_EQ(hand.curve().points.at(n - 1)[dimension == 1 ? 0 : 1], 2) << family.id;
            EXPECT_FALSE(problemOf(hand.session.document())) << family.id << dimension;
        }
    }
}

TEST(DimensionGesture, insertingWorksInEverySpace) {
    for (const auto& family : catalog()) {
        for (const int dimension : {1, 3, 6}) {
            Hand hand(documentOf({curveOf(family.id, dimension)}));
            const PlanePoint at = hand.placeAt({hand.session.studies[0].pieces().size() / 2, 0.4});
            const auto n = hand.curve().points.size();
            hand.doubleClick(at);
            EXPECT_GT(hand.curve().points.size(), n) << family.id << dimension;
            EXPECT_FALSE(problemOf(hand.session.document())) << family.id << dimension;
        }
    }
}

TEST(DimensionGesture, aTangentOfAGraphIsItsSlope) {
    Hand hand(documentOf({curveOf("hermite", 1)}));
    const PlanePoint anchor = hand.place(2);
    const PlanePoint tip{anchor.x + 1.0 / 3, anchor.y + 1.0 / 3};
    hand.drag(tip, {tip.x + 0.6, anchor.y + 1});
    EXPECT_LE(distance(hand.curve().tangents.at(2), Point{3}), 0.031);
}

} // namespace
} // namespace splineloft::ui
