// Laws of conversion: whatever the curve, each family either is the same curve or says why not, and
// what came from a family goes back to it.
#include "core/spline/catalog.h"
#include "core/spline/change/convert.h"
#include "tests/cases.h"
#include "tests/property/random_curves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace splineloft {
namespace {

using namespace testing_curves;

/// What a conversion may differ by: its own promise, and where the points had to be taken apart
/// again by another recipe, as much again.
double allowed(const Pieces& pieces) {
    double low = 0, high = 0, extent = 0, farthest = 0;
    for (int c = 0; c < pieces.dimension(); ++c) {
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            for (int k = 0; k <= pieces.degree(); ++k) {
                const double x = pieces[i].bezierPoint(k)[c];
                low = i + static_cast<std::size_t>(k) == 0 ? x : std::min(low, x);
                high = i + static_cast<std::size_t>(k) == 0 ? x : std::max(high, x);
                farthest = std::max(farthest, std::abs(x));
            }
        }
        extent = std::hypot(extent, high - low);
    }
    return 2e-12 * extent + 256 * std::numeric_limits<double>::epsilon() * farthest +
           std::numeric_limits<double>::min(); // below it numbers are rounded more coarsely
}

void expectSameCurve(const Curve& one, const Curve& other) {
    const Pieces pieces = piecesOf(one);
    const auto difference = differenceOf(pieces, piecesOf(other));
    ASSERT_TRUE(difference) << wordsOf(other);
    EXPECT_LE(difference->most, allowed(pieces)) << wordsOf(other);
}

/// Both curves, at random spots, measured without `differenceOf`.
void expectSamePlaces(const Curve& one, const Curve& other, Dice& dice) {
    const Pieces a = piecesOf(one);
    const Pieces b = piecesOf(other);
    ASSERT_EQ(a.size(), b.size()) << wordsOf(other);
    for (int k = 0; k < 5; ++k) {
        const Spot spot{static_cast<std::size_t>(dice.whole(0, static_cast<int>(a.size()) - 1)),
                        dice.between(0, 1)};
        expectNear(b.position(spot), a.position(spot), 2 * allowed(a), wordsOf(other));
    }
}

class Conversion : public EveryFamily {};

TEST_P(Conversion, toEveryFamilyIsTheSameCurveOrSaysWhyNot) {
    forEveryForm(GetParam(), 20, [](const Curve& curve) {
        Dice dice(curve.points.size());
        for (const auto& target : familyIds()) {
            SCOPED_TRACE("to " + target);
            const auto result = converted(curve, target);
            if (const auto* problem = std::get_if<Problem>(&result)) {
                EXPECT_FALSE(problem->what.empty());
                EXPECT_FALSE(problem->remedy.empty());
                continue;
            }
            const auto& found = std::get<Curve>(result);
            ASSERT_FALSE(problemOf(found)) << problemOf(found)->what;
            EXPECT_EQ(found.family, target);
            EXPECT_EQ(found.name, curve.name);
            EXPECT_EQ(found.coordinates, curve.coordinates);
            EXPECT_EQ(found.closed, curve.closed);
            expectSameCurve(curve, found);
            expectSamePlaces(curve, found, dice);
        }
    });
}

/// The families through which every curve of this one must pass unharmed.
std::vector<std::string> through(const Curve& curve) {
    const Pieces pieces = piecesOf(curve);
    std::vector<std::string> families = {"nurbs"};
    if (pieces.form() == splineloft::Form::polynomial) {
        families.emplace_back("b-spline");
        if (pieces.degree() <= 3) {
            families.emplace_back("bezier-spline");
        }
    }
    return families;
}

TEST_P(Conversion, thereAndBackAgain) {
    constexpr int rounds = casesOf(850);
    std::size_t trips = 0;
    forEveryForm(GetParam(), rounds, [&](const Curve& curve) {
        if (curve.points.size() > 9 && curve.family == "lagrange") {
            return; // swings so much that rounding shows
        }
        for (const auto& family : through(curve)) {
            SCOPED_TRACE("through " + family);
            const auto there = converted(curve, family);
            ASSERT_TRUE(std::holds_alternative<Curve>(there)) << std::get<Problem>(there).what;
            const auto& found = std::get<Curve>(there);
            expectSameCurve(curve, found);
            const auto back = converted(found, curve.family);
            ASSERT_TRUE(std::holds_alternative<Curve>(back)) << std::get<Problem>(back).what;
            expectSameCurve(curve, std::get<Curve>(back));
            ++trips;
        }
    });
    RecordProperty("trips", static_cast<int>(trips));
}

INSTANTIATE_TEST_SUITE_P(Families, Conversion, testing::ValuesIn(familyIds()), testNameOf);

/// The curve of the first family must be found in the second, with these parameters.
struct Identity {
    std::string from;
    std::map<std::string, double> parameters;
    std::string to;
    std::map<std::string, double> found;
};

/// The identities of the 1983 memo's families, at tension a.
std::vector<Identity> identitiesAt(double a) {
    return {{"duff", {{"tension", a}}, "beta", {{"bias", 1}, {"tension", 12 * (1 - a) / a}}},
            {"duff", {{"tension", a}}, "bc-spline", {{"b", a}, {"c", 0}}},
            {"cardinal", {{"tension", a}}, "bc-spline", {{"b", 0}, {"c", a}}},
            {"cardinal",
             {{"tension", a}},
             "kochanek-bartels",
             {{"tension", 1 - 2 * a}, {"continuity", 0}, {"bias", 0}}},
            {"catmull-rom", {{"alpha", 0}}, "cardinal", {{"tension", 0.5}}},
            {"b-spline", {{"degree", 3}}, "duff", {{"tension", 1}}},
            {"b-spline", {{"degree", 3}}, "beta", {{"bias", 1}, {"tension", 0}}},
            {"b-spline", {{"degree", 3}}, "bc-spline", {{"b", 1}, {"c", 0}}}};
}

TEST(Identities, areFoundBothWays) {
    int found = 0;
    constexpr int rounds = roundsOf(150);
    for (std::uint64_t seed = 1; seed <= rounds; ++seed) {
        Dice dice(seed);
        const double a = dice.oneIn(3) ? 0.125 * dice.whole(1, 8) : dice.between(0.05, 1);
        for (const auto& identity : identitiesAt(a)) {
            for (const auto& form : formsOf(identity.from)) {
                if (form.ends == Ends::clamped) {
                    continue;
                }
                Curve curve = randomCurve(form, seed);
                Point center(curve.points.dimension());
                center[0] = 300;
                curve.parameters.clear();
                completeParameters(curve);
                for (const auto& [key, value] : identity.parameters) {
                    curve.parameters[key] = value;
                }
                rollPoints(curve, 8 + seed % 5, center, 9, dice); // enough data on a line, too
                SCOPED_TRACE(wordsOf(curve) + " to " + identity.to + " seed " +
                             std::to_string(seed));
                const auto result = converted(curve, identity.to);
                ASSERT_TRUE(std::holds_alternative<Curve>(result))
                    << std::get<Problem>(result).what;
                const auto& other = std::get<Curve>(result);
                for (const auto& [key, value] : identity.found) {
                    EXPECT_NEAR(other.parameters.at(key), value, 1e-9 * (1 + std::abs(value)))
                        << key;
                }
                EXPECT_EQ(other.points.size(), curve.points.size());
                expectSameCurve(curve, other);
                const auto back = converted(other, identity.from);
                ASSERT_TRUE(std::holds_alternative<Curve>(back)) << std::get<Problem>(back).what;
                expectSameCurve(curve, std::get<Curve>(back));
                ++found;
            }
        }
    }
    EXPECT_GT(found, 20 * rounds);
}

/// A curve with a value of each parameter at each control point, of 1 to 4 coordinates.
Curve withLocalValues(const CurveForm& form, std::uint64_t seed) {
    Dice dice(seed);
    Curve curve = emptyCurve(form, dice.whole(1, 4));
    completeParameters(curve);
    Point center(curve.points.dimension());
    center[0] = dice.between(-500, 500);
    rollPoints(curve, 4 + static_cast<std::size_t>(dice.whole(0, 7)), center, 7, dice);
    for (const auto& parameter : familyOf(curve).parameters) {
        auto& values = curve.local[std::string(parameter.key)];
        for (std::size_t i = 0; i < curve.points.size(); ++i) {
            values.push_back(parameter.scale == Scale::ratio
                                 ? std::exp2(dice.between(-2, 2))
                                 : dice.between(parameter.sliderLeast, parameter.sliderMost));
        }
    }
    return curve;
}

TEST(LocalValues, comeBackFromTheTangents) {
    for (const std::string family : {"cardinal", "kochanek-bartels"}) {
        for (const auto& form : formsOf(family)) {
            for (std::uint64_t seed = 1; seed <= roundsOf(500); ++seed) {
                const Curve curve = withLocalValues(form, seed);
                SCOPED_TRACE(wordsOf(curve) + " seed " + std::to_string(seed));
                const auto there = converted(curve, "bezier-spline");
                ASSERT_TRUE(std::holds_alternative<Curve>(there));
                const auto back = converted(std::get<Curve>(there), family);
                ASSERT_TRUE(std::holds_alternative<Curve>(back)) << std::get<Problem>(back).what;
                expectSameCurve(curve, std::get<Curve>(back));
            }
        }
    }
}

TEST(LocalValues, makeABetaSplineNurbsOfDegree18) {
    for (const auto& form : formsOf("beta")) {
        for (std::uint64_t seed = 1; seed <= 40; ++seed) {
            const Curve curve = withLocalValues(form, seed);
            SCOPED_TRACE(wordsOf(curve) + " seed " + std::to_string(seed));
            const auto result = converted(curve, "nurbs");
            ASSERT_TRUE(std::holds_alternative<Curve>(result)) << std::get<Problem>(result).what;
            EXPECT_EQ(std::get<Curve>(result).parameters.at("degree"), 18);
            expectSameCurve(curve, std::get<Curve>(result));
            const auto refused = converted(curve, "bezier-spline");
            ASSERT_TRUE(std::holds_alternative<Problem>(refused));
            EXPECT_NE(std::get<Problem>(refused).what.find("rational"), std::string::npos);
            EXPECT_NE(std::get<Problem>(refused).remedy.find("nurbs"), std::string::npos);
        }
    }
}

TEST(LocalValues, thatAreAllTheSameMakeACubic) {
    Curve curve = withLocalValues(formsOf("beta").front(), 3);
    for (auto& [key, values] : curve.local) {
        std::ranges::fill(values, key == "bias" ? 1.0 : 12.0);
    }
    for (const std::string family : {"duff", "bezier-spline", "b-spline", "beta", "nurbs"}) {
        const auto result = converted(curve, family);
        ASSERT_TRUE(std::holds_alternative<Curve>(result)) << std::get<Problem>(result).what;
        expectSameCurve(curve, std::get<Curve>(result));
    }
    EXPECT_EQ(std::get<Curve>(converted(curve, "b-spline")).parameters.at("degree"), 3);
    EXPECT_NEAR(std::get<Curve>(converted(curve, "duff")).parameters.at("tension"), 0.5, 1e-12);
}

/// Points that are few, on top of each other, or at the edge of what a double holds.
std::vector<Points> awkwardPoints() {
    const auto scaled = [](double factor) {
        Points points(2);
        for (const auto& [x, y] : {std::pair{1.5, 7.0},
                                   {2.5, -3.0},
                                   {4.0, 4.5},
                                   {9.0, 5.5},
                                   {-6.0, 1.0},
                                   {2.0, 2.25},
                                   {5.0, -8.0},
                                   {3.0, 3.0},
                                   {7.0, 1.5}}) {
            points.append(Point{factor * x, factor * y});
        }
        return points;
    };
    Points line(1);
    Points wide(maxDimension);
    for (int i = 0; i < 7; ++i) {
        Point place(maxDimension);
        for (int c = 0; c < maxDimension; ++c) {
            place[c] = 40 + std::sin(1.0 + i * (c + 2)) * 9;
        }
        wide.append(place);
        line.append(Point{17 + std::cos(2.5 * i)});
    }
    return {Points(2),
            {{7, 3}},
            {{7, 3}, {11, 5}},
            {{7, 3}, {11, 5}, {13, 4}},
            {{7, 3}, {7, 3}, {7, 3}, {7, 3}, {7, 3}},
            {{0, 0}, {0, 0}, {0, 0}, {0, 0}},
            {{7, 3}, {11, 5}, {11, 5}, {11, 5}, {13, 9}, {17, 2}, {17, 2}, {19, 1}, {23, 4}},
            {{1, 3}, {2, 5}, {1, 3}, {2, 5}, {1, 3}, {2, 5}, {1, 3}},
            {{1, 3}, {2, 5}, {3, 7}, {4, 9}, {5, 11}, {6, 13}},
            scaled(1e299),
            scaled(1e-300),
            scaled(5e-324),
            scaled(1e7),
            line,
            wide};
}

TEST(Awkward, everyPairAnswersWithFiniteNumbers) {
    for (const auto& form : everyForm()) {
        for (const auto& points : awkwardPoints()) {
            Curve curve = emptyCurve(form, points.dimension());
            curve.points = points;
            curve.tangents = familyOf(curve).usesTangents ? points : Points(points.dimension());
            if (farthest(curve) > familyOf(curve).mostCoordinate) {
                EXPECT_TRUE(problemOf(curve)) << wordsOf(curve);
                continue;
            }
            ASSERT_FALSE(problemOf(curve)) << wordsOf(curve);
            for (const auto& target : familyIds()) {
                SCOPED_TRACE(wordsOf(curve) + " to " + target);
                const auto result = converted(curve, target);
                if (const auto* problem = std::get_if<Problem>(&result)) {
                    EXPECT_FALSE(problem->what.empty() || problem->remedy.empty());
                    EXPECT_EQ(problem->what.find("nan"), std::string::npos) << problem->what;
                } else if (target != form.family) {
                    EXPECT_FALSE(problemOf(std::get<Curve>(result)));
                    expectSameCurve(curve, std::get<Curve>(result));
                }
            }
        }
    }
}

} // namespace
} // namespace splineloft
