// The lines that stand for a curve on the screen: near enough, no more of them than needed, and
// cheap where nothing is to be seen.
#include "ui/canvas/outline.h"

#include "hand.h"

#include "core/spline/catalog.h"

#include "tests/gui/usual_frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace splineloft::ui {
namespace {

double distanceTo(const std::vector<ScreenPoint>& line, ScreenPoint p) {
    double best = INFINITY;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const double wayX = line[i + 1].x - line[i].x;
        const double wayY = line[i + 1].y - line[i].y;
        const double square = wayX * wayX + wayY * wayY;
        const double along =
            square > 0 ? std::clamp(((p.x - line[i].x) * wayX + (p.y - line[i].y) * wayY) / square,
                                    0.0, 1.0)
                       : 0;
        best = std::min(best,
                        std::hypot(line[i].x + along * wayX - p.x, line[i].y + along * wayY - p.y));
    }
    return best;
}

TEST(OutlineLaws, itIsWithinATenthOfAPixelOfTheCurve) {
    for (const auto& family : catalog()) {
        const Pieces pieces = piecesOf(curveOf(family.id));
        for (const double zoom : {20.0, 100.0, 4000.0}) {
            const Point middle = pieces.position({pieces.size() / 2, 0.4});
            const Viewport viewport{{{middle[0], middle[1]}, zoom}, usualFrame};
            const auto line = outline(pieces, viewport);
            for (std::size_t i = 0; i < pieces.size(); ++i) {
                for (int k = 0; k <= 400; ++k) {
                    const Point p = pieces.position({i, k / 400.0});
                    const ScreenPoint at = viewport.toScreen({p[0], p[1]});
                    if (usualFrame.contains(at)) {
                        ASSERT_LE(distanceTo(line, at), 0.1) << family.id << " at zoom " << zoom;
                    }
                }
            }
        }
    }
}

TEST(OutlineLaws, atAnyZoomItIsShortAndTrue) {
    for (const auto& family : catalog()) {
        const Pieces pieces = piecesOf(curveOf(family.id));
        for (const double zoom : {1e-6, 1e5, 1e7, 1e9}) {
            const Spot spot{pieces.size() / 2, 0.4};
            const Point middle = pieces.position(spot);
            const Viewport viewport{{{middle[0], middle[1]}, zoom}, usualFrame};
            const auto line = outline(pieces, viewport);
            EXPECT_LE(line.size(), 400U) << family.id << " at zoom " << zoom;
            const ScreenPoint centre{usualFrame.left + usualFrame.width / 2,
                                     usualFrame.top + usualFrame.height / 2};
            EXPECT_LE(distanceTo(line, centre), 0.1 + 1e-15 * zoom * 4)
                << family.id << " at zoom " << zoom;
        }
    }
}

TEST(OutlineLaws, piecesFollowOneAnotherWithoutABreak) {
    for (const auto& family : catalog()) {
        const Pieces pieces = piecesOf(curveOf(family.id));
        const Viewport viewport{{{0, 0}, 100}, usualFrame};
        const auto line = outline(pieces, viewport);
        ASSERT_GT(line.size(), pieces.size()) << family.id;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            const Point p = pieces.position({i, 1});
            EXPECT_LE(distanceTo(line, viewport.toScreen({p[0], p[1]})), 1e-9) << family.id << i;
        }
    }
}

TEST(OutlineLaws, whatIsOutOfSightIsOneLineAPiece) {
    Curve curve = curveOf("cardinal");
    for (int i = 0; i < 20'000; ++i) {
        curve.points.append(Point{100 + std::sin(0.7 * i), std::cos(1.3 * i)});
    }
    const Pieces pieces = piecesOf(curve);
    const auto line = outline(pieces, {{{1e4, 0}, 100}, usualFrame});
    EXPECT_EQ(line.size(), pieces.size() + 1);
}

TEST(OutlineLaws, wildCurvesStayBounded) {
    for (const double size : {1e-9, 1e9}) {
        Curve curve = curveOf("bezier");
        curve.points = Points();
        for (int i = 0; i < 100; ++i) {
            curve.points.append(Point{size * std::sin(17.0 * i), size * std::cos(29.0 * i)});
        }
        const auto line = outline(piecesOf(curve), {{{0, 0}, 1e3 / size}, usualFrame});
        EXPECT_LE(line.size(), 20'000U) << size;
        EXPECT_TRUE(std::ranges::all_of(
            line, [](ScreenPoint p) { return std::isfinite(p.x) && std::isfinite(p.y); }));
    }
}

TEST(OutlineLaws, aCurveThatIsAPointIsAPoint) {
    for (const auto& family : catalog()) {
        Curve curve = curveOf(family.id);
        for (std::size_t i = 0; i < curve.points.size(); ++i) {
            curve.points.set(i, {1, 1});
            if (!curve.tangents.empty()) {
                curve.tangents.set(i, {0, 0});
            }
        }
        const Pieces pieces = piecesOf(curve);
        EXPECT_LE(outline(pieces, {{{1, 1}, 1e9}, usualFrame}).size(), pieces.size() + 1)
            << family.id;
    }
    EXPECT_TRUE(outline(Pieces(), {{{1, 1}, 80}, usualFrame}).empty());
}

} // namespace
} // namespace splineloft::ui
