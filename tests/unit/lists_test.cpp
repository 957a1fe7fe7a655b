// Weights, local parameters and knots stay in step with the points, whatever is done to them.
#include "core/document/lists.h"

#include "core/document/edits.h"
#include "core/document/handles.h"
#include "core/spline/catalog.h"
#include "tests/property/random_curves.h"

#include <algorithm>
#include <cmath>

namespace splineloft {
namespace {

using namespace testing_curves;
using Numbers = std::vector<double>;

/// Five weighted points with knots of their own, degree 2; of a closed one the knots of 5 pieces.
Curve ownKnots(bool closed = false) {
    Curve curve;
    curve.family = "nurbs";
    curve.parameters = {{"degree", 2}};
    completeParameters(curve);
    curve.closed = closed;
    curve.ends = Ends::none;
    curve.points = {{4, 1}, {6, 3}, {7, -2}, {9, 0.5}, {12, 2}};
    curve.weights = {1, 4, 9, 1, 2};
    curve.knots = closed ? Numbers{1, 2, 4, 8, 9, 11} : Numbers{0, 0, 0, 1, 3, 4, 4, 4};
    return curve;
}

Curve localBeta() {
    Curve curve;
    curve.family = "beta";
    completeParameters(curve);
    curve.points = {{4, 1}, {6, 3}, {7, -2}, {9, 0.5}};
    curve.local = {{"bias", {1, 2, 4, 8}}, {"tension", {0, 10, 20, 50}}};
    return curve;
}

Curve inserted(Curve curve, std::size_t index) {
    curve.points.insert(index, Point{8, 8});
    addToLists(curve, index);
    EXPECT_FALSE(problemOf(curve)) << problemOf(curve)->place << ' ' << problemOf(curve)->what;
    return curve;
}

Curve removed(Curve curve, const std::set<std::size_t>& indices) {
    for (auto index = indices.rbegin(); index != indices.rend(); ++index) {
        curve.points.erase(*index);
    }
    removeFromLists(curve, indices);
    EXPECT_FALSE(problemOf(curve)) << problemOf(curve)->place << ' ' << problemOf(curve)->what;
    return curve;
}

TEST(Lists, aNewPointHasTheMeanOfItsNeighbours) {
    EXPECT_EQ(inserted(ownKnots(), 2).weights, (Numbers{1, 4, 6, 9, 1, 2})) << "geometric";
    EXPECT_EQ(inserted(ownKnots(), 0).weights, (Numbers{1, 1, 4, 9, 1, 2}));
    EXPECT_EQ(inserted(ownKnots(), 5).weights, (Numbers{1, 4, 9, 1, 2, 2}));
    const Curve around = inserted(ownKnots(true), 5);
    EXPECT_EQ(around.weights.back(), std::sqrt(2.0)) << "between the last and the first";
    const auto local = inserted(localBeta(), 3).local;
    EXPECT_EQ(local.at("bias"), (Numbers{1, 2, 4, 6, 8}));
    EXPECT_EQ(local.at("tension"), (Numbers{0, 10, 20, 35, 50}));
}

TEST(Lists, aNewPointHalvesAnIntervalNearIt) {
    EXPECT_EQ(inserted(ownKnots(), 0).knots, (Numbers{0, 0, 0, 0.5, 1, 3, 4, 4, 4}));
    EXPECT_EQ(inserted(ownKnots(), 3).knots, (Numbers{0, 0, 0, 1, 2, 3, 4, 4, 4}));
    EXPECT_EQ(inserted(ownKnots(), 5).knots, (Numbers{0, 0, 0, 1, 3, 3.5, 4, 4, 4}));
    EXPECT_EQ(inserted(ownKnots(true), 0).knots, (Numbers{1, 1.5, 2, 4, 8, 9, 11}));
    EXPECT_EQ(inserted(ownKnots(true), 5).knots, (Numbers{1, 2, 4, 8, 9, 10, 11}));
}

TEST(Lists, anEmptyIntervalIsNotHalved) {
    Curve curve = ownKnots();
    curve.knots = {0, 0, 0, 0.25, 0.25, 4, 4, 4};
    EXPECT_EQ(inserted(curve, 3).knots.size(), 9u);
    double least = 0.25;
    for (int i = 0; i < 200; ++i) { // until doubles have no number between two knots
        curve = inserted(curve, 1);
        ASSERT_FALSE(curve.knots.empty()) << i;
        least = std::min(least, curve.knots[3] - curve.knots[2]);
    }
    EXPECT_LT(least, 1e-15);
}

TEST(Lists, aSplineTooShortForAnIntervalGivesItsKnotsUp) {
    Curve curve = ownKnots();
    curve.points = {{4, 1}, {6, 3}};
    curve.weights = {1, 4};
    curve.knots = {0, 1, 1, 1, 2};
    ASSERT_FALSE(problemOf(curve));
    const Curve longer = inserted(curve, 1);
    EXPECT_TRUE(longer.knots.empty());
    EXPECT_EQ(longer.ends, Ends::clamped) << "the usual end of its family";
    curve.points = Points(2);
    curve.weights.clear();
    curve.knots = {0, 0, 0};
    ASSERT_FALSE(problemOf(curve));
    EXPECT_TRUE(inserted(curve, 0).knots.empty());
}

TEST(Lists, whatBelongsToDeletedPointsGoes) {
    const Curve curve = removed(ownKnots(), {1, 4});
    EXPECT_EQ(curve.weights, (Numbers{1, 9, 1}));
    EXPECT_EQ(curve.knots.size(), 6u);
    EXPECT_EQ(curve.knots.front(), 0);
    EXPECT_EQ(curve.knots.back(), 4);
    EXPECT_EQ(removed(localBeta(), {0, 2}).local.at("bias"), (Numbers{2, 8}));
    const Curve short_ = removed(ownKnots(), {0, 1, 2});
    EXPECT_TRUE(short_.knots.empty()) << "two points of degree 2 have no piece";
    EXPECT_EQ(short_.ends, Ends::clamped);
    const Curve loop = removed(ownKnots(true), {0, 3});
    EXPECT_EQ(loop.knots.size(), 4u);
    EXPECT_EQ(loop.knots.front(), 1);
    EXPECT_EQ(loop.knots.back(), 11);
}

TEST(Lists, nothingIsLeftOfThemWithoutPoints) {
    const Curve none = removed(localBeta(), {0, 1, 2, 3});
    EXPECT_TRUE(none.local.empty());
    EXPECT_TRUE(removed(ownKnots(), {0, 1, 2, 3, 4}).weights.empty());
}

TEST(Lists, aFamilyKeepsThoseThatItUses) {
    Curve curve = ownKnots();
    curve.family = "b-spline";
    dropUnusedLists(curve);
    EXPECT_EQ(curve.knots, ownKnots().knots);
    EXPECT_TRUE(curve.weights.empty());
    curve.family = "cardinal";
    dropUnusedLists(curve);
    EXPECT_TRUE(curve.knots.empty());
    EXPECT_EQ(curve.ends, Ends::doubled);
    Curve beta = localBeta();
    beta.family = "kochanek-bartels"; // whose `tension` is another, but may be local
    dropUnusedLists(beta);
    EXPECT_EQ(beta.local.size(), 2u);
    beta.family = "duff";
    dropUnusedLists(beta);
    EXPECT_TRUE(beta.local.empty());
}

/// A random walk through everything that can be done to a curve.
class Walk {
  public:
    explicit Walk(std::uint64_t seed) : dice_(seed) {}

    Document step(const Document& document) {
        const Curve& curve = *document.curves.at(0);
        const auto n = curve.points.size();
        const auto any = below(n);
        switch (dice_.whole(0, n > 24 ? 8 : 11)) {
        case 0: return setFamily(document, 0, pick(familyIds()));
        case 1: return setClosed(document, 0, familyOf(curve).closable && !curve.closed);
        case 2: return curve.closed ? document : setEnds(document, 0, pick(familyOf(curve).ends));
        case 3: return turned(document);
        case 4: return setWeight(document, 0, any, std::exp(dice_.between(-20, 20)));
        case 5: return local(document);
        case 6: return withKnots(document);
        case 7:
        case 8:
            return n > 1 ? deletePoints(document, std::vector<PointId>{{0, any}, {0, below(n)}})
                         : document;
        case 9: return insertPoint(document, 0, any, dice_.pointOnGrid(2, 50));
        case 10: return appendPoint(document, 0, dice_.pointOnGrid(2, 50)).document;
        default: {
            const Pieces pieces = piecesOf(curve);
            return pieces.empty()
                       ? document
                       : insertOnCurve(document, 0, {below(pieces.size()), dice_.between(0, 1)})
                             .document;
        }
        }
    }

  private:
    std::size_t below(std::size_t count) {
        return static_cast<std::size_t>(dice_.whole(0, std::max(1, static_cast<int>(count)) - 1));
    }

    template <class Item> Item pick(const std::vector<Item>& list) {
        return list[below(list.size())];
    }

    double valueOf(const Parameter& p) {
        const double value = dice_.between(p.sliderLeast, p.sliderMost);
        return p.scale == Scale::whole ? std::round(value) : value;
    }

    Document turned(const Document& document) {
        const auto& parameters = familyOf(*document.curves[0]).parameters;
        if (parameters.empty()) {
            return document;
        }
        const Parameter p = pick(parameters);
        return setParameter(document, 0, p.key, valueOf(p));
    }

    Document local(const Document& document) {
        const Curve& curve = *document.curves[0];
        if (familyOf(curve).parameters.empty()) {
            return document;
        }
        const Parameter p = pick(familyOf(curve).parameters);
        const std::vector<std::size_t> points(dice_.oneIn(2) ? 1 : 0, below(curve.points.size()));
        return dice_.oneIn(4)   ? makeGlobal(document, 0, p.key)
               : dice_.oneIn(4) ? makeLocal(document, 0, p.key)
                                : setLocal(document, 0, p.key, points, valueOf(p));
    }

    /// The document with random knots in its curve, where that is one that takes them.
    Document withKnots(const Document& document) {
        Curve curve = *document.curves[0];
        if (!familyOf(curve).usesKnots) {
            return document;
        }
        const auto degree = static_cast<std::size_t>(parameterOf(curve, "degree"));
        curve.knots.clear();
        for (auto i = curve.points.size() + (curve.closed ? 1 : degree + 1); i > 0; --i) {
            curve.knots.push_back(dice_.whole(-3, static_cast<int>(curve.points.size())));
        }
        std::ranges::sort(curve.knots);
        curve.ends = Ends::none;
        Document next = document;
        next.curves[0] = std::make_shared<Curve>(curve);
        return problemOf(next) ? document : next; // too many alike, or no interval
    }

    Dice dice_;
};

TEST(Lists, staySoundOnAnyWay) {
    Document document = {{std::make_shared<Curve>(ownKnots())}, "{}"};
    Walk walk(20'261'122);
    int withKnots = 0;
    int withWeights = 0;
    int withLocal = 0;
    for (int step = 0; step < 10'000; ++step) {
        Document next = walk.step(document);
        if (next.curves.empty()) { // its last point was deleted
            next = {{std::make_shared<Curve>(localBeta())}, "{}"};
        }
        if (next.curves[0]->points.size() > familyOf(*next.curves[0]).mostPoints) {
            continue; // the session would refuse it
        }
        const auto problem = problemOf(next);
        ASSERT_FALSE(problem) << "step " << step << ": " << wordsOf(*next.curves[0]) << ' '
                              << problem->place << ' ' << problem->what << ", from "
                              << wordsOf(*document.curves[0]);
        ASSERT_NO_THROW(piecesOf(*next.curves[0])) << "step " << step;
        document = std::move(next);
        const Curve& curve = *document.curves[0];
        withKnots += curve.knots.empty() ? 0 : 1;
        withWeights += curve.weights.empty() ? 0 : 1;
        withLocal += curve.local.empty() ? 0 : 1;
    }
    for (const int count : {withKnots, withWeights, withLocal}) {
        EXPECT_GT(count, 200) << "the way leads past all of them";
    }
}

} // namespace
} // namespace splineloft
