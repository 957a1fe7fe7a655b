// Frames along curves: square, continuous, closed, and turned no more than the tangent makes them.
#include "core/spline/measure/frames.h"

#include "tests/property/hard_pieces.h"
#include "tests/property/random_curves.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace splineloft {
namespace {

using namespace testing_curves;
using std::numbers::pi;

/// Places and derivatives of a curve in space, as cubic pieces over equal steps from 0 to `end`.
template <class Place, class Derivative>
Pieces hermitePieces(Place place, Derivative derivative, double end, int count) {
    std::vector<double> knots, bezier;
    for (int i = 0; i <= count; ++i) {
        knots.push_back(i);
    }
    const double h = end / count;
    for (int i = 0; i < count; ++i) {
        const Point from = place(i * h), to = place((i + 1) * h);
        for (const Point& p : {from, from + (h / 3) * derivative(i * h),
                               to - (h / 3) * derivative((i + 1) * h), to}) {
            bezier.insert(bezier.end(), p.coordinates().begin(), p.coordinates().end());
        }
    }
    return {3, 3, KnotLine(std::move(knots)), std::move(bezier)};
}

/// A helix of radius 2 that rises by 0.5 a radian.
Pieces helix(double turns, int count) {
    return hermitePieces([](double t) { return Point{2 * std::cos(t), 2 * std::sin(t), 0.5 * t}; },
                         [](double t) { return Point{-2 * std::sin(t), 2 * std::cos(t), 0.5}; },
                         2 * pi * turns, count);
}

/// A closed curve that is in no plane.
Pieces crown() {
    return hermitePieces(
        [](double t) {
            return Point{2 * std::cos(t), 2 * std::sin(t), std::sin(2 * t) + 0.4 * std::cos(3 * t)};
        },
        [](double t) {
            return Point{-2 * std::sin(t), 2 * std::cos(t),
                         2 * std::cos(2 * t) - 1.2 * std::sin(3 * t)};
        },
        2 * pi, 24);
}

void expectSquare(const Frame& frame, const std::string& where) {
    std::vector<Point> vectors = frame.normals;
    vectors.push_back(frame.tangent);
    for (std::size_t i = 0; i < vectors.size(); ++i) {
        EXPECT_NEAR(norm(vectors[i]), 1, 1e-12) << where;
        for (std::size_t k = 0; k < i; ++k) {
            EXPECT_NEAR(dot(vectors[i], vectors[k]), 0, 1e-12) << where;
        }
    }
    if (frame.normals.size() == 2) {
        const auto& [t, n, b] = std::array{frame.tangent, frame.normals[0], frame.normals[1]};
        EXPECT_NEAR(b[0], t[1] * n[2] - t[2] * n[1], 1e-12) << where << ": right-handed";
    }
}

double angleBetween(const Point& a, const Point& b) {
    return 2 * std::atan2(norm(a - b), norm(a + b));
}

class FrameLaws : public EveryFamily {};

TEST_P(FrameLaws, areSquareAtEverySpot) {
    forEveryForm(GetParam(), 3, [](const Curve& curve) {
        const Pieces pieces = piecesOf(curve);
        const ArcLength lengths(pieces);
        const Frames frames(pieces, lengths, curve.closed);
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            for (const double u : {0.0, 0.3, 0.5, 1.0}) {
                const Frame frame = frames.at({i, u});
                expectSquare(frame, std::to_string(i) + ", " + std::to_string(u));
                const int normals = pieces.dimension() == 2 ? 1 : pieces.dimension() == 3 ? 2 : 0;
                EXPECT_EQ(frame.normals.size(), static_cast<std::size_t>(normals));
            }
        }
    });
}

INSTANTIATE_TEST_SUITE_P(Families, FrameLaws, testing::ValuesIn(familyIds()), testNameOf);

TEST(Frames, ofACircleTurnLeft) {
    const Pieces pieces = circle({3, -2}, 5);
    const ArcLength lengths(pieces);
    const Frames frames(pieces, lengths, true);
    for (std::size_t i = 0; i < 4; ++i) {
        for (const double u : {0.0, 0.25, 0.7, 1.0}) {
            const Frame frame = frames.at({i, u});
            const Point inward = (1.0 / 5) * (Point{3, -2} - frame.position);
            EXPECT_LE(distance(frame.normals.at(0), inward), 1e-13);
        }
    }
    EXPECT_EQ(frames.twist(), 0);
}

TEST(Frames, onAHelixTurnBackByItsTorsion) {
    // The frame of Frenet turns about the tangent by torsion x length more than ours.
    const Pieces pieces = helix(3, 300);
    const ArcLength lengths(pieces);
    const Frames frames(pieces, lengths, false);
    const double torsion = 0.5 / (2 * 2 + 0.5 * 0.5);
    const auto frenet = [](const Frame& frame) {
        const double x = frame.position[0], y = frame.position[1];
        const Point inward = (-1 / std::hypot(x, y)) * Point{x, y, 0};
        return std::atan2(dot(inward, frame.normals[1]), dot(inward, frame.normals[0]));
    };
    const double start = frenet(frames.at({0, 0}));
    for (std::size_t i = 0; i < pieces.size(); i += 7) {
        const double wanted = start + torsion * lengths.upTo({i, 0.4});
        const double off = frenet(frames.at({i, 0.4})) - wanted;
        EXPECT_NEAR(std::remainder(off, 2 * pi), 0, 1e-5) << i;
    }
}

TEST(Frames, ofAPlaneCurveInSpaceStayInItsPlane) {
    // (t, t^2, 0), with an upright second normal.
    const Pieces parabola(2, 3, KnotLine({0, 1}), {-1, 1, 0, 0, -1, 0, 1, 1, 0});
    const ArcLength lengths(parabola);
    const Frames frames(parabola, lengths, false);
    for (const double u : {0.0, 0.2, 0.5, 0.9, 1.0}) {
        EXPECT_LE(distance(frames.at({0, u}).normals.at(1), {0, 0, 1}), 1e-12) << u;
    }
}

TEST(Frames, closeAroundALoop) {
    const Pieces pieces = crown();
    const ArcLength lengths(pieces);
    const Frames frames(pieces, lengths, true);
    EXPECT_GT(std::abs(frames.twist()), 0.01) << "there is something to spread";
    const Frame first = frames.at({0, 0}), last = frames.at({23, 1});
    EXPECT_LE(distance(first.normals[0], last.normals[0]), 1e-9);
    EXPECT_LE(distance(first.normals[1], last.normals[1]), 1e-9);
    // Evenly: beside the open frame, the angle grows with the length.
    const Frames open(pieces, lengths, false);
    EXPECT_EQ(open.twist(), 0);
    for (std::size_t i = 0; i < 24; ++i) {
        const double part = lengths.upTo({i, 0.5}) / lengths.total();
        const double angle =
            angleBetween(frames.at({i, 0.5}).normals[0], open.at({i, 0.5}).normals[0]);
        EXPECT_NEAR(angle, std::abs(frames.twist()) * part, 1e-9) << i;
    }
}

TEST(Frames, neverJumpOnASmoothLoop) {
    const Pieces pieces = crown();
    const ArcLength lengths(pieces);
    const Frames frames(pieces, lengths, true);
    Frame before = frames.at({23, 1});
    for (std::size_t i = 0; i < 24; ++i) {
        for (int k = 0; k < 50; ++k) {
            const Frame now = frames.at({i, k / 50.0});
            EXPECT_LE(angleBetween(before.normals[0], now.normals[0]), 0.02) << i << " " << k;
            before = now;
        }
    }
}

TEST(Frames, onALineStayAsTheyAre) {
    const Pieces line(3, 3, KnotLine({0, 1}), {0, 0, 0, 0, 0, 0, 1, 2, 2, 3, 6, 6});
    const ArcLength lengths(line);
    const Frames frames(line, lengths, false);
    const Frame first = frames.at({0, 0});
    EXPECT_LE(distance(first.tangent, {1.0 / 3, 2.0 / 3, 2.0 / 3}), 1e-14) << "though it rests";
    for (const double u : {0.1, 0.5, 1.0}) {
        EXPECT_LE(distance(frames.at({0, u}).normals[0], first.normals[0]), 1e-12);
    }
}

TEST(Frames, passCuspsAndReversals) {
    const Pieces cusp(3, 3, KnotLine({0, 1}), {0, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, 0});
    const Pieces thereAndBack(1, 3, KnotLine({0, 1, 2}), {0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0});
    for (const Pieces& pieces : {cusp, thereAndBack}) {
        const ArcLength lengths(pieces);
        for (const bool closed : {false, true}) {
            const Frames frames(pieces, lengths, closed);
            for (std::size_t i = 0; i < pieces.size(); ++i) {
                for (int k = 0; k <= 20; ++k) {
                    expectSquare(frames.at({i, k / 20.0}), std::to_string(k));
                }
            }
        }
    }
    const ArcLength lengths(thereAndBack);
    const Frames frames(thereAndBack, lengths, false);
    EXPECT_EQ(frames.at({0, 1}).normals[0], frames.at({1, 0}).normals[0]) << "reversed, not turned";
    // In the plane the tangent of a cusp is that of one side.
    const Pieces plane(3, 2, KnotLine({0, 1}), {0, 0, 1, 1, 0, 1, 1, 0});
    const ArcLength planeLengths(plane);
    const Frame at = Frames(plane, planeLengths, false).at({0, 0.5});
    EXPECT_NEAR(std::abs(at.tangent[1]), 1, 1e-9);
}

TEST(Frames, wherePointsCoincideAreThoseBefore) {
    for (const int dimension : {2, 3}) {
        std::vector<double> bezier;
        for (const auto& p : std::vector<Point>{{0, 0, 0},
                                                {0, 0, 0},
                                                {0, 0, 0},
                                                {0, 2, 0},
                                                {0, 2, 0},
                                                {0, 2, 0},
                                                {0, 2, 0},
                                                {3, 2, 0}}) {
            bezier.insert(bezier.end(), p.coordinates().begin(),
                          p.coordinates().begin() + dimension);
        }
        const Pieces pieces(1, dimension, KnotLine({0, 1, 2, 3, 4}), bezier);
        const ArcLength lengths(pieces);
        const Frames frames(pieces, lengths, false);
        EXPECT_EQ(frames.at({0, 0.5}).tangent[1], 1) << "the one after, at the start";
        EXPECT_EQ(frames.at({2, 0.5}).tangent[1], 1) << "the one before";
        EXPECT_EQ(frames.at({3, 0.5}).tangent[0], 1);
        expectSquare(frames.at({0, 0}), "start");
        expectSquare(frames.at({2, 1}), "rest");
        const Pieces point(1, dimension, KnotLine({0, 1, 2}),
                           std::vector<double>(static_cast<std::size_t>(4 * dimension), 7));
        const ArcLength nothing(point);
        expectSquare(Frames(point, nothing, true).at({1, 0.5}), "a point");
    }
}

TEST(Frames, areFiniteWhateverTheNumbers) {
    Dice dice(3);
    for (const double size : {1e-308, 1e-200, 1e150, 1e307}) {
        for (int round = 0; round < 30; ++round) {
            const Pieces unit = randomPolynomial(dice, dice.whole(1, 6), dice.whole(1, 4));
            std::vector<double> numbers(unit.bezier().begin(), unit.bezier().end());
            for (auto& number : numbers) {
                number *= size / 200;
            }
            const Pieces pieces(unit.degree(), unit.dimension(), unit.knots(), numbers);
            const ArcLength lengths(pieces);
            const Frames frames(pieces, lengths, true);
            for (const double u : {0.0, 0.4, 1.0}) {
                expectSquare(frames.at({0, u}), std::to_string(size));
            }
        }
    }
}

} // namespace
} // namespace splineloft
