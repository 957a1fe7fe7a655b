// Awkward input: hardly any points, points on top of each other, huge and tiny coordinates. No
// family may throw, divide by zero or say something that is not a number.
#include "tests/property/random_curves.h"

#include "core/spline/catalog.h"
#include "core/spline/measure/length.h"
#include "core/spline/measure/nearest.h"
#include "core/spline/measure/sample.h"
#include "core/spline/problem.h"
#include "core/spline/traits.h"

#include <algorithm>
#include <cmath>

namespace splineloft::testing_curves {
namespace {

class Degenerate : public EveryFamily {};

bool finite(const Point& p) {
    return std::ranges::all_of(p.coordinates(), [](double x) { return std::isfinite(x); });
}

void expectFiniteJets(const Pieces& pieces) {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (const double u : {0.0, 0.25, 0.6, 1.0}) {
            const Jet byU = pieces.jet({i, u});
            const Jet byT = pieces.jetByParameter({i, u});
            const auto where = "segment " + std::to_string(i) + " u " + std::to_string(u);
            EXPECT_TRUE(finite(byU.position)) << where;
            EXPECT_TRUE(finite(byU.first) && finite(byU.second)) << where;
            EXPECT_TRUE(finite(byT.first) && finite(byT.second)) << where << " by t";
            EXPECT_TRUE(!byU.curvature || std::isfinite(*byU.curvature)) << where << " curvature";
        }
    }
}

void expectFiniteJoints(const Pieces& pieces, bool closed) {
    for (const auto& joint : jointsOf(pieces, closed)) {
        for (const double measure : {joint.t, joint.gap, joint.firstJump, joint.secondJump,
                                     joint.turn, joint.curvatureJump, joint.speedRatio}) {
            EXPECT_TRUE(std::isfinite(measure)) << "joint at " << joint.t;
        }
        const auto words = describe(joint);
        EXPECT_EQ(words.find("nan"), std::string::npos) << words;
        EXPECT_EQ(words.find("inf"), std::string::npos) << words;
        EXPECT_GE(joint.c, 0) << "t " << joint.t << ": " << words;
    }
}

/// Everything that can be asked of a curve has a finite answer.
void expectFinite(const Curve& curve) {
    const auto problem = problemOf(curve);
    ASSERT_FALSE(problem) << problem->place << ' ' << problem->what;
    const Pieces pieces = piecesOf(curve);
    const BlendPieces blends = blendsOf(curve);
    ASSERT_EQ(pieces.size(), blends.size());
    expectFiniteJets(pieces);
    expectFiniteJoints(pieces, curve.closed);
    for (std::size_t i = 0; i < blends.size(); ++i) {
        for (const auto& blend : blends[i]) {
            for (const auto& share : blend.shares()) {
                EXPECT_TRUE(std::isfinite(share.weight)) << "weights of segment " << i;
            }
        }
    }
    const ArcLength lengths(pieces);
    EXPECT_TRUE(std::isfinite(lengths.total()));
    for (const auto even : {Even::parameter, Even::length}) {
        for (const auto& sample : samplesAt(pieces, lengths, spread(pieces, lengths, even, 7))) {
            EXPECT_TRUE(finite(sample.position) && finite(sample.tangent));
            EXPECT_TRUE(std::isfinite(sample.t) && std::isfinite(sample.length));
            EXPECT_LT(sample.spot.segment, pieces.size());
            EXPECT_GE(sample.spot.u, 0);
            EXPECT_LE(sample.spot.u, 1);
        }
    }
    const auto nearest = nearestTo(pieces, Point(pieces.dimension()));
    EXPECT_EQ(nearest.has_value(), !pieces.empty());
    EXPECT_TRUE(!nearest || std::isfinite(nearest->distance));
    traitsOf(curve, pieces, blends);
}

/// How many pieces the promise is: open cubics n - 3 with open ends, n - 1 with extended ones, n
/// closed; and so on for other windows.
std::size_t promisedPieces(const Curve& curve) {
    const auto n = curve.points.size();
    const auto layout = layoutOf(curve);
    const auto window = static_cast<std::size_t>(layout.window);
    const auto stride = static_cast<std::size_t>(layout.stride);
    if (n < 2) {
        return 0;
    }
    if (curve.closed) {
        return n / stride;
    }
    const bool extended = curve.ends == Ends::doubled || curve.ends == Ends::reflected;
    const auto read = n + (extended ? 2 * ((window - 1) / 2) : 0);
    return read < window ? 0 : (read - window) / stride + 1;
}

TEST_P(Degenerate, fewPoints) {
    for (const auto& form : formsOf(GetParam())) {
        for (std::size_t n = 0; n <= 9; ++n) {
            Dice dice(n + 1);
            Curve curve = emptyCurve(form, 2);
            rollParameters(curve, dice);
            rollPoints(curve, n, {70, -90}, 6, dice);
            SCOPED_TRACE(wordsOf(curve));
            EXPECT_EQ(piecesOf(curve).size(), promisedPieces(curve));
            EXPECT_EQ(piecesOf(curve).empty(), n < fewestPoints(curve));
            expectFinite(curve);
        }
    }
}

TEST(Promise, openCubicsHaveThreePiecesLessThanPoints) {
    for (const auto* family : {"cardinal", "catmull-rom", "b-spline", "duff", "beta"}) {
        Dice dice(2);
        for (std::size_t n = 2; n < 9; ++n) {
            Curve curve = emptyCurve({family, false, Ends::open}, 2);
            rollPoints(curve, n, {70, -90}, 6, dice);
            EXPECT_EQ(piecesOf(curve).size(), n < 4 ? 0 : n - 3) << family << ' ' << n;
            curve.ends = Ends::doubled;
            EXPECT_EQ(piecesOf(curve).size(), n - 1) << family << ' ' << n;
            curve.ends = Ends::reflected;
            EXPECT_EQ(piecesOf(curve).size(), n - 1) << family << ' ' << n;
            curve.closed = true;
            EXPECT_EQ(piecesOf(curve).size(), n) << family << ' ' << n;
        }
    }
}

TEST_P(Degenerate, coincidentPoints) {
    for (const auto& form : formsOf(GetParam())) {
        for (std::uint64_t seed = 0; seed < 60; ++seed) {
            Dice dice(seed + 100);
            Curve curve = randomCurve(form, seed);
            const bool chords = familyOf(curve).spacing != Spacing::uniform;
            if (chords) {
                curve.parameters["alpha"] = 0.25 * dice.whole(0, 4);
            }
            // A few points jump onto others, often onto their neighbours.
            const int n = static_cast<int>(curve.points.size());
            for (int k = dice.whole(1, n); k > 0; --k) {
                const auto from = static_cast<std::size_t>(dice.whole(0, n - 1));
                const auto to = dice.oneIn(2) ? (from + 1) % curve.points.size()
                                              : static_cast<std::size_t>(dice.whole(0, n - 1));
                curve.points.set(to, curve.points.at(from));
            }
            SCOPED_TRACE(wordsOf(curve) + " seed " + std::to_string(seed));
            expectFinite(curve);
        }
    }
}

TEST_P(Degenerate, allPointsInOnePlace) {
    for (const auto& form : formsOf(GetParam())) {
        for (const double alpha : {0.0, 0.25, 0.5, 1.0}) {
            Curve curve = emptyCurve(form, 3);
            if (familyOf(curve).spacing != Spacing::uniform) {
                curve.parameters["alpha"] = alpha;
            }
            const Point place = {17, -4, 900.5};
            for (int i = 0; i < 7; ++i) {
                curve.points.append(place);
                if (familyOf(curve).usesTangents) {
                    curve.tangents.append(Point(3));
                }
            }
            SCOPED_TRACE(wordsOf(curve));
            expectFinite(curve);
            const Pieces pieces = piecesOf(curve);
            for (std::size_t i = 0; i < pieces.size(); ++i) {
                expectNear(pieces.position({i, 0.3}), place, 1e-12, "the one place");
            }
            EXPECT_NEAR(ArcLength(pieces).total(), 0, 1e-11);
        }
    }
}

TEST_P(Degenerate, nearlyCoincidentPoints) {
    for (const auto& form : formsOf(GetParam())) {
        for (const double gap : {1e-3, 1e-9, 1e-15, 1e-160, 1e-310}) {
            for (const double alpha : {0.0, 0.5, 1.0}) {
                Curve curve = emptyCurve(form, 2);
                if (familyOf(curve).spacing != Spacing::uniform) {
                    curve.parameters["alpha"] = alpha;
                }
                Dice dice(9);
                rollPoints(curve, 8, {0, 0}, 5, dice);
                curve.points.set(0, {0, 0});
                curve.points.set(1, {gap, -gap});
                curve.points.set(2, {gap, 0});
                SCOPED_TRACE(wordsOf(curve) + " gap " + std::to_string(std::log10(gap)));
                expectFinite(curve);
                const Traits traits = traitsOf(curve, piecesOf(curve), blendsOf(curve));
                EXPECT_TRUE(traits.affine);
            }
        }
    }
}

/// Documents allow coordinates to 1e9; the library itself goes much farther.
TEST_P(Degenerate, hugeAndTinyCoordinates) {
    for (const auto& form : formsOf(GetParam())) {
        const double most = findFamily(GetParam())->mostCoordinate;
        for (const double size : {1e9, 1e100, most, 1e-9, 1e-100, 1e-300, 1e-310}) {
            Dice dice(6);
            Curve curve = emptyCurve(form, 2);
            rollParameters(curve, dice);
            for (int i = 0; i < 8; ++i) {
                curve.points.append(size * dice.pointOnGrid(2, 1));
                if (familyOf(curve).usesTangents) {
                    curve.tangents.append(size * dice.pointOnGrid(2, 1));
                }
            }
            SCOPED_TRACE(wordsOf(curve) + " size 1e" + std::to_string(std::log10(size)));
            expectFinite(curve);
        }
    }
}

/// One of the bounds of a parameter.
double eitherEnd(const Parameter& parameter, Dice& dice) {
    return dice.oneIn(2) ? parameter.least : parameter.most;
}

/// Everything at its bounds at once: coordinates, parameters, values at each point and weights.
TEST_P(Degenerate, greatestCoordinatesWithParametersAtTheirEnds) {
    const Family& family = *findFamily(GetParam());
    for (const auto& form : formsOf(GetParam())) {
        for (int round = 0; round < roundsOf(40); ++round) {
            Dice dice(static_cast<std::uint64_t>(round) + 300);
            Curve curve = emptyCurve(form, 2);
            const double size = dice.oneIn(4) ? 0.1 * family.mostCoordinate : family.mostCoordinate;
            const auto corner = [&] {
                return size * Point{dice.oneIn(2) ? 1.0 : -1.0, dice.oneIn(2) ? 1.0 : -1.0};
            };
            // Enough for degree 25, and no more than a polynomial through all points can bear.
            const int count = family.usesKnots ? 30 : 8;
            for (int i = 0; i < count; ++i) {
                curve.points.append(corner());
                if (family.usesTangents) {
                    curve.tangents.append(corner());
                }
                if (family.usesWeights) {
                    curve.weights.push_back(dice.oneIn(2) ? 1e-9 : 1e9);
                }
            }
            const bool varies = dice.oneIn(2);
            for (const auto& parameter : family.parameters) {
                curve.parameters[std::string(parameter.key)] = eitherEnd(parameter, dice);
                for (int i = 0; i < count && varies && parameter.local; ++i) {
                    curve.local[std::string(parameter.key)].push_back(eitherEnd(parameter, dice));
                }
            }
            SCOPED_TRACE(wordsOf(curve) + " round " + std::to_string(round));
            const auto problem = problemOf(curve);
            ASSERT_FALSE(problem) << problem->place << ' ' << problem->what;
            expectFiniteJets(piecesOf(curve));
            if (HasFailure()) {
                return;
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Families, Degenerate, testing::ValuesIn(familyIds()), testNameOf);

} // namespace
} // namespace splineloft::testing_curves
