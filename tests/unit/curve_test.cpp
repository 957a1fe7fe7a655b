// The description of a curve: what is refused and in which words, its knots, and its speed.
#include "core/spline/curve.h"
#include "core/spline/problem.h"

#include "core/spline/catalog.h"
#include "core/spline/traits.h"
#include "tests/property/random_curves.h"

#include <cmath>
#include <set>
#include <stdexcept>

namespace splineloft {
namespace {

using namespace testing_curves;

Curve ordinary() {
    Curve curve;
    curve.points = {{100, 50}, {130, 52}, {140, 80}, {111, 91}};
    return curve;
}

TEST(Catalog, hasEachFamilyOnceAndCompletely) {
    std::set<std::string_view> ids;
    for (const auto& family : catalog()) {
        EXPECT_TRUE(ids.insert(family.id).second) << family.id;
        EXPECT_EQ(findFamily(family.id), &family);
        for (const auto& text : {family.name, family.summary, family.source}) {
            EXPECT_FALSE(text.empty()) << family.id;
        }
        EXPECT_FALSE(family.ends.empty()) << family.id;
        EXPECT_TRUE(family.layout && family.blendCoordinates && family.blendRecipes) << family.id;
        for (const auto& p : family.parameters) {
            EXPECT_LE(p.least, p.sliderLeast) << family.id << ' ' << p.key;
            EXPECT_LT(p.sliderLeast, p.sliderMost) << family.id << ' ' << p.key;
            EXPECT_LE(p.sliderMost, p.most) << family.id << ' ' << p.key;
            EXPECT_LE(p.sliderLeast, p.neutral) << family.id << ' ' << p.key;
            EXPECT_LE(p.neutral, p.sliderMost) << family.id << ' ' << p.key;
            EXPECT_FALSE(p.label.empty() || p.symbol.empty() || p.meaning.empty()) << p.key;
        }
    }
    EXPECT_EQ(findFamily("cubic"), nullptr);
}

/// One thing that is wrong, and where the problem must point.
struct Fault {
    std::string place;
    void (*break_)(Curve&);
};

TEST(Problem, pointsAtWhatIsWrong) {
    const std::vector<Fault> faults = {
        {"/family", [](Curve& c) { c.family = "spiral"; }},
        {"/points/2/1", [](Curve& c) { c.points.set(2, {1, std::nan("")}); }},
        {"/points/0/0", [](Curve& c) { c.points.set(0, {HUGE_VAL, 1}); }},
        {"/points", [](Curve& c) { c.points = Points(0); }},
        {"/points", [](Curve& c) { c.points = Points(17); }},
        {"/points",
         [](Curve& c) {
             c.family = "bezier";
             c.ends = Ends::none;
             for (int i = 0; i < 300; ++i) {
                 c.points.append({1.0 * i, 2});
             }
         }},
        {"/coordinates", [](Curve& c) { c.coordinates = {"x"}; }},
        {"/coordinates/0", [](Curve& c) { c.coordinates = {"x", "x"}; }},
        {"/coordinates/1", [](Curve& c) { c.coordinates = {"x", ""}; }},
        {"/ends", [](Curve& c) { c.ends = Ends::clamped; }},
        {"/ends", [](Curve& c) { c.ends = Ends::none; }},
        {"/closed",
         [](Curve& c) {
             c.family = "bezier";
             c.ends = Ends::none;
             c.closed = true;
         }},
        {"/tangents", [](Curve& c) { c.tangents = c.points; }},
        {"/tangents",
         [](Curve& c) {
             c.family = "hermite";
             c.ends = Ends::none;
         }},
        {"/parameters/tension", [](Curve& c) { c.parameters["tension"] = std::nan(""); }},
        {"/parameters/tension", [](Curve& c) { c.parameters["tension"] = 1e9; }},
        {"/parameters/bias", [](Curve& c) { c.parameters["bias"] = 1; }},
        {"/parameters/degree",
         [](Curve& c) {
             c.family = "b-spline";
             c.parameters["degree"] = 2.5;
         }},
    };
    for (const auto& fault : faults) {
        Curve curve = ordinary();
        fault.break_(curve);
        const auto problem = problemOf(curve);
        ASSERT_TRUE(problem) << fault.place;
        EXPECT_EQ(problem->place, fault.place);
        EXPECT_FALSE(problem->what.empty() || problem->remedy.empty()) << fault.place;
        EXPECT_THROW(piecesOf(curve), std::invalid_argument) << fault.place;
    }
    EXPECT_FALSE(problemOf(ordinary()));
    EXPECT_FALSE(problemOf(Curve()));
}

TEST(Parameters, leftOutHaveTheirNeutralValue) {
    Curve curve = ordinary();
    EXPECT_EQ(parametersOf(curve), std::vector<double>{0.5});
    curve.family = "beta";
    curve.parameters = {{"tension", 4}};
    EXPECT_EQ(parametersOf(curve), (std::vector<double>{1, 4}));
}

TEST(KnotLine, locatesInEveryCase) {
    const KnotLine line({2, 2, 3, 3, 3, 5, 5});
    EXPECT_EQ(line.locate(2), (Spot{1, 0})) << "past the piece without interval";
    EXPECT_EQ(line.locate(2.25), (Spot{1, 0.25}));
    EXPECT_EQ(line.locate(3), (Spot{4, 0})) << "a joint belongs to the piece that begins there";
    EXPECT_EQ(line.locate(4), (Spot{4, 0.5}));
    EXPECT_EQ(line.locate(5), (Spot{4, 1})) << "the end is reached from inside";
    EXPECT_EQ(line.locate(-7), (Spot{1, 0}));
    EXPECT_EQ(line.locate(7), (Spot{4, 1}));
    EXPECT_EQ(line.locate(HUGE_VAL), (Spot{4, 1}));
    EXPECT_EQ(line.locate(-HUGE_VAL), (Spot{1, 0}));
    EXPECT_EQ(line.locate(std::nan("")), (Spot{1, 0}));
}

TEST(KnotLine, withoutAnyIntervalOrPieceStillLocates) {
    const KnotLine still({4, 4, 4});
    for (const double t : {3.0, 4.0, 5.0}) {
        EXPECT_EQ(still.locate(t).segment, 0u) << t;
    }
    EXPECT_EQ(KnotLine().locate(1), Spot{});
}

TEST(KnotLine, parameterUndoesLocate) {
    const KnotLine line({-1, 0.25, 0.3, 7, 1000});
    for (const double t : {-1.0, -0.3, 0.25, 0.27, 5.0, 999.0, 1000.0}) {
        EXPECT_NEAR(line.parameter(line.locate(t)), t, 1e-13 * (1 + std::abs(t)));
    }
    // Just below a joint u may round to 1, but never beyond.
    EXPECT_LE(line.locate(std::nextafter(7.0, 0.0)).u, 1);
}

TEST(Abscissae, areWhereTheCurvePassesItsPoints) {
    for (const auto& form : everyForm()) {
        Curve curve = randomCurve(form, 3);
        const Pieces pieces = piecesOf(curve);
        if (familyOf(curve).hasHandles || !traitsOf(curve, pieces, blendsOf(curve)).throughAll) {
            continue;
        }
        const auto t = abscissae(curve);
        ASSERT_EQ(t.size(), curve.points.size());
        for (std::size_t i = 0; i < t.size(); ++i) {
            const Spot spot = pieces.knots().locate(t[i]);
            expectNear(pieces.position(spot), curve.points.at(i), 1e-11 * (1 + farthest(curve)),
                       wordsOf(curve) + " point " + std::to_string(i));
        }
    }
}

/// Greville abscissae as the heights of the control points draw the straight line.
TEST(Abscissae, ofBSplinesReproduceTheParameter) {
    for (const Ends ends : {Ends::open, Ends::clamped}) {
        for (int degree = 1; degree <= 6; ++degree) {
            Curve curve = emptyCurve({"b-spline", false, ends}, 1);
            curve.parameters["degree"] = degree;
            for (int i = 0; i < 9; ++i) {
                curve.points.append(Point{0});
            }
            const auto greville = abscissae(curve);
            for (std::size_t i = 0; i < greville.size(); ++i) {
                curve.points.set(i, Point{greville[i]});
            }
            const Pieces pieces = piecesOf(curve);
            for (const double t : {0.0, 0.3, 1.5, 2.9}) {
                EXPECT_NEAR(pieces.position(pieces.knots().locate(t))[0], t, 1e-13)
                    << nameOf(ends) << " degree " << degree;
            }
        }
    }
}

TEST(ControlAtStart, isWhereAnInterpolatingPieceBegins) {
    for (const auto* family : {"linear", "cardinal", "catmull-rom", "natural", "hermite"}) {
        for (const auto& form : formsOf(family)) {
            const Curve curve = randomCurve(form, 12);
            const Pieces pieces = piecesOf(curve);
            for (std::size_t i = 0; i < pieces.size(); ++i) {
                EXPECT_EQ(pieces.position({i, 0}), curve.points.at(controlAtStart(curve, i)))
                    << wordsOf(curve) << " segment " << i;
            }
        }
    }
    EXPECT_EQ(controlAtStart(Curve(), 0), 0u) << "nothing to begin at";
}

/// A few hundredths of a second each; a quadratic step would outlast the time that ctest gives.
TEST(Pieces, areMadeOfManyPoints) {
    for (const auto* family : {"cardinal", "natural", "b-spline", "catmull-rom"}) {
        for (const bool closed : {false, true}) {
            Dice dice(1);
            Curve curve = emptyCurve({family, closed, formsOf(family).front().ends}, 2);
            rollPoints(curve, 100'000, {100, 100}, 50, dice);
            EXPECT_FALSE(problemOf(curve));
            EXPECT_EQ(piecesOf(curve).size(), closed ? 100'000u : 99'999u);
            EXPECT_EQ(abscissae(curve).size(), 100'000u);
            EXPECT_LE(fewestPoints(curve), 2u);
        }
    }
}

/// Found by a fuzzer: around the loop, 8 was once counted as -1e300 + 1e300.
TEST(Knots, ofAClosedCurveNeverFallHoweverFarApartTheyAre) {
    Curve curve;
    curve.family = "b-spline";
    curve.closed = true;
    curve.ends = Ends::none;
    curve.points = {{-62.5, 379}, {-510, -53}, {-268, 386}, {207, 293}, {209, 291}};
    curve.knots = {-1e300, 0, 0, 3, 8, 8};
    ASSERT_FALSE(problemOf(curve));
    const Pieces pieces = piecesOf(curve);
    EXPECT_EQ(pieces.size(), 3u);
    for (const double coordinate : pieces.bezier()) {
        EXPECT_TRUE(std::isfinite(coordinate));
    }
    EXPECT_EQ(pieces.knots().end(), 8);
}

} // namespace
} // namespace splineloft
