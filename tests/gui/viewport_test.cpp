// Plane and screen: there and back, zooming and panning about a place, fitting, grid steps.
#include "ui/canvas/viewport.h"

#include "ui/canvas/grid.h"
#include "ui/canvas/wording.h"

#include "hand.h"

#include "core/spline/catalog.h"

#include "tests/gui/usual_frame.h"

#include <gtest/gtest.h>

#include <cmath>

namespace splineloft::ui {
namespace {

TEST(Wording, multiplesThatLieSideBySideReadDifferently) {
    for (const double start : {0.0, 1.0, -3.2, 1234.5}) {
        for (const double step : {1.0, 0.5, 2e-3, 1e-6, 5e-7, 2e-8, 1e-9, 5e-10}) {
            for (int k = 0; k < 50; ++k) {
                const double here = roundedTo(start + k * step, step);
                const double next = roundedTo(start + (k + 1) * step, step);
                EXPECT_NE(decimal(here, step), decimal(next, step)) << start << " by " << step;
            }
        }
    }
    EXPECT_EQ(decimal(1.000000005, 5e-9), "1.000000005");
    EXPECT_EQ(decimal(2e9, 1e9), "2e+09");
}

TEST(ViewportLaws, thereAndBackIsTheSamePixel) {
    for (const double zoom : {1e-7, 0.3, 80.0, 1e5, 1e9}) {
        for (const PlanePoint centre : {PlanePoint{0, 0}, {3.7, -1e3}, {-8e4, 5}}) {
            const Viewport viewport{{centre, zoom}, usualFrame};
            for (const ScreenPoint p :
                 {ScreenPoint{46, 32}, {500.5, 298}, {967, 563}, {-50, 2000}}) {
                const ScreenPoint back = viewport.toScreen(viewport.toPlane(p));
                const double dust = 1e-9 + 4e-16 * zoom * (std::abs(centre.x) + std::abs(centre.y));
                EXPECT_NEAR(back.x, p.x, dust) << zoom;
                EXPECT_NEAR(back.y, p.y, dust) << zoom;
            }
        }
    }
}

TEST(ViewportLaws, upIsUp) {
    const Viewport viewport{{{0, 0}, 80}, usualFrame};
    EXPECT_LT(viewport.toScreen({0, 1}).y, viewport.toScreen({0, 0}).y);
    EXPECT_GT(viewport.toScreen({1, 0}).x, viewport.toScreen({0, 0}).x);
}

TEST(ViewportLaws, zoomingKeepsWhatIsUnderThePointer) {
    Viewport viewport{{{2, -3}, 80}, usualFrame};
    const ScreenPoint at{111, 444};
    const PlanePoint held = viewport.toPlane(at);
    for (int i = 0; i < 200; ++i) {
        viewport.camera = zoomed(viewport, at, i < 100 ? 1.15 : 1 / 1.15);
        const ScreenPoint now = viewport.toScreen(held);
        EXPECT_NEAR(now.x, at.x, 1e-3) << i;
        EXPECT_NEAR(now.y, at.y, 1e-3) << i;
    }
    EXPECT_NEAR(viewport.camera.pixelsPerUnit, 80, 1e-9) << "and back again";
}

TEST(ViewportLaws, zoomHasEnds) {
    Viewport viewport{{{2, -3}, 80}, usualFrame};
    for (const double factor : {1e300, 1e-300, 1e300}) {
        viewport.camera = zoomed(viewport, {111, 444}, factor);
        EXPECT_TRUE(std::isfinite(viewport.camera.centre.x));
        EXPECT_TRUE(std::isnormal(viewport.camera.pixelsPerUnit));
    }
}

TEST(ViewportLaws, panningMovesThePlaneByPixels) {
    Viewport viewport{{{2, -3}, 123}, usualFrame};
    const PlanePoint held = viewport.toPlane(ScreenPoint{300, 300});
    viewport.camera = panned(viewport.camera, 17, -40);
    EXPECT_NEAR(viewport.toScreen(held).x, 317, 1e-9);
    EXPECT_NEAR(viewport.toScreen(held).y, 260, 1e-9);
}

TEST(ViewportLaws, fittingShowsTheBoxWithItsMargin) {
    const std::pair<PlanePoint, PlanePoint> boxes[] = {
        {{-1, -1}, {1, 1}},       {{5, 7}, {5, 9}},           {{5, 7}, {9, 7}},
        {{1e9, 1e9}, {1e9, 1e9}}, {{-1e9, -1e9}, {1e9, 1e9}}, {{0, 0}, {1e-9, 1e-9}}};
    for (const auto& [low, high] : boxes) {
        const Viewport viewport{fitted(low, high, usualFrame, 72), usualFrame};
        for (const auto& corner : {low, high}) {
            const ScreenPoint p = viewport.toScreen(corner);
            EXPECT_GE(p.x, usualFrame.left + 72 - 1e-3) << low.x << " " << high.x;
            EXPECT_LE(p.x, usualFrame.right() - 72 + 1e-3) << low.x << " " << high.x;
            EXPECT_GE(p.y, usualFrame.top + 72 - 1e-3) << low.y << " " << high.y;
            EXPECT_LE(p.y, usualFrame.bottom() - 72 + 1e-3) << low.y << " " << high.y;
        }
    }
}

TEST(ViewportLaws, gridStepsAreOneTwoFiveAndFarEnoughApart) {
    for (double zoom = 1e-8; zoom < 1e12; zoom *= 1.7) {
        for (const double pixels : {16.0, 80.0, 160.0}) {
            const double step = gridStep({{0, 0}, zoom}, pixels);
            EXPECT_GE(step * zoom, pixels * (1 - 1e-12)) << zoom;
            EXPECT_LE(step * zoom, 2.5 * pixels * (1 + 1e-12)) << zoom;
            const double digit = step / std::pow(10, std::floor(std::log10(step) + 1e-9));
            EXPECT_TRUE(std::abs(digit - 1) < 1e-6 || std::abs(digit - 2) < 1e-6 ||
                        std::abs(digit - 5) < 1e-6)
                << step;
        }
    }
}

TEST(ViewportLaws, roundedDecimalsReadAsDecimals) {
    EXPECT_EQ(roundedTo(0.31, 0.1), 0.3);
    EXPECT_EQ(roundedTo(-0.72, 0.1), -0.7);
    EXPECT_EQ(roundedTo(1.2345678, 0.001), 1.235);
    EXPECT_EQ(roundedTo(0.15, 0.02), 0.16);
    EXPECT_EQ(roundedTo(1234, 50), 1250);
}

TEST(ViewportLaws, aLiftedPlaceLiesWhereItWasAimed) {
    for (const int dimension : {1, 2, 3, 6}) {
        for (const Axes axes : {Axes{0, 1}, Axes{2, 0}, Axes{1, 5}}) {
            Curve curve = curveOf("cardinal", dimension);
            const PlanePoint aim{0.75, -2.5};
            curve.points.set(2, lifted(curve, axes, curve.points.at(2), aim));
            const PlanePoint now = controlPlaces(curve, axes)[2];
            const bool oneAxis =
                std::min(axes.across, dimension - 1) == std::min(axes.up, dimension - 1);
            EXPECT_EQ(now.y, aim.y) << dimension;
            EXPECT_TRUE(oneAxis || now.x == aim.x) << dimension;
        }
    }
}

TEST(ViewportLaws, flattenedCurvesPassWhereTheirPointsAreDrawn) {
    for (const auto* family : {"cardinal", "natural", "hermite", "linear", "catmull-rom"}) {
        for (const int dimension : {1, 2, 3, 6}) {
            const Curve curve = curveOf(family, dimension);
            const Axes axes{0, std::max(dimension - 1, 1)};
            const Pieces plane = flattened(piecesOf(curve), axes);
            const auto places = controlPlaces(curve, axes);
            for (std::size_t i = 0; i < plane.size(); ++i) {
                const auto control = controlAtStart(curve, i);
                const Point p = plane.position({i, 0});
                EXPECT_NEAR(p[0], places[control].x, 1e-12) << family << dimension;
                EXPECT_NEAR(p[1], places[control].y, 1e-12) << family << dimension;
            }
        }
    }
}

TEST(GridLaws, linesAreBoundedAndTheirNumbersTrueAtAnyZoom) {
    for (const double zoom : {1e-8, 1.0, 80.0, 1e6, 1e12}) {
        for (const double away : {0.0, 1.0, 1e6, 1e9}) {
            const Viewport viewport{{{away, -away}, zoom}, usualFrame};
            Scene scene;
            scene.frame = usualFrame;
            drawGrid(scene, viewport, 1);
            EXPECT_LE(scene.strokes.size(), 2U * (922 + 532) / 16 + 8) << zoom << " " << away;
            for (const auto& stroke : scene.strokes) {
                EXPECT_TRUE(std::isfinite(stroke.points[0].x + stroke.points[0].y));
            }
        }
    }
}

} // namespace
} // namespace splineloft::ui
