// Strokes along pieces, which the renderer lays out by itself, look as the same strokes laid out
// beforehand; near and far, wherever on the plane, and after some of the points have moved.
#include "app/image.h"
#include "app/offscreen.h"
#include "app/renderer.h"
#include "ui/canvas/line_work.h"
#include "ui/canvas/outline.h"
#include "ui/frame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace splineloft {
namespace {

constexpr int frameWidth = 400, frameHeight = 300; // pixels
constexpr ui::ScreenRect frame{0, 0, frameWidth, frameHeight};
constexpr ui::Colour lineColour{255, 255, 255, 255};

/// A wavy line of so many points, `offset` away from the origin.
Curve wavy(std::string_view family, std::size_t count, double offset = 0) {
    Curve curve;
    curve.family = family;
    completeParameters(curve);
    curve.ends = familyOf(curve).ends.front();
    for (std::size_t i = 0; i < count; ++i) {
        const auto k = static_cast<double>(i);
        curve.points.append({offset + 0.1 * k, offset + 20 * std::sin(0.013 * k) + std::sin(k)});
    }
    return curve;
}

ui::Picture pictureOf(std::vector<ui::PieceStroke> pieces) {
    ui::Picture picture{.frame = frame, .background = {0, 0, 0, 255}};
    picture.pieces = std::move(pieces);
    return picture;
}

/// The parts of pixels that differ noticeably, and the mean brightness of both.
struct Comparison {
    double differing = 0;
    double brightness = 0, otherBrightness = 0;
};

Comparison compared(const app::Image& a, const app::Image& b) {
    Comparison result;
    const double pixels = frameWidth * frameHeight;
    for (int y = 0; y < frameHeight; ++y) {
        for (int x = 0; x < frameWidth; ++x) {
            const int one = a.pixel(x, y)[0];
            const int other = b.pixel(x, y)[0];
            result.differing += std::abs(one - other) > 40 ? 1 / pixels : 0;
            result.brightness += one / 255.0 / pixels;
            result.otherBrightness += other / 255.0 / pixels;
        }
    }
    return result;
}

class PieceStrokes : public testing::Test {
  protected:
    app::Image draw(const ui::Picture& picture) {
        ui::FrameResult result;
        result.background = {0, 0, 0, 255};
        result.pictures.push_back(picture);
        return app::drawOffscreen(renderer_, result, {frameWidth, frameHeight, 1});
    }

    /// The curve as runs of pieces; `more` strokes may be wanted of the plane.
    app::Image drawPieces(const ui::PlaneStudy& plane, const ui::Viewport& viewport,
                          const ui::StrokeStyle& style) {
        ui::Scene scene;
        ui::drawCurve(scene, plane, false, {}, viewport);
        EXPECT_EQ(scene.pieces.size(), 1U) << "few enough to be laid out";
        EXPECT_TRUE(scene.strokes.empty());
        std::vector<ui::PieceStroke> strokes;
        for (auto& drawn : scene.pieces) {
            drawn.stroke.style = style;
            strokes.push_back(std::move(drawn.stroke));
        }
        return draw(pictureOf(std::move(strokes)));
    }

    app::Image drawLaidOut(const ui::PlaneStudy& plane, const ui::Viewport& viewport,
                           const ui::StrokeStyle& style) {
        auto picture = pictureOf({});
        ui::addStroke(picture, ui::outline(plane.pieces(), viewport), style);
        return draw(picture);
    }

  private:
    app::OffscreenContext context_;
    app::Renderer renderer_;
};

TEST_F(PieceStrokes, lookLikeStrokesLaidOut) {
    for (const auto* family : {"catmull-rom", "b-spline", "linear"}) {
        for (const double offset : {0.0, 123'456.0}) {
            const Curve curve = wavy(family, 4000, offset);
            const Pieces pieces = piecesOf(curve);
            const ui::PlaneStudy plane(curve, pieces, {});
            for (const double pixelsPerUnit : {0.5, 1.0, 4.0}) {
                const ui::Viewport viewport{{{offset + 200.03, offset + 0.7}, pixelsPerUnit},
                                            frame};
                const ui::StrokeStyle style{3, 0, 0, lineColour};
                const auto found = compared(drawPieces(plane, viewport, style),
                                            drawLaidOut(plane, viewport, style));
                EXPECT_GT(found.brightness, 0.005) << family;
                EXPECT_LT(found.differing, 0.002)
                    << family << ' ' << offset << ' ' << pixelsPerUnit;
                EXPECT_NEAR(found.brightness, found.otherBrightness, 0.01 * found.brightness)
                    << family << ' ' << pixelsPerUnit;
            }
        }
    }
}

TEST_F(PieceStrokes, areCrispInASmallPartOfAFarAwayPlane) {
    // A thousand pieces within a thousandth of a unit, a hundred million units from the origin:
    // floats alone would lie 8 units apart there.
    Curve curve = wavy("cardinal", 1000);
    const double offset = 1e6;
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
        curve.points.set(i,
                         {offset + 1e-5 * curve.points[i][0], offset + 1e-5 * curve.points[i][1]});
    }
    const Pieces pieces = piecesOf(curve);
    const ui::PlaneStudy plane(curve, pieces, {});
    const ui::Viewport viewport{{{offset + 50e-5, offset}, 3e5}, frame};
    const ui::StrokeStyle style{2, 0, 0, lineColour};
    const auto found =
        compared(drawPieces(plane, viewport, style), drawLaidOut(plane, viewport, style));
    EXPECT_GT(found.brightness, 0.005);
    EXPECT_LT(found.differing, 0.004);
}

TEST_F(PieceStrokes, followThePointsThatMove) {
    Curve curve = wavy("catmull-rom", 3000);
    LivePieces live(curve, curve.points, curve.tangents);
    ui::PlaneStudy plane(curve, live.pieces(), {});
    const ui::Viewport viewport{{{150.2, 0.3}, 1.2}, frame};
    const ui::StrokeStyle style{3, 0, 0, lineColour};
    drawPieces(plane, viewport, style);
    for (const std::size_t moved : {1500, 1563, 0, 2999}) {
        Curve next = curve;
        next.points.set(moved, {140.0 + 0.01 * static_cast<double>(moved), 90});
        const auto moves = movesBetween(curve, next);
        plane.follow(next, *moves, live.follow(next, *moves));
        curve = next;
        const auto found =
            compared(drawPieces(plane, viewport, style), drawLaidOut(plane, viewport, style));
        EXPECT_LT(found.differing, 0.002) << moved;
    }
}

TEST_F(PieceStrokes, ofTranslucentColourAreNoLessEven) {
    const Curve curve = wavy("b-spline", 4000);
    const Pieces pieces = piecesOf(curve);
    const ui::PlaneStudy plane(curve, pieces, {});
    const ui::Viewport viewport{{{90, 3}, 3}, frame};
    const ui::StrokeStyle style{5, 0, 0, {255, 255, 255, 128}};
    // Where a stroke is drawn twice it is brighter.
    const auto brighter = [](const app::Image& image) {
        int count = 0;
        for (int y = 0; y < frameHeight; ++y) {
            for (int x = 0; x < frameWidth; ++x) {
                count += image.pixel(x, y)[0] > 130 ? 1 : 0;
            }
        }
        return count;
    };
    const auto laidOut = brighter(drawLaidOut(plane, viewport, style));
    EXPECT_LE(brighter(drawPieces(plane, viewport, style)), laidOut + laidOut / 20 + 20);
}

TEST_F(PieceStrokes, closeWhereTheyShould) {
    Curve curve = wavy("linear", 1200);
    const Pieces pieces = piecesOf(curve);
    const ui::PlaneStudy plane(curve, pieces, {});
    const ui::Viewport viewport{{{60, 0}, 2}, frame};
    for (const bool closed : {false, true}) {
        ui::Scene scene;
        ui::drawPolygon(scene, plane, closed, {}, viewport);
        ASSERT_EQ(scene.pieces.size(), 1U);
        scene.pieces[0].stroke.style = {3, 0, 0, lineColour};
        const auto image = draw(pictureOf({scene.pieces[0].stroke}));
        // Along the straight line from the last point back to the first.
        const auto first = viewport.toScreen(plane.points().places().front());
        const auto last = viewport.toScreen(plane.points().places().back());
        int lit = 0;
        for (int k = 1; k < 100; ++k) {
            const double x = first.x + (last.x - first.x) * k / 100;
            const double y = first.y + (last.y - first.y) * k / 100;
            lit += image.pixel(static_cast<int>(x), static_cast<int>(y))[0] > 200 ? 1 : 0;
        }
        EXPECT_EQ(lit > 95, closed) << lit;
    }
}

} // namespace
} // namespace splineloft
