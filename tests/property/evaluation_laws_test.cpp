// Whatever the family: the ladder's tip is the Bernstein sum, derivatives are the limits of
// differences, and the blends of the controls give the same curve as the coordinates do.
#include "core/spline/algebra/scale.h"
#include "core/spline/shape/hodograph.h"
#include "tests/property/random_curves.h"

#include <cmath>
#include <limits>

namespace splineloft::testing_curves {
namespace {

class Evaluation : public EveryFamily {};

/// Places along a piece: its ends, and no places where powers of u are round.
const std::vector<double> awkward = {0, 0.1, 1.0 / 3, 0.61803398874989485, 0.9375, 1};

double farthestCoordinate(const Piece& piece) {
    double size = 0;
    for (const double x : piece.coordinates) {
        size = std::max(size, std::abs(x));
    }
    return size;
}

/// The sum of Bernstein polynomials times Bézier points (lecture, equation 9), term by term.
Point bernsteinSum(const Piece& piece, double u) {
    Point sum(piece.dimension);
    double binomial = 1;
    for (int i = 0; i <= piece.degree; ++i) {
        sum +=
            (binomial * std::pow(u, i) * std::pow(1 - u, piece.degree - i)) * piece.bezierPoint(i);
        binomial = binomial * (piece.degree - i) / (i + 1);
    }
    return sum;
}

/// A bound of the `order`th derivative by u: degree! / (degree - order)! times the largest
/// difference of that order among the Bézier points.
double derivativeBound(const Piece& piece, int order) {
    std::vector<double> differences(piece.coordinates.begin(), piece.coordinates.end());
    const auto width = static_cast<std::size_t>(piece.dimension);
    double factor = 1;
    for (int k = 0; k < order; ++k) {
        factor *= std::max(0, piece.degree - k);
        for (std::size_t i = 0; i + width < differences.size(); ++i) {
            differences[i] = differences[i + width] - differences[i];
        }
        differences.resize(differences.size() > width ? differences.size() - width : 0);
    }
    double most = 0;
    for (const double d : differences) {
        most = std::max(most, std::abs(d));
    }
    return factor * most;
}

TEST_P(Evaluation, ladderTipIsTheBernsteinSum) {
    forEveryForm(GetParam(), usualRounds, [](const Curve& curve) {
        const Pieces pieces = piecesOf(curve);
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            const Piece piece = pieces[i];
            // A level of the ladder usualRounds twice; the sum usualRounds its powers once a
            // factor.
            const double tolerance = 8 * (piece.degree + 1) * epsilon * farthestCoordinate(piece);
            for (const double u : awkward) {
                const auto where = "segment " + std::to_string(i) + " u " + std::to_string(u);
                expectNear(piece.ladder(u).tip(), bernsteinSum(piece, u), tolerance, where);
                EXPECT_EQ(piece.ladder(u).tip(), piece.position(u)) << where;
                EXPECT_EQ(piece.ladder(u).degree(), piece.degree) << where;
            }
            EXPECT_EQ(piece.position(0), piece.bezierPoint(0));
            EXPECT_EQ(piece.position(1), piece.bezierPoint(piece.degree));
        }
    });
}

TEST_P(Evaluation, derivativesAreLimitsOfDifferences) {
    constexpr double h = 1.0 / 1024; // makes truncation and rounding of the second about equal
    forEveryForm(GetParam(), usualRounds, [](const Curve& curve) {
        const Pieces pieces = piecesOf(curve);
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            const Piece piece = pieces[i];
            const double rounding = 8 * (piece.degree + 1) * epsilon * farthestCoordinate(piece);
            // Taylor: the central differences miss the derivatives by h^2 / 6 times the third and
            // h^2 / 12 times the fourth. Away from the ends u +- h stays where the bounds hold.
            const double first = h * h / 6 * derivativeBound(piece, 3) + rounding / h;
            const double second = h * h / 12 * derivativeBound(piece, 4) + 4 * rounding / (h * h);
            for (const double u : {0.1, 1.0 / 3, 0.61803398874989485, 0.9375}) {
                const auto where = "segment " + std::to_string(i) + " u " + std::to_string(u);
                const Point before = piece.position(u - h);
                const Point here = piece.position(u);
                const Point after = piece.position(u + h);
                const Jet jet = piece.jet(u);
                expectNear(jet.first, (1 / (2 * h)) * (after - before), first, where + " first");
                expectNear(jet.second, (1 / (h * h)) * ((after - here) - (here - before)), second,
                           where + " second");
            }
        }
    });
}

TEST_P(Evaluation, hodographIsTheCurveOfTheDerivative) {
    forEveryForm(GetParam(), usualRounds, [](const Curve& curve) {
        const Pieces pieces = piecesOf(curve);
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            const Piece piece = pieces[i];
            const Pieces derivative = splineloft::hodograph(piece);
            const Piece hodograph = derivative[0];
            const double tolerance =
                8 * piece.degree * (piece.degree + 1) * epsilon * farthestCoordinate(piece);
            for (const double u : awkward) {
                const Jet jet = piece.jet(u);
                const auto where = "segment " + std::to_string(i) + " u " + std::to_string(u);
                expectNear(jet.first, hodograph.position(u), tolerance, where);
                expectNear(jet.second, hodograph.jet(u).first, 2 * piece.degree * tolerance, where);
            }
        }
    });
}

TEST_P(Evaluation, derivativesByParameterFollowTheChainRule) {
    forEveryForm(GetParam(), usualRounds, [](const Curve& curve) {
        const Pieces pieces = piecesOf(curve);
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            const double interval = pieces.knots().interval(i);
            const Jet byU = pieces.jet({i, 0.3});
            const Jet byT = pieces.jetByParameter({i, 0.3});
            ASSERT_GT(interval, 0);
            expectNear(interval * byT.first, byU.first, 4 * epsilon * norm(byU.first), "first");
            expectNear(interval * interval * byT.second, byU.second, 8 * epsilon * norm(byU.second),
                       "second");
            EXPECT_EQ(byT.curvature, byU.curvature) << "curvature knows no parameter";
        }
    });
}

TEST_P(Evaluation, blendsGiveTheSameCurveAsCoordinates) {
    forEveryForm(GetParam(), usualRounds, [](const Curve& curve) {
        const Pieces pieces = piecesOf(curve);
        const BlendPieces blends = blendsOf(curve);
        ASSERT_EQ(pieces.size(), blends.size());
        ASSERT_EQ(pieces.degree(), blends.degree());
        const auto n = curve.points.size();
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            for (const double u : awkward) {
                Point blended(curve.points.dimension());
                const Blend basis = blends.basis({i, u});
                for (const auto& [control, weight] : basis.shares()) {
                    ASSERT_LT(control, familyOf(curve).usesTangents ? 2 * n : n);
                    blended += weight * (control < n ? curve.points.at(control)
                                                     : curve.tangents.at(control - n));
                }
                expectNear(blended, pieces.position({i, u}), 2 * roundingOf(curve, blends),
                           "segment " + std::to_string(i) + " u " + std::to_string(u));
            }
        }
    });
}

INSTANTIATE_TEST_SUITE_P(Families, Evaluation, testing::ValuesIn(familyIds()), testNameOf);

} // namespace
} // namespace splineloft::testing_curves
