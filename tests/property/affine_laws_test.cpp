// Moving, turning and stretching the control points moves, turns and stretches the curve. All maps
// used here take the points exactly to points, so that what differs is the curve's own rounding.
#include "core/spline/algebra/scale.h"
#include "tests/property/random_curves.h"

#include <cmath>
#include <limits>

namespace splineloft::testing_curves {
namespace {

class Affine : public EveryFamily {};

/// Shears with whole-number factors: coordinate c gains k times the next. It keeps no lengths.
Point sheared(const Point& p) {
    Point result = p;
    for (int c = 0; c + 1 < p.dimension(); ++c) {
        result[c] += (c % 2 == 0 ? 2 : -1) * p[c + 1];
    }
    return result;
}

/// Turns each pair of coordinates by the angle of the triangle 3, 4, 5 and grows fivefold: a
/// similarity in whole numbers, after which all chords are five times as long.
Point turned(const Point& p) {
    Point result = 5.0 * p;
    for (int c = 0; c + 1 < p.dimension(); c += 2) {
        result[c] = 3 * p[c] - 4 * p[c + 1];
        result[c + 1] = 4 * p[c] + 3 * p[c + 1];
    }
    return result;
}

template <class Map> Curve mapped(const Curve& curve, Map map, const Point& shift) {
    Curve result = curve;
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
        result.points.set(i, map(curve.points.at(i)) + shift);
        if (!curve.tangents.empty()) {
            result.tangents.set(i, map(curve.tangents.at(i)));
        }
    }
    return result;
}

/// Compares the Bézier points of the mapped curve with the mapped Bézier points of the curve.
template <class Map>
void expectCommutes(const Curve& curve, Map map, const Point& shift, double growth) {
    const Curve image = mapped(curve, map, shift);
    const Pieces before = piecesOf(curve);
    const Pieces after = piecesOf(image);
    const BlendPieces blends = blendsOf(curve);
    ASSERT_EQ(before.size(), after.size());
    const double tolerance = growth * roundingOf(curve, blends) + roundingOf(image, blends) +
                             2 * epsilon * farthest(image);
    for (std::size_t i = 0; i < before.size(); ++i) {
        for (int k = 0; k <= before.degree(); ++k) {
            expectNear(after[i].bezierPoint(k), map(before[i].bezierPoint(k)) + shift, tolerance,
                       "segment " + std::to_string(i) + " Bézier point " + std::to_string(k));
        }
    }
}

TEST_P(Affine, weightsSumToOne) {
    forEveryForm(GetParam(), usualRounds, [](const Curve& curve) {
        const BlendPieces blends = blendsOf(curve);
        const double tolerance = 8 * (blends.degree() + 5) * epsilon * amplification(blends);
        for (std::size_t i = 0; i < blends.size(); ++i) {
            for (const double u : {0.0, 0.1, 1.0 / 3, 0.7, 1.0}) {
                EXPECT_NEAR(blends.basis({i, u}).sumBelow(curve.points.size()), 1, tolerance)
                    << "segment " << i << " u " << u;
            }
        }
    });
}

TEST_P(Affine, movesWithItsPoints) {
    forEveryForm(GetParam(), usualRounds, [](const Curve& curve) {
        Dice dice(curve.points.size());
        const Point shift = dice.pointOnGrid(curve.points.dimension(), 1000);
        expectCommutes(curve, [](const Point& p) { return p; }, shift, 1);
    });
}

TEST_P(Affine, turnsAndGrowsWithItsPoints) {
    forEveryForm(GetParam(), usualRounds, [](const Curve& curve) {
        expectCommutes(curve, turned, Point(curve.points.dimension()), 7); // 3 + 4
    });
}

TEST_P(Affine, shearsWithItsPoints) {
    forEveryForm(GetParam(), usualRounds, [](const Curve& curve) {
        if (!knotsFollowPoints(curve)) {
            expectCommutes(curve, sheared, Point(curve.points.dimension()), 3);
        }
    });
}

TEST_P(Affine, doublesExactly) {
    forEveryForm(GetParam(), usualRounds, [](const Curve& curve) {
        if (knotsFollowPoints(curve)) {
            return; // powers of chords round
        }
        const auto doubled = [](const Point& p) { return 2.0 * p; };
        const Pieces before = piecesOf(curve);
        const Pieces after = piecesOf(mapped(curve, doubled, Point(curve.points.dimension())));
        for (std::size_t i = 0; i < before.size(); ++i) {
            EXPECT_EQ(after.position({i, 0.3}), 2.0 * before.position({i, 0.3})) << i;
        }
    });
}

TEST_P(Affine, splinesEachCoordinateByItself) {
    forEveryForm(GetParam(), usualRounds, [](const Curve& curve) {
        if (knotsFollowPoints(curve)) {
            return; // the chords of one coordinate are others
        }
        const Pieces together = piecesOf(curve);
        for (int c = 0; c < curve.points.dimension(); ++c) {
            Curve alone = curve;
            alone.points = Points(1);
            alone.tangents = Points(1);
            alone.coordinates = {"x"};
            for (std::size_t i = 0; i < curve.points.size(); ++i) {
                alone.points.append(Point{curve.points.at(i)[c]});
                if (!curve.tangents.empty()) {
                    alone.tangents.append(Point{curve.tangents.at(i)[c]});
                }
            }
            const Pieces single = piecesOf(alone);
            for (std::size_t i = 0; i < together.size(); ++i) {
                EXPECT_EQ(single.position({i, 0.3})[0], together.position({i, 0.3})[c]);
            }
        }
    });
}

/// Control points evenly along a line give even motion along it (linear precision), where the
/// basis reproduces lines and the ends are mirrored.
TEST(LinearPrecision, evenPointsGiveEvenMotion) {
    const std::vector<std::string> families = {"linear",   "cardinal", "catmull-rom", "natural",
                                               "b-spline", "duff",     "beta"};
    for (const auto& id : families) {
        for (const int degree : {1, 2, 3, 4, 5}) {
            const bool mirrors = formsOf(id).front().ends != Ends::none;
            Curve curve = emptyCurve({id, false, mirrors ? Ends::reflected : Ends::none}, 2);
            if (id == "b-spline") {
                curve.parameters["degree"] = degree;
            }
            for (int i = 0; i < 9; ++i) {
                curve.points.append({100.0 + 3 * i, -7.0 + 5 * i});
            }
            const Pieces pieces = piecesOf(curve);
            const double tolerance = roundingOf(curve, blendsOf(curve)) * 25;
            const Jet first = pieces.jetByParameter({0, 0});
            for (std::size_t i = 0; i < pieces.size(); ++i) {
                const Jet jet = pieces.jetByParameter({i, 0.3});
                expectNear(jet.first, first.first, tolerance, wordsOf(curve));
                expectNear(jet.second, Point(2), 6 * tolerance, wordsOf(curve));
            }
        }
    }
}

/// The tensions that leave lines alone are the neutral ones: with others the motion is uneven,
/// though along the same line.
TEST(LinearPrecision, tensionKeepsTheLineButNotThePace) {
    const std::map<std::string, double> tight = {{"cardinal", 0.9}, {"duff", 0.3}, {"beta", 8}};
    for (const auto& [id, tension] : tight) {
        Curve curve = emptyCurve({id, false, Ends::reflected}, 2);
        curve.parameters["tension"] = tension;
        for (int i = 0; i < 7; ++i) {
            curve.points.append({100.0 + 3 * i, -7.0 + 5 * i});
        }
        const Pieces pieces = piecesOf(curve);
        const Jet jet = pieces.jet({3, 0.25});
        const Jet middle = pieces.jet({3, 0.5});
        EXPECT_NEAR(jet.first[0] * 5, jet.first[1] * 3, 1e-12) << id;
        EXPECT_GT(distance(jet.first, middle.first), 0.1) << id;
    }
}

INSTANTIATE_TEST_SUITE_P(Families, Affine, testing::ValuesIn(familyIds()), testNameOf);

} // namespace
} // namespace splineloft::testing_curves
