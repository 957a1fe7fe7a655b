#include "core/spline/curve.h"

#include "tests/property/random_curves.h"

#include <cmath>

namespace splineloft {
namespace {

using namespace testing_curves;

Curve naturalThrough(int count, bool closed, double alpha, Dice& dice) {
    Curve curve;
    curve.family = "natural";
    curve.closed = closed;
    curve.ends = familyOf(curve).ends.front();
    curve.parameters["alpha"] = alpha;
    for (int i = 0; i < count; ++i) {
        curve.points.append({dice.between(-1, 1), dice.between(-1, 1)});
    }
    return curve;
}

TEST(BlendsOfAPiece, ofNaturalCurvesGiveTheirPlaces) {
    Dice dice(3);
    for (const int count : {3, 4, 5, 30, 200}) {
        for (const bool closed : {false, true}) {
            for (const double alpha : {0.0, 0.5, 1.0}) {
                const Curve curve = naturalThrough(count, closed, alpha, dice);
                const Pieces pieces = piecesOf(curve);
                for (std::size_t i = 0; i < pieces.size(); ++i) {
                    const Blend basis = blendsOfPiece(curve, i).basis({0, 0.3});
                    Point place{0, 0};
                    double size = 1;
                    for (const auto& share : basis.shares()) {
                        place += share.weight * curve.points.at(share.control);
                        size += std::abs(share.weight);
                    }
                    EXPECT_LE(distance(place, pieces.position({i, 0.3})), 1e-14 * size) << i;
                    EXPECT_NEAR(basis.sumBelow(curve.points.size()), 1, 1e-14 * size) << i;
                }
            }
        }
    }
}

TEST(BlendsOfAPiece, areThoseOfTheWholeCurve) {
    Dice dice(4);
    for (const bool closed : {false, true}) {
        const Curve curve = naturalThrough(40, closed, 0.5, dice);
        const BlendPieces all = blendsOf(curve);
        for (std::size_t i = 0; i < all.size(); ++i) {
            EXPECT_EQ(blendsOfPiece(curve, i).basis({0, 0.7}), all.basis({i, 0.7})) << i;
        }
    }
}

TEST(BlendsOfAPiece, needMemoryForOneRowOnly) {
    // All rows would be 10^10 weights.
    Dice dice(5);
    const Curve curve = naturalThrough(100'000, true, 0, dice);
    const Blend basis = blendsOfPiece(curve, 50'000).basis({0, 0.5});
    EXPECT_NEAR(basis.sumBelow(curve.points.size()), 1, 1e-13);
    // Known from the cardinal spline of whole numbers: weights fall by 2 - sqrt(3) with every
    // point.
    EXPECT_NEAR(basis.weight(50'003) / basis.weight(50'002), std::sqrt(3.0) - 2, 1e-12);
}

} // namespace
} // namespace splineloft
