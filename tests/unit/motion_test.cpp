// Speed and acceleration of motions against closed forms, and times there and back.
#include "core/spline/measure/motion.h"

#include "tests/property/hard_pieces.h"
#include "tests/property/random_curves.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace splineloft {
namespace {

using namespace testing_curves;
using std::numbers::pi;

std::vector<Spot> spotsOn(const Pieces& pieces) {
    std::vector<Spot> spots;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (const double u : {0.0, 0.1, 0.37, 0.5, 0.9, 1.0}) {
            spots.push_back({i, u});
        }
    }
    return spots;
}

TEST(Motion, aroundACircleIsCentripetal) {
    for (const double radius : {1.0, 0.25, 40.0}) {
        const Pieces pieces = circle({3, -2}, radius);
        const ArcLength lengths(pieces);
        const auto motion = Motion::evenInLength(pieces, lengths, 6);
        const double speed = 2 * pi * radius / 6;
        for (const auto& spot : spotsOn(pieces)) {
            const Movement moment = motion.at(spot);
            EXPECT_NEAR(*moment.speed, speed, 1e-13 * speed);
            EXPECT_NEAR(*moment.curvature, 1 / radius, 1e-12 / radius) << "to the left";
            EXPECT_NEAR(*moment.acceleration, speed * speed / radius,
                        1e-12 * speed * speed / radius);
        }
        EXPECT_NEAR(motion.timeAt({2, 0.5}), 6 * 5.0 / 8, 1e-13);
    }
}

TEST(Motion, onAParabolaEvenInTheParameter) {
    // (t, t^2) for t from -1 to 2, played in 1.5 seconds: t = 2 tau - 1.
    const Pieces parabola(2, 2, KnotLine({-1, 2}), {-1, 1, 0.5, -2, 2, 4});
    const auto motion = Motion::evenInParameter(parabola, 1.5);
    for (const double u : {0.0, 1.0 / 3, 0.4, 0.75, 1.0}) {
        const double t = 3 * u - 1;
        const Movement moment = motion.at({0, u});
        EXPECT_NEAR(*moment.speed, 2 * std::hypot(1, 2 * t), 1e-13) << t;
        EXPECT_NEAR(*moment.acceleration, 8, 1e-12) << t;
        EXPECT_NEAR(*moment.curvature, 2 / std::pow(1 + 4 * t * t, 1.5), 1e-12) << t;
        EXPECT_NEAR(motion.timeAt({0, u}), 1.5 * u, 1e-15);
    }
    const ArcLength lengths(parabola);
    const auto even = Motion::evenInLength(parabola, lengths, 1.5);
    const double speed = lengths.total() / 1.5;
    EXPECT_NEAR(*even.at({0, 1.0 / 3}).acceleration, 2 * speed * speed, 1e-12) << "the vertex";
}

TEST(Motion, onALineOfUnevenBezierPoints) {
    // 3 u^2 - 2 u^3 of the way from (0, 0) to (3, 4): speed 5 x 6 u (1 - u).
    const Pieces line(3, 2, KnotLine({0, 1}), {0, 0, 0, 0, 3, 4, 3, 4});
    const auto uneven = Motion::evenInParameter(line, 2);
    const ArcLength lengths(line);
    const auto even = Motion::evenInLength(line, lengths, 2);
    for (const double u : {0.0, 0.25, 0.5, 0.8, 1.0}) {
        EXPECT_NEAR(*uneven.at({0, u}).speed, 30 * u * (1 - u) / 2, 1e-13);
        EXPECT_NEAR(*uneven.at({0, u}).acceleration, std::abs(30 - 60 * u) / 4, 1e-13);
        EXPECT_NEAR(*even.at({0, u}).speed, 2.5, 1e-14) << "also where the parameter rests";
    }
    EXPECT_NEAR(*even.at({0, 0.3}).acceleration, 0, 1e-13);
    EXPECT_NEAR(even.timeAt({0, 0.25}), 2 * (3.0 / 16 - 2.0 / 64), 1e-14);
    EXPECT_FALSE(even.at({0, 0}).curvature) << "a line at rest has no direction";
}

TEST(Motion, ofAStraightPathThatTurnsBackNeverBends) {
    for (const Points& points :
         {Points{{-3, 0}, {0, 1}, {0, 1}, {0, 1}, {3, 0}},
          Points{{-3, 0.1}, {0.3, 1.3}, {0.3, 1.3}, {0.3, 1.3}, {3.1, 0}},
          Points{{-3, 0.1, 7}, {0.3, 1.3, 5}, {0.3, 1.3, 5}, {0.3, 1.3, 5}, {3.1, 0, 2}}}) {
        Curve curve = emptyCurve({"cardinal", false, Ends::doubled}, points.dimension());
        curve.points = points;
        const Pieces pieces = piecesOf(curve);
        const auto motion = Motion::evenInParameter(pieces, 6);
        int slow = 0;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            for (double u = 1; u > 1e-12; u /= 2) {
                for (const double at : {u, 1 - u}) {
                    const auto movement = motion.at({i, at});
                    EXPECT_EQ(movement.curvature.value_or(0), 0) << i << ' ' << at;
                    slow += *movement.speed < 1e-9;
                }
            }
        }
        EXPECT_GT(slow, 4) << "it does come near to rest";
    }
}

TEST(Motion, ofACuspStillBendsWithoutBound) {
    // (t^2, t^3) has curvature 6 / (t (4 + 9 t^2)^1.5).
    Curve curve = emptyCurve({"bezier", false, Ends::none}, 2);
    curve.points = {{0, 0}, {0, 0}, {1.0 / 3, 0}, {1, 1}};
    const Pieces pieces = piecesOf(curve);
    const auto motion = Motion::evenInParameter(pieces, 1);
    for (double t = 0.5; t > 1e-5; t /= 2) {
        const double wanted = 6 / (t * std::pow(4 + 9 * t * t, 1.5));
        EXPECT_NEAR(*motion.at({0, t}).curvature, wanted, 1e-6 * wanted) << t;
    }
}

TEST(Motion, countsEveryCoordinate) {
    // One turn of the helix (cos, sin, t), approximated nowhere: a line in four dimensions.
    const Pieces line(1, 4, KnotLine({0, 1}), {0, 0, 0, 0, 1, 1, 1, 1});
    EXPECT_NEAR(*Motion::evenInParameter(line, 4).at({0, 0.5}).speed, 0.5, 1e-15);
    const Pieces ease(3, 1, KnotLine({0, 1}), {0, 0, 1, 1});
    const auto motion = Motion::evenInParameter(ease, 1);
    EXPECT_NEAR(*motion.at({0, 0.5}).speed, 1.5, 1e-15);
    EXPECT_NEAR(*motion.at({0, 0.25}).acceleration, 3, 1e-15);
    EXPECT_EQ(*motion.at({0, 0.25}).curvature, 0) << "one coordinate cannot bend";
}

TEST(Motion, knowsPiecesByTheirIntervals) {
    // The same two units, first in one second of t, then in three.
    const Pieces line(1, 2, KnotLine({0, 1, 4}), {0, 0, 2, 0, 2, 0, 4, 0});
    const auto motion = Motion::evenInParameter(line, 8);
    EXPECT_DOUBLE_EQ(*motion.at({0, 1}).speed, 1);
    EXPECT_DOUBLE_EQ(*motion.at({1, 0}).speed, 1.0 / 3);
    EXPECT_DOUBLE_EQ(motion.timeAt({0, 1}), 2);
    EXPECT_EQ(motion.spotAt(5), (Spot{1, 0.5}));
}

TEST(Motion, halfTheDurationIsTwiceTheSpeed) {
    Dice dice(11);
    for (int i = 0; i < 50; ++i) {
        const Pieces pieces = randomPiece(dice);
        const ArcLength lengths(pieces);
        for (const Spot spot : {Spot{0, 0.2}, Spot{0, 0.7}}) {
            const Movement slow = Motion::evenInParameter(pieces, 2).at(spot);
            const Movement fast = Motion::evenInParameter(pieces, 1).at(spot);
            EXPECT_EQ(*fast.speed, 2 * *slow.speed);
            EXPECT_EQ(*fast.acceleration, 4 * *slow.acceleration);
            const Movement even = Motion::evenInLength(pieces, lengths, 2).at(spot);
            EXPECT_EQ(even.curvature, slow.curvature) << "geometry";
        }
    }
}

class MotionLaws : public EveryFamily {};

TEST_P(MotionLaws, timesAndSpotsAreInverse) {
    forEveryForm(GetParam(), 4, [](const Curve& curve) {
        const Pieces pieces = piecesOf(curve);
        const ArcLength lengths(pieces);
        for (const auto& motion :
             {Motion::evenInParameter(pieces, 3), Motion::evenInLength(pieces, lengths, 3)}) {
            EXPECT_EQ(motion.timeAt({0, 0}), 0);
            EXPECT_NEAR(motion.timeAt({pieces.size() - 1, 1}), 3, 1e-13);
            std::vector<double> times;
            for (int i = 0; i <= 40; ++i) {
                times.push_back(3 * i / 40.0);
            }
            const auto spots = motion.spotsAt(times);
            for (std::size_t i = 0; i < times.size(); ++i) {
                EXPECT_NEAR(motion.timeAt(spots[i]), times[i], 1e-12);
                EXPECT_NEAR(motion.timeAt(motion.spotAt(times[i])), times[i], 1e-12);
            }
        }
    });
}

TEST_P(MotionLaws, theSpeedIsTheWayOverTheTime) {
    forEveryForm(GetParam(), 3, [](const Curve& curve) {
        const Pieces pieces = piecesOf(curve);
        const auto motion = Motion::evenInParameter(pieces, 2);
        const double h = 1e-6;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            const double step = motion.timeAt({i, 0.4 + h}) - motion.timeAt({i, 0.4 - h});
            if (!(step > 1e-9)) {
                continue;
            }
            const Point before = pieces.position({i, 0.4 - h});
            const Point after = pieces.position({i, 0.4 + h});
            const double speed = *motion.at({i, 0.4}).speed;
            EXPECT_NEAR(distance(before, after) / step, speed, 1e-4 * (1 + speed));
        }
    });
}

INSTANTIATE_TEST_SUITE_P(Catalog, MotionLaws, testing::ValuesIn(familyIds()), testNameOf);

TEST(Motion, ofWhatDoesNotMoveRests) {
    const Pieces point(3, 2, KnotLine({0, 1, 1, 2}), std::vector<double>(24, 5));
    const ArcLength lengths(point);
    for (const auto& motion :
         {Motion::evenInParameter(point, 1), Motion::evenInLength(point, lengths, 1)}) {
        EXPECT_EQ(motion.at({0, 0.5}).speed, 0);
        EXPECT_EQ(motion.at({0, 0.5}).acceleration, 0);
        EXPECT_FALSE(motion.at({0, 0.5}).curvature);
        EXPECT_FALSE(motion.at({1, 0.5}).speed) << "no time at all";
        EXPECT_EQ(motion.timeAt({2, 0.5}), 0.75);
        EXPECT_EQ(motion.spotAt(0.75), (Spot{2, 0.5}));
    }
    const Pieces none;
    const ArcLength nothing(none);
    EXPECT_EQ(Motion::evenInLength(none, nothing, 1).spotAt(0.5), Spot{});
    EXPECT_EQ(Motion::evenInParameter(none, 1).timeAt({}), 0);
    const Pieces still(1, 2, KnotLine({1, 1}), {0, 0, 1, 1});
    EXPECT_EQ(Motion::evenInParameter(still, 1).timeAt({0, 0.5}), 0);
    EXPECT_FALSE(Motion::evenInParameter(still, 1).at({0, 0.5}).speed);
}

TEST(Motion, isFiniteOrNothingWhateverTheNumbers) {
    Dice dice(5);
    for (const double size : {1e-308, 1e-300, 1e-150, 1e150, 1e300, 1.5e308}) {
        for (int round = 0; round < 40; ++round) {
            const Pieces unit = randomPiece(dice);
            std::vector<double> numbers(unit.bezier().begin(), unit.bezier().end());
            const auto width = static_cast<std::size_t>(unit[0].width());
            for (std::size_t i = 0; i < numbers.size(); ++i) {
                const bool isWeight =
                    unit.form() == splineloft::Form::rational && i % width == width - 1;
                numbers[i] *= isWeight ? 1 : size / 200;
            }
            const Pieces pieces(unit.degree(), unit.dimension(), unit.knots(), numbers,
                                unit.form());
            const ArcLength lengths(pieces);
            for (const double duration : {1e-3, 1e3}) {
                for (const auto& motion : {Motion::evenInParameter(pieces, duration),
                                           Motion::evenInLength(pieces, lengths, duration)}) {
                    for (const auto& spot : spotsOn(pieces)) {
                        const auto [speed, acceleration, curvature] = motion.at(spot);
                        EXPECT_TRUE(std::isfinite(speed.value_or(0))) << size;
                        EXPECT_TRUE(std::isfinite(acceleration.value_or(0))) << size;
                        EXPECT_TRUE(std::isfinite(curvature.value_or(0))) << size;
                        const double time = motion.timeAt(spot);
                        EXPECT_TRUE(time >= 0 && time <= duration) << size << " " << time;
                    }
                }
            }
        }
    }
}

TEST(Motion, takesNoDurationThatIsNone) {
    const Pieces line(1, 2, KnotLine({0, 1}), {0, 0, 1, 0});
    for (const double duration : {0.0, -1.0, std::numeric_limits<double>::infinity(),
                                  std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_THROW(Motion::evenInParameter(line, duration), std::invalid_argument);
        EXPECT_THROW(Motion::evenInLength(line, ArcLength(line), duration), std::invalid_argument);
    }
}

} // namespace
} // namespace splineloft
