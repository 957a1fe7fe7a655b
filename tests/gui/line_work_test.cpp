// Very many pieces and points: what is in view is drawn, in bounded work, and nothing else.
#include "driver.h"
#include "hand.h"

#include "ui/canvas/illustrate.h"
#include "ui/canvas/line_work.h"
#include "ui/packing.h"
#include "ui/revisions.h"

#include <gtest/gtest.h>

#include <cmath>

namespace splineloft::ui {
namespace {

constexpr std::size_t many = 100'000;

/// A winding line of many points, from left to right over 1000 units.
Curve winding(std::string_view family, std::size_t count = many) {
    Curve curve = curveOf(family);
    curve.points = Points(2);
    for (std::size_t i = 0; i < count; ++i) {
        const double part = static_cast<double>(i) / static_cast<double>(count);
        curve.points.append(Point{1000 * part, 100 * std::sin(31 * part)});
    }
    return curve;
}

std::size_t piecesIn(const PieceStroke& stroke) {
    std::size_t count = 0;
    for (const auto& run : stroke.runs) {
        count += run.last - run.first;
    }
    return count;
}

std::size_t segmentsIn(const PieceStroke& stroke) {
    std::size_t count = 0;
    for (const auto& run : stroke.runs) {
        const auto pieces = run.last - run.first;
        count += run.step > 1 ? (pieces + run.step - 1) / run.step : pieces * run.segments;
    }
    return count;
}

TEST(LineWork, leavesManyPiecesToTheRendererAndLaysOutFew) {
    for (const auto* family : {"catmull-rom", "b-spline", "linear"}) {
        Driver driver(documentOf({winding(family)}));
        const auto& strokes = driver.result.pictures.front().pieces;
        ASSERT_EQ(strokes.size(), 2U) << "curve and polygon of " << family;
        for (const auto& stroke : strokes) {
            EXPECT_NEAR(static_cast<double>(piecesIn(stroke)), many, 3) << family;
            EXPECT_LT(segmentsIn(stroke), 20'000U) << "more than the screen has pixels";
        }
        EXPECT_LT(driver.result.pictures.front().ribbons.size(), 2000U) << family;
        EXPECT_LT(driver.result.pictures.front().signs.size(), 2500U) << family;

        driver.session.view.camera = {{500, 100 * std::sin(31 * 0.5)}, 3000};
        driver.frames(2);
        EXPECT_TRUE(driver.result.pictures.front().pieces.empty()) << family;
        EXPECT_GT(driver.result.pictures.front().signs.size(), 5U) << family;
        EXPECT_LT(driver.result.pictures.front().signs.size(), 100U) << family;
        EXPECT_EQ(driver.faults(), "");
    }
}

TEST(LineWork, segmentsFollowTheBendWithinATenthOfAPixel) {
    Curve curve = winding("cardinal", 2000);
    const Pieces pieces = piecesOf(curve);
    const PlaneStudy plane(curve, pieces, {});
    for (const double pixelsPerUnit : {0.05, 0.9, 7.0, 60.0}) {
        Scene scene;
        const Viewport viewport{{{500, 0}, pixelsPerUnit}, {0, 0, 900, 700}};
        drawCurve(scene, plane, false, {Role::curve}, viewport);
        for (const auto& drawn : scene.pieces) {
            for (const auto& run : drawn.stroke.runs) {
                for (auto i = run.first; i + run.step <= run.last; i += run.step) {
                    const auto last = i + run.step - 1;
                    const double h = 1.0 / static_cast<double>(run.segments);
                    const Point a = pieces.position({i, 0});
                    const Point b =
                        run.step > 1 ? pieces.position({last, 1}) : pieces.position({i, h});
                    const Point middle = run.step > 1 ? pieces.position({(i + last) / 2, 0.5})
                                                      : pieces.position({i, h / 2});
                    const double off = pixelsPerUnit * distance(middle, 0.5 * (a + b));
                    EXPECT_LE(off, run.step > 1 ? 0.5 : 0.1) << pixelsPerUnit << " piece " << i;
                }
            }
        }
    }
}

TEST(LineWork, drawsLegsThatOnlyCrossTheView) {
    Curve curve = winding("linear", 5000);
    for (std::size_t i = 0; i < curve.points.size(); ++i) { // far left, far right, in turn
        curve.points.set(i, {(i / 64) % 2 == 0 ? -1e4 : 1e4, 0.001 * static_cast<double>(i)});
    }
    const Pieces pieces = piecesOf(curve);
    const PlaneStudy plane(curve, pieces, {});
    Scene scene;
    drawPolygon(scene, plane, false, {Role::polygon}, {{{0, 2}, 100}, {0, 0, 900, 700}});
    std::size_t crossing = 0;
    for (const auto& drawn : scene.pieces) {
        crossing += piecesIn(drawn.stroke);
    }
    for (const auto& stroke : scene.strokes) {
        crossing += stroke.points.size();
    }
    EXPECT_GE(crossing, 5000U / 64) << "every 64th leg crosses the view";
}

TEST(LineWork, aDragTouchesOnlyTheBlocksOfItsPieces) {
    Driver driver(documentOf({winding("catmull-rom")}));
    const auto table = [&] { return driver.result.pictures.front().pieces.front().table; };
    const auto identity = table().revisions->identity();
    const ScreenPoint point = driver.atPoint(many / 2);
    driver.session.view.selection = {{0, many / 2, Part::point}};
    driver.press(point);
    driver.move({point.x + 5, point.y - 20});
    const auto before = table().revisions->revision();
    driver.move({point.x + 9, point.y - 41});
    EXPECT_EQ(table().revisions->identity(), identity) << "the renderer's copy still serves";
    std::size_t points = 0;
    for (const auto& blocks : table().revisions->since(before)) {
        points += pointsOf(table(), blocks).size();
    }
    EXPECT_GT(points, 0U);
    EXPECT_LE(points, 2 * 64 * 4U);
    driver.release();
    EXPECT_EQ(driver.faults(), "");
}

TEST(Packing, keepsFortyEightBits) {
    for (const double x : {1.0 / 3, 123456789.123456, -1e9 / 7, 5e-12, 0.0}) {
        const auto [high, rest] = split(x);
        EXPECT_NEAR(static_cast<double>(high) + static_cast<double>(rest), x,
                    std::abs(x) * 0x1p-47);
    }
    const std::vector<PlanePoint> places{{1.0 / 3, 2}, {3, 1e9 / 7}};
    const auto numbers = packed(places);
    ASSERT_EQ(numbers.size(), 8U);
    EXPECT_EQ(numbers[0], static_cast<float>(1.0 / 3));
    EXPECT_EQ(numbers[5], static_cast<float>(1e9 / 7));
    EXPECT_NE(numbers[2], 0);
}

} // namespace
} // namespace splineloft::ui
