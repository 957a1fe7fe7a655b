// Lengths of rational pieces whose weights differ by up to 10^18.
#include "core/spline/curve.h"
#include "core/spline/measure/length.h"
#include "tests/property/random_curves.h"

#include <cmath>
#include <numbers>

namespace splineloft {
namespace {

using testing_curves::casesOf;
using testing_curves::Dice;

/// One rational piece with these Bézier points and weights.
Pieces weightedPiece(const Points& points, std::vector<double> weights) {
    Curve curve;
    curve.family = "nurbs";
    curve.parameters["degree"] = static_cast<double>(points.size() - 1);
    curve.ends = Ends::clamped;
    curve.coordinates = {"x", "y"};
    curve.points = points;
    curve.weights = std::move(weights);
    return piecesOf(curve);
}

void expectLength(const Pieces& pieces, double wanted, const std::string& what) {
    EXPECT_NEAR(ArcLength(pieces).total(), wanted, 1e-14 * wanted) << what;
    EXPECT_NEAR(lengthOf(pieces), wanted, 1e-14 * wanted) << what;
    EXPECT_NEAR(lengthOf(pieces, 1e-6), wanted, 1e-6) << what;
}

TEST(RationalLength, ofALineIsItsEndsDistance) {
    for (const double light : {1e-9, 1e-5, 1.0}) {
        for (const double heavy : {1.0, 1e3, 1e9}) {
            const auto what = std::to_string(light) + ", " + std::to_string(heavy);
            expectLength(weightedPiece({{0, 0}, {3, 0}, {4, 0}}, {light, heavy, heavy}), 4, what);
            expectLength(weightedPiece({{0, 0}, {1, 0}, {4, 0}}, {heavy, heavy, light}), 4, what);
            expectLength(weightedPiece({{0, 0}, {1, 0}, {4, 0}}, {heavy, light, heavy}), 4, what);
        }
    }
}

TEST(RationalLength, ofAnArchNearItsPolygon) {
    // By the trapezoidal rule over log(u / (1 - u)), with 64-bit mantissas.
    const std::vector<std::pair<double, double>> known = {{1, 5.2575682721796267},
                                                          {1e3, 7.4002076496661794},
                                                          {1e5, 7.4048711873217332},
                                                          {1e7, 7.4049178756827005},
                                                          {1e9, 7.4049183425716143}};
    for (const auto& [weight, wanted] : known) {
        expectLength(weightedPiece({{0, 0}, {1, 3}, {4, 0}}, {1, weight, 1}), wanted,
                     std::to_string(weight));
    }
}

TEST(RationalLength, isOfThePieceWhereItsPolygonIsMuchLonger) {
    // All but a line from 0 to m and back to 4, where m is the larger root of
    // 4 m (m - 4) = (2e-9 m - 2e-3)^2.
    double m = 4;
    for (int step = 0; step < 9; ++step) {
        m = 4 + std::pow(2e-9 * m - 2e-3, 2) / (4 * m);
    }
    expectLength(weightedPiece({{0, 0}, {1e6, 0}, {4, 0}}, {1, 1e-9, 1}), 2 * m - 4, "far");
}

/// The quarter of a circle, whose Bézier points have the weights 1, sqrt(2) times c, 2 times c^2:
/// another parameter of the same shape.
Pieces quarterWith(double c) {
    return weightedPiece({{1, 0}, {1, 1}, {0, 1}}, {1 / c, std::numbers::sqrt2 / 2, c});
}

TEST(RationalLength, ofAQuarterCircleWhateverItsParameter) {
    for (const double c : {1e-9, 1e-6, 1e-3, 1.0, 1e3, 1e6, 1e9}) {
        const Pieces pieces = quarterWith(c);
        expectLength(pieces, std::numbers::pi / 2, std::to_string(c));
        const ArcLength lengths(pieces);
        // u and 1 - u swap sides: where numbers lie less dense, spots are as near as these allow.
        const double fastest = 2 * std::max(1.0, 1 / (c * c));
        const double nearest = 1e-14 + (c < 1 ? fastest * 0x1p-53 : 0);
        std::vector<double> asked;
        for (int i = 0; i <= 200; ++i) {
            asked.push_back(i * lengths.total() / 200);
        }
        const auto spots = lengths.spotsAt(asked);
        for (std::size_t i = 0; i < asked.size(); ++i) {
            for (const auto& spot : {spots[i], lengths.spotAt(asked[i])}) {
                const Point place = pieces.position(spot);
                EXPECT_NEAR(std::atan2(place[1], place[0]), asked[i], nearest) << c << " " << i;
                EXPECT_NEAR(lengths.upTo(spot), asked[i], nearest) << c << " " << i;
            }
        }
    }
}

/// The length by the trapezoidal rule over s = log(u / (1 - u)), in which peaks at the ends are as
/// wide as any other.
double trapezoidal(const Piece& piece) {
    using Real = long double;
    constexpr int stepsAUnit = 32, units = 80;
    std::vector<Point> places;
    for (int i = 0; i <= piece.degree; ++i) {
        places.push_back(piece.bezierPoint(i));
    }
    Real sum = 0;
    for (int k = -units * stepsAUnit; k <= units * stepsAUnit; ++k) {
        const Real s = static_cast<Real>(k) / stepsAUnit;
        const Real u = 1 / (1 + std::exp(-s)), v = 1 / (1 + std::exp(s));
        std::vector<Real> shares; // of the points, times their weights
        Real whole = 0, binomial = 1;
        for (int i = 0; i <= piece.degree; ++i) {
            shares.push_back(binomial * std::pow(u, i) * std::pow(v, piece.degree - i) *
                             piece.weight(i));
            whole += shares.back();
            binomial = binomial * (piece.degree - i) / (i + 1);
        }
        Real square = 0;
        for (int c = 0; c < piece.dimension; ++c) {
            Real rate = 0; // du / ds is u (1 - u)
            for (std::size_t j = 1; j < places.size(); ++j) {
                for (std::size_t i = 0; i < j; ++i) {
                    rate += static_cast<Real>(j - i) * shares[i] * shares[j] *
                            (static_cast<Real>(places[j][c]) - places[i][c]);
                }
            }
            square += rate * rate;
        }
        sum += std::sqrt(square) / (whole * whole);
    }
    return static_cast<double>(sum / stepsAUnit);
}

/// Random weights of any size; x grows, so that there is no cusp to make the trapezoidal rule err.
Pieces randomWeightedPiece(Dice& dice) {
    Points points(2);
    std::vector<double> weights;
    const int degree = dice.whole(1, 6);
    double x = dice.between(-3, 3);
    for (int i = 0; i <= degree; ++i) {
        points.append({x, dice.between(-0.5, 0.5)});
        x += dice.between(0.5, 1.5);
        weights.push_back(std::pow(10, dice.between(-9, 9)));
    }
    return weightedPiece(points, std::move(weights));
}

TEST(RationalLength, isRightForAllWeights) {
    Dice dice(77);
    for (int i = 0; i < casesOf(40); ++i) {
        const Pieces pieces = randomWeightedPiece(dice);
        expectLength(pieces, trapezoidal(pieces[0]), "case " + std::to_string(i));
    }
}

TEST(RationalLength, leadsToTheNearestSpotThatUCanSay) {
    Dice dice(78);
    for (int i = 0; i < casesOf(200); ++i) {
        const Pieces pieces = randomWeightedPiece(dice);
        const ArcLength lengths(pieces);
        const double tolerance = 1e-14 * lengths.total();
        std::vector<double> asked;
        for (int k = 0; k <= 100; ++k) {
            asked.push_back(k * lengths.total() / 100);
        }
        const auto spots = lengths.spotsAt(asked);
        for (std::size_t k = 0; k < asked.size(); ++k) {
            for (const double u : {spots[k].u, lengths.spotAt(asked[k]).u}) {
                const double before = std::nextafter(u, 0),
                             after = std::min(std::nextafter(u, 2), 1.0);
                ASSERT_LE(lengths.upTo({0, before}), asked[k] + tolerance) << i << " " << k;
                ASSERT_GE(lengths.upTo({0, after}), asked[k] - tolerance) << i << " " << k;
            }
        }
    }
}

} // namespace
} // namespace splineloft
