// Arc length against closed forms, at cusps, and on pieces that hardly move.
#include "core/spline/measure/length.h"

#include "core/spline/measure/sample.h"
#include "tests/property/hard_pieces.h"
#include "tests/property/random_curves.h"
#include "tests/unit/random_pieces.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace splineloft {
namespace {

/// One Bézier piece through the given points.
Pieces bezierPiece(Points points) {
    Curve curve;
    curve.family = "bezier";
    curve.ends = Ends::none;
    curve.coordinates = points.dimension() == 2 ? std::vector<std::string>{"x", "y"}
                                                : std::vector<std::string>{"x", "y", "z"};
    curve.points = std::move(points);
    return piecesOf(curve);
}

/// The promise of ArcLength: relative error about 1e-14, of the polygon where the curve is short.
constexpr double promised = 4e-14;

TEST(Length, ofALineIsItsEndsDistanceHoweverUnevenTheSpeed) {
    const Pieces even = bezierPiece({{100, 50}, {103, 54}});
    EXPECT_DOUBLE_EQ(ArcLength(even).total(), 5);
    const Pieces uneven = bezierPiece({{100, 50}, {100.3, 50.4}, {102.7, 53.6}, {103, 54}});
    EXPECT_NEAR(ArcLength(uneven).total(), 5, 5 * promised);
    const Pieces inSpace = bezierPiece({{10, 20, 30}, {12, 23, 36}});
    EXPECT_DOUBLE_EQ(ArcLength(inSpace).total(), 7);
}

TEST(Length, ofTheParabola) {
    // y = x^2 from 0 to 1, off the origin: sqrt(5) / 2 + asinh(2) / 4.
    const Pieces parabola = bezierPiece({{100, 50}, {100.5, 50}, {101, 51}});
    const double wanted = std::sqrt(5) / 2 + std::asinh(2.0) / 4;
    EXPECT_NEAR(ArcLength(parabola).total(), wanted, promised * wanted);
}

TEST(Length, ofTheSemicubicalParabolaThroughItsCusp) {
    // (t^2, t^3) from t = -1 to t = 2 rests at u = 1/3. From the cusp to t it is
    // ((4 + 9 t^2)^(3/2) - 8) / 27 long.
    const Pieces cusped = bezierPiece({{1, -1}, {-1, 2}, {0, -4}, {4, 8}});
    const auto fromCusp = [](double t) { return (std::pow(4 + 9 * t * t, 1.5) - 8) / 27; };
    const double wanted = fromCusp(1) + fromCusp(2);
    const ArcLength lengths(cusped);
    EXPECT_NEAR(lengths.total(), wanted, promised * wanted);
    EXPECT_NEAR(lengths.upTo({0, 1.0 / 3}), fromCusp(1), promised * wanted) << "at the cusp";
    EXPECT_NEAR(lengths.upTo({0, 0.5}), fromCusp(1) + fromCusp(0.5), promised * wanted);
}

TEST(Length, ofTheCuspedCubic) {
    // Speed 3 |1 - 2u| sqrt((1 - 2u)^2 + 1): 2 sqrt(2) - 1 in all.
    const Pieces cusped = bezierPiece({{0, 0}, {1, 1}, {0, 1}, {1, 0}});
    EXPECT_NEAR(ArcLength(cusped).total(), 2 * std::sqrt(2) - 1, promised * 2);
    const Pieces straightBack = bezierPiece({{10, 10}, {14, 10}, {14, 10}, {10, 10}});
    EXPECT_NEAR(ArcLength(straightBack).total(), 6, promised * 6) << "there and back on a line";
}

TEST(Length, ofRestingPiecesIsFinite) {
    const Point a = {5, 7};
    for (const auto& points : std::vector<Points>{{{5, 7}, {5, 7}, {5, 7}, {5, 7}},
                                                  {{5, 7}, {5, 7}, {9, 4}, {9, 4}},
                                                  {{5, 7}, {5, 7}, {5, 7}, {9, 4}},
                                                  {{5, 7}, {9, 4}, {5, 7}, {9, 4}},
                                                  {{5, 7}, {9, 4}, {5, 7}, {5, 7}},
                                                  {{5, 7}, {5, 7}, {5, 7}, {5, 7.000001}}}) {
        const Pieces pieces = bezierPiece(points);
        const ArcLength lengths(pieces);
        EXPECT_TRUE(std::isfinite(lengths.total()));
        EXPECT_GE(lengths.total(), distance(a, points.at(3)) * (1 - promised));
    }
}

TEST(Length, ofTheExactCircle) {
    for (const double radius : {1.0, 3.25, 1e150, 1e-150}) {
        const Pieces circle = testing_curves::circle({2 * radius, -radius}, radius);
        const double wanted = 2 * std::numbers::pi * radius;
        EXPECT_NEAR(ArcLength(circle).total(), wanted, 1e-13 * wanted) << radius;
        EXPECT_NEAR(lengthOf(circle), wanted, 1e-13 * wanted) << radius;
        EXPECT_NEAR(lengthOf(circle, 1e-6 * radius), wanted, 1e-6 * radius) << radius;
        const ArcLength lengths(circle);
        const Spot eighth = lengths.spotAt(lengths.total() / 8);
        EXPECT_EQ(eighth.segment, 0u);
        EXPECT_NEAR(eighth.u, 0.5, 1e-13) << "an eighth is the middle of the first quarter";
    }
}

TEST(Length, toNoToleranceIsToFullPrecision) {
    const Pieces parabola = bezierPiece({{100, 50}, {100.5, 50}, {101, 51}});
    const double wanted = std::sqrt(5) / 2 + std::asinh(2.0) / 4;
    for (const double tolerance : {0.0, -1.0, std::nan(""), 1e-300}) {
        EXPECT_NEAR(lengthOf(parabola, tolerance), wanted, promised * wanted) << tolerance;
    }
    EXPECT_NEAR(lengthOf(parabola, 1e-3), wanted, 1e-3);
    EXPECT_NEAR(lengthOf(parabola, 1e300), wanted, wanted) << "any answer would do";
    EXPECT_EQ(lengthOf(Pieces(), 1e-9), 0);
}

TEST(Length, ofHugeAndTinyPiecesIsFinite) {
    const std::vector<double> shape = {0, 0, 1, 1, 0, 1, 1, 0}; // the cusped cubic
    const double wanted = 2 * std::sqrt(2) - 1;
    for (const double scale : {0x1p1000, 0x1p500, 0x1p-500, 0x1p-1000}) {
        for (const auto form : {Form::polynomial, Form::rational}) {
            std::vector<double> bezier;
            for (std::size_t i = 0; i < shape.size(); i += 2) {
                bezier.insert(bezier.end(), {scale * shape[i], scale * shape[i + 1]});
                if (form == Form::rational) {
                    bezier.push_back(1);
                }
            }
            const Pieces pieces = testing_curves::onePiece(3, 2, bezier, form);
            const ArcLength lengths(pieces);
            EXPECT_NEAR(lengths.total() / scale, wanted, promised * wanted) << scale;
            EXPECT_NEAR(lengths.upTo(lengths.spotAt(0.3 * lengths.total())) / lengths.total(), 0.3,
                        promised);
            EXPECT_EQ(spread(pieces, lengths, Even::length, 100).size(), 100u);
        }
    }
    const double most = std::numeric_limits<double>::max();
    for (const double huge : {most, 1e308}) {
        const Pieces pieces =
            testing_curves::onePiece(3, 2, {-huge, -huge, huge, huge, -huge, huge, huge, -huge});
        const ArcLength lengths(pieces);
        EXPECT_EQ(lengths.total(), most) << "lengths beyond the largest double are that";
        for (const auto& spot : spread(pieces, lengths, Even::length, 9)) {
            EXPECT_TRUE(spot.u >= 0 && spot.u <= 1) << spot.u;
        }
    }
}

/// A curve that crawls back and forth along a line has corners in its speed wherever it turns.
TEST(Length, ofLegsThereAndBackInEveryForm) {
    // x = T5(t), the Chebyshev polynomial, for t from -1 to 1: 5 legs of length 2.
    const std::vector<double> x = {-1, 9, -21, 21, -9, 1};
    for (const int dimension : {1, 2, 3, 4}) {
        std::vector<double> bezier, weighted;
        for (const double value : x) {
            for (int c = 0; c < dimension; ++c) {
                bezier.push_back((c + 1) * value);
                weighted.push_back((c + 1) * value);
            }
            weighted.push_back(1);
        }
        double unit = 0;
        for (int c = 0; c < dimension; ++c) {
            unit += (c + 1) * (c + 1);
        }
        const double wanted = 10 * std::sqrt(unit);
        EXPECT_NEAR(ArcLength(testing_curves::onePiece(5, dimension, bezier)).total(), wanted,
                    promised * wanted)
            << dimension;
        EXPECT_NEAR(
            ArcLength(testing_curves::onePiece(5, dimension, weighted, Form::rational)).total(),
            wanted, promised * wanted)
            << dimension;
    }
}

TEST(Length, ofNothingIsNothing) {
    const Pieces none;
    const ArcLength lengths(none);
    EXPECT_EQ(lengths.total(), 0);
    EXPECT_EQ(lengths.spotAt(3), Spot{});
    EXPECT_EQ(lengths.upTo({}), 0);
    EXPECT_EQ(lengths.spotsAt(std::vector{1.0, 2.0}), std::vector<Spot>(2));
    std::vector<double> asked = {1, 2};
    const auto runs = lengths.toParameters(asked);
    ASSERT_EQ(runs.size(), 1u);
    EXPECT_EQ(runs[0].count, 2u);
    EXPECT_EQ(asked, (std::vector<double>{0, 0}));
}

TEST(Length, outsideTheCurveIsTheNearerEnd) {
    const Pieces pieces = bezierPiece({{100, 50}, {103, 54}});
    const ArcLength lengths(pieces);
    EXPECT_EQ(lengths.spotAt(-1), (Spot{0, 0}));
    EXPECT_EQ(lengths.spotAt(5.1), (Spot{0, 1}));
    EXPECT_EQ(lengths.spotAt(std::nan("")), (Spot{0, 0}));
    EXPECT_EQ(lengths.spotsAt(std::vector<double>{-1, 0, 5.1, 7}),
              (std::vector<Spot>{{0, 0}, {0, 0}, {0, 1}, {0, 1}}));
    EXPECT_TRUE(lengths.spotsAt({}).empty());
}

class LengthLaws : public testing_curves::EveryFamily {};

double polygonOf(const Pieces& pieces) {
    double sum = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (int k = 0; k < pieces.degree(); ++k) {
            sum += distance(pieces[i].bezierPoint(k), pieces[i].bezierPoint(k + 1));
        }
    }
    return sum;
}

TEST_P(LengthLaws, addsUpAndFindsItsWayBack) {
    testing_curves::forEveryForm(GetParam(), 6, [](const Curve& curve) {
        const Pieces pieces = piecesOf(curve);
        const ArcLength lengths(pieces);
        const double tolerance = promised * polygonOf(pieces);
        EXPECT_GE(polygonOf(pieces) + tolerance, lengths.total()) << "no curve exceeds its polygon";
        double before = 0;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            EXPECT_NEAR(lengths.upTo({i, 0}), before, tolerance) << "start of segment " << i;
            for (const double u : {0.0, 0.123, 0.5, 0.77, 1.0}) {
                const double length = lengths.upTo({i, u});
                EXPECT_GE(length, before - tolerance) << "segment " << i << " u " << u;
                before = length;
                const Spot back = lengths.spotAt(length);
                EXPECT_NEAR(lengths.upTo(back), length, tolerance) << "segment " << i << " u " << u;
                EXPECT_LE(distance(pieces.position(back), pieces.position({i, u})),
                          8 * tolerance + 1e-14 * testing_curves::farthest(curve))
                    << "segment " << i << " u " << u;
            }
        }
        EXPECT_NEAR(before, lengths.total(), tolerance);
    });
}

/// Length between two spots by a rule of our own: Simpson's on 2048 steps.
double simpson(const Pieces& pieces, Spot from, Spot to) {
    double sum = 0;
    for (std::size_t i = from.segment; i <= to.segment; ++i) {
        const double a = i == from.segment ? from.u : 0;
        const double b = i == to.segment ? to.u : 1;
        constexpr int steps = 2048;
        for (int k = 0; k <= steps; ++k) {
            const double weight = k == 0 || k == steps ? 1 : k % 2 == 1 ? 4 : 2;
            sum += weight * (b - a) / (3 * steps) *
                   norm(pieces.jet({i, a + (b - a) * k / steps}).first);
        }
    }
    return sum;
}

/// Many spots, which charts find, against single ones, which Newton's method finds.
TEST(Length, hasTheSameSpotsManyOrOneByOneOnEveryInstructionSet) {
    const Pieces pieces = test::randomPieces(3, 2, Form::polynomial, test::evenKnots(5));
    const ArcLength lengths(pieces);
    test::onEveryInstructionSet([&](const std::string& instructions) {
        for (const std::size_t count : {20u, 100u, 333u, 1000u}) {
            std::vector<double> asked;
            for (std::size_t i = 0; i <= count; ++i) {
                asked.push_back(lengths.total() * static_cast<double>(i) /
                                static_cast<double>(count));
            }
            const auto spots = lengths.spotsAt(asked);
            for (std::size_t i = 0; i <= count; ++i) {
                ASSERT_NEAR(lengths.upTo(spots[i]), asked[i], 4e-15 * lengths.total())
                    << instructions << ": spot " << i << " of " << count;
                ASSERT_NEAR(lengths.upTo(lengths.spotAt(asked[i])), asked[i],
                            4e-15 * lengths.total());
            }
        }
    });
}

TEST(Length, isTheSameOnEveryInstructionSet) {
    for (const int dimension : {1, 2, 3}) {
        const Pieces pieces =
            test::randomPieces(3, dimension, Form::polynomial, test::evenKnots(20));
        const double wanted = ArcLength(pieces).total();
        test::onEveryInstructionSet([&](const std::string& instructions) {
            EXPECT_NEAR(ArcLength(pieces).total(), wanted, promised * wanted) << instructions;
            EXPECT_NEAR(lengthOf(pieces), wanted, promised * wanted) << instructions;
            EXPECT_NEAR(lengthOf(pieces, 1e-9), wanted, 1e-9) << instructions;
        });
    }
}

/// Cusps at any place, more or less round, all the way to none at all: the speed between them goes
/// through zero or all but.
TEST(Length, passesCuspsOnEveryInstructionSet) {
    test::onEveryInstructionSet([](const std::string& instructions) {
        for (const double at : {0.0, 1e-9, 0.01, 0.3, 0.5, 0.999, 1.0}) {
            for (const double round : {0.0, 1e-300, 1e-12, 1e-9, 1e-8, 1e-6, 1e-3, 0.1}) {
                // The velocity (u - at, round): its length is a parabola's.
                const Pieces pieces =
                    testing_curves::onePiece(2, 2, {0, 0, -0.5 * at, 0.5 * round, 0.5 - at, round});
                const auto fromTip = [&](double x) {
                    const double speed = std::hypot(x, round);
                    const double bend = round > 0 ? std::asinh(x / round) : 0;
                    return 0.5 * (x * speed + round * round * bend);
                };
                const double wanted = fromTip(at) + fromTip(1 - at);
                EXPECT_NEAR(lengthOf(pieces, 1e-9), wanted, 1e-9)
                    << instructions << ' ' << at << ' ' << round;
                EXPECT_NEAR(lengthOf(pieces), wanted, promised)
                    << instructions << ' ' << at << ' ' << round;
                EXPECT_NEAR(ArcLength(pieces).total(), wanted, promised)
                    << instructions << ' ' << at << ' ' << round;
            }
        }
    });
}

TEST(Length, evenSpacingIsEvenToOnePartInABillion) {
    Curve curve;
    curve.closed = true;
    curve.points = {{100, 50}, {130, 52}, {140, 80}, {111, 91}, {96, 70}};
    for (const auto* family : {"cardinal", "natural", "b-spline"}) {
        curve.family = family;
        curve.ends = testing_curves::formsOf(family).front().ends;
        const Pieces pieces = piecesOf(curve);
        const ArcLength lengths(pieces);
        const auto spots = spread(pieces, lengths, Even::length, 24);
        const double step = lengths.total() / 23;
        for (std::size_t i = 1; i < spots.size(); ++i) {
            EXPECT_NEAR(simpson(pieces, spots[i - 1], spots[i]), step, 1e-9 * step)
                << family << ' ' << i;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Families, LengthLaws, testing::ValuesIn(testing_curves::familyIds()),
                         testing_curves::testNameOf);

} // namespace
} // namespace splineloft
