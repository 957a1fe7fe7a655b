// Self-intersections where branches touch, or run along each other.
#include "core/spline/curve.h"
#include "core/spline/shape/self_intersect.h"
#include "core/spline/shape/subdivide.h"

#include "tests/cases.h"
#include "tests/property/random_pieces.h"

#include <cmath>
#include <cstdint>

namespace splineloft {
namespace {

using namespace testing_curves;

Point turned(const Point& p, double angle, const Point& way) {
    return way + Point{p[0] * std::cos(angle) - p[1] * std::sin(angle),
                       p[0] * std::sin(angle) + p[1] * std::cos(angle)};
}

/// y = x^2 from x = -1 to 1.3 and y = factor x^2 from 1.2 to -0.9, with a way around on the right
/// that meets neither; cut at x = 0 where asked for; turned about the origin and moved.
Pieces twoParabolas(double factor, bool firstCut, bool secondCut, double angle, const Point& way) {
    std::vector<Point> points;
    const auto add = [&](double k, double from, double to) {
        points.push_back({(from + to) / 2, k * from * to});
        points.push_back({to, k * to * to});
    };
    points.push_back({-1, 1});
    if (firstCut) {
        add(1, -1, 0);
    }
    add(1, firstCut ? 0 : -1, 1.3);
    points.insert(points.end(), {{4, 6}, {6, 0}, {4, -6}, {1.2, factor * 1.44}});
    if (secondCut) {
        add(factor, 1.2, 0);
    }
    add(factor, secondCut ? 0 : 1.2, -0.9);
    for (auto& point : points) {
        point = turned(point, angle, way);
    }
    return chainOf(2, points);
}

TEST(Touching, ofParabolasWhereverTheyAreCut) {
    for (const double factor : {-3.0, -1.0, -0.1, 0.4, 0.9}) {
        for (int turn = 0; turn < roundsOf(24); ++turn) { // none along the axes
            for (const int cuts : {0, 1, 2, 3}) {
                const Point way = turn % 2 == 0 ? Point{0, 0} : Point{3.1, -20.7};
                const bool first = (cuts & 1) != 0, second = (cuts & 2) != 0;
                const auto found =
                    selfIntersections(twoParabolas(factor, first, second, 0.26 * turn + 0.1, way));
                const std::string words = std::to_string(factor) + ", turn " +
                                          std::to_string(turn) + ", cuts " + std::to_string(cuts);
                EXPECT_TRUE(found.complete) << words;
                ASSERT_EQ(found.crossings.size(), 1u) << words;
                EXPECT_LE(distance(found.crossings[0].place, way), 1e-7) << words;
            }
        }
    }
}

TEST(Touching, ofParabolasThroughThreePoints) {
    Dice dice(7);
    for (int i = 0; i < roundsOf(2000); ++i) {
        const double middle = dice.between(0.05, 0.95);
        Curve curve;
        curve.family = "parametric-parabola";
        curve.ends = familyOf(curve).ends.front();
        curve.points = Points{{-1, 1}, {middle, 0}, {1, 1}, {4, 0}, {1, -1}, {middle, 0}, {-1, -1}};
        const auto found = selfIntersections(piecesOf(curve));
        EXPECT_TRUE(found.complete) << middle;
        ASSERT_EQ(found.crossings.size(), 1u) << middle;
        EXPECT_LE(distance(found.crossings[0].place, {middle, 0}), 1e-8) << middle;
    }
}

/// A cubic, a way around, and a stretch of the same cubic again.
Pieces partlyRetraced(double from, double to, double angle) {
    std::vector<Point> cubic = {{0, 0}, {1, 3}, {4, -2}, {5, 2}};
    for (auto& point : cubic) {
        point = turned(point, angle, {2, 7});
    }
    const Pieces whole = pieceOf(cubic);
    const auto numbers = stretchOf(whole[0], std::min(from, to), std::max(from, to));
    std::vector<Point> stretch;
    for (std::size_t i = 0; i < numbers.size(); i += 2) {
        stretch.push_back({numbers[i], numbers[i + 1]});
    }
    if (from > to) {
        std::ranges::reverse(stretch);
    }
    cubic.push_back(turned({9, 9}, angle, {2, 7}));
    cubic.push_back(turned({5, 30}, angle, {2, 7}));
    cubic.insert(cubic.end(), stretch.begin(), stretch.end());
    return chainOf(3, cubic);
}

TEST(Touching, namesNoPlaceWhereStretchesCoincide) {
    for (int turn = 0; turn < roundsOf(300); ++turn) {
        const double angle = 0.021 * turn;
        for (const auto& [from, to] :
             {std::pair(0.15, 0.85), {0.9, 0.3}, {0.0, 1.0}, {0.4, 0.45}}) {
            const auto found = selfIntersections(partlyRetraced(from, to, angle));
            EXPECT_FALSE(found.complete) << from << " to " << to << ", turn " << turn;
            for (const auto& crossing : found.crossings) {
                EXPECT_FALSE(crossing.a.segment == 0 && crossing.b.segment == 2)
                    << from << " to " << to << ", turn " << turn << ": " << crossing.a.u << ", "
                    << crossing.b.u;
            }
        }
    }
}

} // namespace
} // namespace splineloft
