// What geometric operations promise, on a hundred thousand random curves.
#include "tests/cases.h"
#include "tests/property/random_pieces.h"

#include "core/spline/measure/nearest.h"
#include "core/spline/shape/flatten.h"
#include "core/spline/shape/intersect.h"
#include "core/spline/shape/osculating.h"
#include "core/spline/shape/self_intersect.h"
#include "core/spline/shape/subdivide.h"
#include "core/spline/shape/turning.h"

#include <algorithm>
#include <cmath>

namespace splineloft::testing_curves {
namespace {

/// Calls `law(pieces, dice)` with as many random curves as `casesOf(rounds)`, until one fails.
template <class Law> void forRandomPieces(int rounds, const Variety& variety, Law law) {
    for (int round = 0; round < casesOf(rounds); ++round) {
        const auto seed = static_cast<std::uint64_t>(round) * 104729 + 3;
        Dice dice(seed);
        const Pieces pieces = randomPieces(dice, variety);
        law(pieces, dice);
        if (testing::Test::HasFatalFailure() || testing::Test::HasNonfatalFailure()) {
            ADD_FAILURE() << "seed " << seed << ": " << wordsOf(pieces);
            return;
        }
    }
}

Spot randomSpot(const Pieces& pieces, Dice& dice) {
    const auto last = static_cast<int>(pieces.size()) - 1;
    const double ends[] = {0, 1, 0.5};
    return {static_cast<std::size_t>(dice.whole(0, last)),
            dice.oneIn(8) ? ends[dice.whole(0, 2)] : dice.between(0, 1)};
}

bool comesBefore(Spot a, Spot b) {
    return a.segment < b.segment || (a.segment == b.segment && a.u < b.u);
}

double pieceRounding(const Pieces& pieces) {
    return 4e-15 * (1 + farthest(pieces)) * (pieces.degree() + 1);
}

/// Both curves are at the same places at the same parameter values, between two of these.
void expectSameCurve(const Pieces& ours, const Pieces& wanted, double from, double to,
                     const std::string& what) {
    // By position and not by spot: a knot more moves the bounds of pieces by rounding.
    const double tolerance = 40 * pieceRounding(wanted);
    for (int k = 0; k <= 6; ++k) {
        const double t = from + (to - from) * (0.003 + 0.994 * k / 6);
        expectNear(ours.position(ours.knots().locate(t)), wanted.position(wanted.knots().locate(t)),
                   tolerance, what + " at t " + std::to_string(t));
    }
}

TEST(OperationLaws, subdividingLeavesTheCurve) {
    forRandomPieces(100'000, {.dimension = 3}, [](const Pieces& pieces, Dice& dice) {
        const Spot spot = randomSpot(pieces, dice);
        const Pieces cut = subdivided(pieces, spot);
        const bool atJoint = spot.u == 0 || spot.u == 1;
        ASSERT_EQ(cut.size(), pieces.size() + (atJoint ? 0 : 1));
        expectSameCurve(cut, pieces, pieces.knots().start(), pieces.knots().end(), "subdivided");
        if (!atJoint) {
            EXPECT_EQ(cut.knots().knots()[spot.segment + 1], pieces.knots().parameter(spot));
            expectNear(cut.position({spot.segment, 1}), pieces.position(spot),
                       pieceRounding(pieces), "the spot");
        }
    });
}

TEST(OperationLaws, aPartIsTheCurveBetweenTwoSpots) {
    forRandomPieces(100'000, {.dimension = 3}, [](const Pieces& pieces, Dice& dice) {
        Spot from = randomSpot(pieces, dice), to = randomSpot(pieces, dice);
        if (comesBefore(to, from)) {
            std::swap(from, to);
        }
        const Pieces middle = part(pieces, from, to);
        const double start = pieces.knots().parameter(from);
        const double end = pieces.knots().parameter(to);
        if (!(end > start)) {
            EXPECT_TRUE(middle.empty());
            return;
        }
        ASSERT_FALSE(middle.empty());
        EXPECT_EQ(middle.knots().start(), start);
        EXPECT_EQ(middle.knots().end(), end);
        expectNear(middle.position({0, 0}), pieces.position(from), 4 * pieceRounding(pieces),
                   "from");
        expectNear(middle.position({middle.size() - 1, 1}), pieces.position(to),
                   4 * pieceRounding(pieces), "to");
        if (end - start > 1e-3) {
            expectSameCurve(middle, pieces, start, end, "part");
        }
    });
}

TEST(OperationLaws, reversedTwiceIsTheSame) {
    forRandomPieces(100'000, {.dimension = 2}, [](const Pieces& pieces, Dice& dice) {
        const Pieces back = reversed(pieces);
        const Pieces again = reversed(back);
        EXPECT_TRUE(std::ranges::equal(again.bezier(), pieces.bezier()));
        for (std::size_t i = 0; i <= pieces.size(); ++i) {
            EXPECT_NEAR(again.knots().knots()[i], pieces.knots().knots()[i], 1e-14);
        }
        const Spot spot = randomSpot(pieces, dice);
        expectNear(back.position({pieces.size() - 1 - spot.segment, 1 - spot.u}),
                   pieces.position(spot), 4 * pieceRounding(pieces), "mirrored spot");
    });
}

TEST(OperationLaws, theOsculatingCircleHasTheCurveOnIt) {
    forRandomPieces(100'000, {.dimension = 3, .offset = 20}, [](const Pieces& pieces, Dice& dice) {
        const Spot spot{randomSpot(pieces, dice).segment, dice.between(0, 1)};
        const auto circle = osculatingCircle(pieces, spot);
        const Jet jet = pieces.jet(spot);
        if (!circle) {
            EXPECT_LT(jet.curvature.value_or(0), 1e-9);
            return;
        }
        EXPECT_NEAR(1 / circle->radius, *jet.curvature, 1e-9 * *jet.curvature + 1e-12);
        EXPECT_NEAR(distance(circle->center, jet.position), circle->radius,
                    1e-13 * (1 + farthest(pieces) + circle->radius));
        EXPECT_NEAR(dot(circle->normal, circle->tangent), 0, 1e-9);
    });
}

/// How far a place is from a chain of lines.
double distanceFrom(const Pieces& pieces, const Polyline& line, const Point& place) {
    double least = distance(pieces.position(line.spots.front()), place);
    for (std::size_t k = 0; k + 1 < line.spots.size(); ++k) {
        const Point start = pieces.position(line.spots[k]);
        const Point chord = pieces.position(line.spots[k + 1]) - start;
        const double squared = dot(chord, chord);
        const double along =
            squared > 0 ? std::clamp(dot(place - start, chord) / squared, 0.0, 1.0) : 0;
        least = std::min(least, distance(place, start + along * chord));
    }
    return least;
}

TEST(OperationLaws, flatteningStaysWithinTolerance) {
    forRandomPieces(
        10'000, {.dimension = 2, .mostPieces = 2}, [](const Pieces& pieces, Dice& dice) {
            const double tolerance = std::pow(10, dice.between(-3, 0.5));
            const Polyline line = flattened(pieces, tolerance);
            ASSERT_TRUE(line.withinTolerance);
            ASSERT_EQ(line.spots.front(), (Spot{0, 0}));
            ASSERT_EQ(line.spots.back(), (Spot{pieces.size() - 1, 1}));
            EXPECT_TRUE(std::ranges::is_sorted(line.spots, comesBefore));
            for (int k = 0; k < 8; ++k) {
                EXPECT_LE(distanceFrom(pieces, line, pieces.position(randomSpot(pieces, dice))),
                          tolerance + pieceRounding(pieces))
                    << "tolerance " << tolerance;
            }
        });
}

/// Zeros along the curve by changes of sign between spots; `clear` where none is in doubt, because
/// the values on both sides of every change are far from zero.
template <class Value> std::vector<Spot> changesOfSign(const Pieces& pieces, Value value) {
    constexpr int perPiece = 200;
    std::vector<Spot> changes;
    double last = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (int k = 0; k <= perPiece; ++k) {
            const Spot spot{i, static_cast<double>(k) / perPiece};
            const double next = value(spot);
            if (last * next < 0) {
                changes.push_back(spot);
            }
            last = next != 0 ? next : last;
        }
    }
    return changes;
}

double along(Spot spot) {
    return static_cast<double>(spot.segment) + spot.u;
}

/// Every change of sign has a spot that was found, no farther back than the step of the sampling.
void expectFoundAll(const std::vector<Spot>& found, const std::vector<Spot>& sampled) {
    EXPECT_GE(found.size(), sampled.size());
    for (const Spot wanted : sampled) {
        EXPECT_TRUE(std::ranges::any_of(found,
                                        [&](Spot spot) {
                                            const double before = along(wanted) - along(spot);
                                            return before >= -1e-9 && before <= 1.0 / 200 + 1e-9;
                                        }))
            << "segment " << wanted.segment << " u " << wanted.u;
    }
}

TEST(OperationLaws, crossingsLieOnTheLineAndNoneIsMissing) {
    forRandomPieces(15'000, {.dimension = 2}, [](const Pieces& pieces, Dice& dice) {
        const Point a = pieces[0].bezierPoint(0) + dice.pointOnGrid(2, 4);
        const auto line = lineThrough(a, a + Point{dice.between(-1, 1), dice.between(0.1, 1)});
        ASSERT_TRUE(line);
        const auto found = crossings(pieces, *line);
        EXPECT_TRUE(std::ranges::is_sorted(found.spots, comesBefore));
        const auto off = [&](Spot spot) {
            return dot(line->normal, pieces.position(spot) - line->place);
        };
        for (const Spot spot : found.spots) {
            EXPECT_NEAR(off(spot), 0, 20 * pieceRounding(pieces));
        }
        if (dice.oneIn(5)) {
            const auto sampled = changesOfSign(pieces, off);
            expectFoundAll(found.spots, sampled);
            // Two crossings between two samples are missed by these, never one.
            EXPECT_EQ((found.spots.size() - sampled.size()) % 2, 0u);
        }
    });
}

TEST(OperationLaws, crossingsOfAPlaneInSpace) {
    forRandomPieces(5'000, {.dimension = 3}, [](const Pieces& pieces, Dice& dice) {
        const Hyperplane plane{pieces[0].bezierPoint(0) + dice.pointOnGrid(3, 4),
                               dice.pointOnGrid(3, 5) + Point{7, 1, 2}};
        for (const Spot spot : crossings(pieces, plane).spots) {
            EXPECT_NEAR(dot(plane.normal, pieces.position(spot) - plane.place), 0,
                        400 * pieceRounding(pieces));
        }
    });
}

TEST(OperationLaws, inflectionsAreWhereCurvatureChangesSign) {
    forRandomPieces(10'000, {.dimension = 2, .offset = 100}, [](const Pieces& pieces, Dice& dice) {
        const auto found = inflections(pieces);
        EXPECT_TRUE(std::ranges::is_sorted(found, comesBefore));
        for (const Spot spot : found) {
            if (spot.u > 1e-6 && spot.u < 1 - 1e-6) {
                const auto before = pieces.jet({spot.segment, spot.u - 1e-7}).curvature;
                const auto after = pieces.jet({spot.segment, spot.u + 1e-7}).curvature;
                ASSERT_TRUE(before && after);
                EXPECT_LE(*before * *after, 1e-12) << "segment " << spot.segment << " " << spot.u;
            }
        }
        if (dice.oneIn(4)) {
            const auto sampled = changesOfSign(pieces, [&](Spot spot) {
                return pieces.degree() > 1 ? pieces.jet(spot).curvature.value_or(0) : 0;
            });
            expectFoundAll(found, sampled);
        }
    });
}

TEST(OperationLaws, verticesAreWhereCurvatureTurnsBack) {
    forRandomPieces(5'000, {.dimension = 2, .mostDegree = 4, .offset = 10},
                    [](const Pieces& pieces, Dice&) {
                        for (const Spot spot : vertices(pieces)) {
                            const double step = 1e-3;
                            if (spot.u < step || spot.u > 1 - step) {
                                continue;
                            }
                            const double here = *pieces.jet(spot).curvature;
                            const double before =
                                *pieces.jet({spot.segment, spot.u - step / 64}).curvature - here;
                            const double after =
                                *pieces.jet({spot.segment, spot.u + step / 64}).curvature - here;
                            EXPECT_GE(before * after, -1e-7 * here * here)
                                << spot.segment << " " << spot.u << ": " << before << ", " << after;
                        }
                    });
}

/// Crossings of the chords of a dense sampling, at an angle that is beyond doubt.
std::size_t crossingsOfChords(const Pieces& pieces, int perPiece) {
    std::vector<Point> places;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (int k = 0; k < perPiece; ++k) {
            places.push_back(pieces.position({i, static_cast<double>(k) / perPiece}));
        }
    }
    places.push_back(pieces.position({pieces.size() - 1, 1}));
    const auto side = [](const Point& a, const Point& b, const Point& p) {
        return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
    };
    std::size_t count = 0;
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
        for (std::size_t k = i + 2; k + 1 < places.size(); ++k) {
            const auto& a = places[i];
            const auto& b = places[i + 1];
            const auto& c = places[k];
            const auto& d = places[k + 1];
            count += side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0 ? 1 : 0;
        }
    }
    return count;
}

TEST(OperationLaws, selfIntersectionsAreOnePlaceTwice) {
    forRandomPieces(12'000, {.dimension = 2}, [](const Pieces& pieces, Dice&) {
        const auto found = selfIntersections(pieces);
        EXPECT_TRUE(found.complete);
        for (const auto& crossing : found.crossings) {
            EXPECT_TRUE(comesBefore(crossing.a, crossing.b));
            EXPECT_LE(distance(pieces.position(crossing.a), pieces.position(crossing.b)),
                      4 * pieceRounding(pieces) + 1e-12 * extentOf(pieces));
        }
    });
}

TEST(OperationLaws, noSelfIntersectionIsMissing) {
    int different = 0;
    std::size_t all = 0;
    constexpr int rounds = 600;
    forRandomPieces(rounds, {.dimension = 2, .mostPieces = 3}, [&](const Pieces& pieces, Dice&) {
        const auto found = selfIntersections(pieces).crossings.size();
        all += found;
        // Chords cannot show loops smaller than they are, and show some that are none: try harder
        // before giving up.
        if (found != crossingsOfChords(pieces, 60) && found != crossingsOfChords(pieces, 250)) {
            different += found == crossingsOfChords(pieces, 900) ? 0 : 1;
        }
    });
    EXPECT_LE(different, rounds / 200);
    EXPECT_GT(all, static_cast<std::size_t>(casesOf(rounds))) << "the curves are too tame";
}

/// Bézier points on a few places only: points, straight lines, curves that run back, cusps and
/// touches are common here, as they are by hand and hardly ever by chance.
Pieces piecesOnAGrid(Dice& dice) {
    const int degree = dice.whole(1, 5);
    const int count = dice.whole(1, 4);
    const Point corner = dice.oneIn(2) ? Point{0, 0} : Point{100.1, -3.7};
    const double sizes[] = {1, 0.1, 1e300, 1e-300, 1e-8};
    const double size = dice.oneIn(2) ? 1 : sizes[dice.whole(0, 4)];
    std::vector<Point> points;
    std::vector<double> weights;
    const bool rational = dice.oneIn(3);
    for (int i = 0; i <= degree * count; ++i) {
        points.push_back(corner + size * Point{1.0 * dice.whole(0, 3), 1.0 * dice.whole(0, 2)});
        if (rational) {
            weights.push_back(dice.whole(1, 3));
        }
    }
    if (dice.oneIn(4)) {
        points.back() = points.front();
    }
    return chainOf(degree, points, weights);
}

bool onCurve(const Pieces& pieces, const std::vector<Spot>& spots) {
    return std::ranges::all_of(spots, [&](Spot spot) {
        return spot.segment < pieces.size() && spot.u >= 0 && spot.u <= 1;
    });
}

TEST(OperationLaws, nothingBreaksOnDegenerateCurves) {
    for (int seed = 0; seed < casesOf(5'000); ++seed) {
        Dice dice(static_cast<std::uint64_t>(seed));
        const Pieces pieces = piecesOnAGrid(dice);
        SCOPED_TRACE("seed " + std::to_string(seed) + ": " + wordsOf(pieces));
        const double size = extentOf(pieces);
        const Polyline line = flattened(pieces, 0.01 * size, 2000);
        EXPECT_TRUE(line.withinTolerance || size == 0 || farthest(pieces) > 1e12 * size);
        EXPECT_TRUE(onCurve(pieces, line.spots));
        EXPECT_LE(flattened(pieces, dice.oneIn(2) ? 0 : 1e-17 * size, 100).spots.size(), 100u);
        EXPECT_TRUE(onCurve(pieces, inflections(pieces)));
        EXPECT_TRUE(onCurve(pieces, cusps(pieces)));
        EXPECT_TRUE(onCurve(pieces, vertices(pieces)));
        for (const auto& crossing : selfIntersections(pieces).crossings) {
            EXPECT_TRUE(comesBefore(crossing.a, crossing.b));
            EXPECT_LE(distance(pieces.position(crossing.a), pieces.position(crossing.b)),
                      1e-13 * farthest(pieces) + 1e-11 * size)
                << crossing.a.segment << " " << crossing.a.u << ", " << crossing.b.segment << " "
                << crossing.b.u;
        }
        const auto through = lineThrough(pieces[0].bezierPoint(0), pieces[0].bezierPoint(1));
        if (through) {
            EXPECT_TRUE(onCurve(pieces, crossings(pieces, *through).spots));
        }
        const Spot spot = randomSpot(pieces, dice);
        if (const auto circle = osculatingCircle(pieces, spot)) {
            EXPECT_TRUE(std::isfinite(circle->radius) && std::isfinite(norm(circle->center)));
        }
        const Pieces stretch = part(pieces, {0, 0.25}, spot);
        for (const double x : stretch.bezier()) {
            EXPECT_TRUE(std::isfinite(x));
        }
        if (HasFailure()) {
            return;
        }
    }
}

} // namespace
} // namespace splineloft::testing_curves
