// Edits of whole curves: what they make, and what they refuse.
#include "core/document/curve_edits.h"

#include "core/document/edits.h"
#include "tests/property/random_curves.h"

#include <array>

namespace splineloft {
namespace {

using namespace testing_curves;

Curve curveOf(const std::string& family, Points points) {
    Curve curve = emptyCurve({family, false, formsOf(family).front().ends}, points.dimension());
    curve.points = std::move(points);
    completeParameters(curve);
    return curve;
}

Document inOneDocument(const std::vector<Curve>& curves) {
    Document document;
    for (const auto& curve : curves) {
        document.curves.push_back(std::make_shared<Curve>(curve));
        document.curves.back().look.colour = static_cast<int>(document.curves.size());
    }
    return document;
}

Document named(const std::vector<std::string>& names) {
    std::vector<Curve> curves;
    for (const auto& name : names) {
        curves.push_back(curveOf("linear", {{0, 0}, {1, 1}}));
        curves.back().name = name;
    }
    return inOneDocument(curves);
}

std::string namesOf(const Document& document) {
    std::string names;
    for (const auto& curve : document.curves) {
        names += curve->name + ",";
    }
    return names;
}

Document joined(const Document& document, PointId end, PointId other) {
    const auto result = joinCurves(document, end, other);
    EXPECT_TRUE(std::holds_alternative<Document>(result)) << std::get<Problem>(result).what;
    return std::holds_alternative<Document>(result) ? std::get<Document>(result) : document;
}

void expectRefused(const std::variant<Document, Problem>& result, const std::string& place,
                   const std::string& what) {
    ASSERT_TRUE(std::holds_alternative<Problem>(result));
    const auto& problem = std::get<Problem>(result);
    EXPECT_EQ(problem.place, place);
    EXPECT_NE(problem.what.find(what), std::string::npos) << problem.what;
    EXPECT_FALSE(problem.remedy.empty());
}

TEST(CurveEdits, duplicateRenameAndLook) {
    const Document document = named({"a", "b"});
    const Document twice = duplicateCurve(document, 0);
    EXPECT_EQ(namesOf(twice), "a,a copy,b,");
    EXPECT_EQ(twice.curves[1].look, document.curves[0].look);
    EXPECT_EQ(namesOf(renameCurve(document, 1, "c")), "a,c,");
    const Look look{.visible = false, .locked = true, .colour = 2};
    EXPECT_EQ(setLook(document, 1, look).curves[1].look, look);
    EXPECT_EQ(setLook(document, 1, look).curves[1].curve, document.curves[1].curve) << "shared";
}

TEST(CurveEdits, moveAndRemove) {
    const Document document = named({"a", "b", "c", "d"});
    EXPECT_EQ(namesOf(moveCurve(document, 0, 2)), "b,c,a,d,");
    EXPECT_EQ(namesOf(moveCurve(document, 3, 1)), "a,d,b,c,");
    EXPECT_EQ(moveCurve(document, 2, 2), document);
    EXPECT_EQ(namesOf(removeCurves(document, std::array<std::size_t, 4>{1, 3, 3, 9})), "a,c,");
}

TEST(Reverse, takesListsAndModesAlong) {
    Curve curve =
        curveOf("bezier-spline",
                {{0, 0}, {1, 2}, {3, 4}, {4, 4}, {5, 4}, {8, 1}, {9, 0}, {9, -3}, {5, -2}, {4, 0}});
    Document document = inOneDocument({curve});
    document.curves[0].handleModes = {{3, HandleMode::corner}};
    const Document after = reverseCurve(document, 0);
    EXPECT_EQ(after.curves[0].handleModes, (HandleModes{{6, HandleMode::corner}}));
    EXPECT_EQ(reverseCurve(after, 0), document);
    Curve beta = curveOf("beta", {{0, 0}, {4, 1}, {7, 3}, {9, 0}});
    beta.local["bias"] = {1, 2, 4, 8};
    const Document turned = reverseCurve(inOneDocument({beta}), 0);
    EXPECT_EQ(turned.curves[0]->local.at("bias"), (std::vector{0.125, 0.25, 0.5, 1.0}));
}

TEST(Join, makesEndsThatCoincideOnePoint) {
    const Document document = inOneDocument(
        {curveOf("linear", {{0, 0}, {1, 1}}), curveOf("linear", {{1, 1}, {2, 0}, {3, 5}})});
    const Document one = joined(document, {0, 1}, {1, 0});
    ASSERT_EQ(one.curves.size(), 1u);
    EXPECT_EQ(one.curves[0]->points, (Points{{0, 0}, {1, 1}, {2, 0}, {3, 5}}));
    EXPECT_EQ(one.curves[0].look.colour, 1);
    EXPECT_EQ(joined(document, {0, 0}, {1, 0}).curves[0]->points,
              (Points{{3, 5}, {2, 0}, {1, 1}, {0, 0}, {1, 1}}))
        << "what is first keeps its direction";
    EXPECT_EQ(joined(document, {1, 2}, {0, 0}).curves[0]->points,
              (Points{{1, 1}, {2, 0}, {3, 5}, {0, 0}, {1, 1}}));
}

TEST(Join, aStraightPieceLeadsFromAnchorToAnchor) {
    const Document document =
        inOneDocument({curveOf("bezier-spline", {{0, 0}, {1, 2}, {3, 4}, {4, 4}}),
                       curveOf("bezier-spline", {{10, 4}, {11, 8}, {13, 4}, {14, 4}})});
    EXPECT_EQ(
        joined(document, {0, 3}, {1, 0}).curves[0]->points,
        (Points{
            {0, 0}, {1, 2}, {3, 4}, {4, 4}, {6, 4}, {8, 4}, {10, 4}, {11, 8}, {13, 4}, {14, 4}}));
}

TEST(Join, convertsWhereThatIsExact) {
    const Document document =
        inOneDocument({curveOf("bezier-spline", {{0, 0}, {1, 2}, {3, 4}, {4, 4}}),
                       curveOf("linear", {{4, 4}, {7, 1}})});
    EXPECT_EQ(joined(document, {0, 3}, {1, 0}).curves[0]->points.size(), 7u);
    expectRefused(joinCurves(document, {1, 0}, {0, 3}), "/curves/0/family", "degree 3");
}

TEST(Join, makesParametersLocalThatDiffer) {
    std::vector<Curve> curves = {curveOf("cardinal", {{0, 0}, {1, 1}}),
                                 curveOf("cardinal", {{5, 1}, {7, 1}, {9, 3}})};
    curves[1].parameters["tension"] = 2;
    EXPECT_EQ(joined(inOneDocument(curves), {0, 1}, {1, 0}).curves[0]->local.at("tension"),
              (std::vector{0.5, 0.5, 2.0, 2.0, 2.0}));
    curves = {curveOf("duff", {{0, 0}, {1, 1}}), curveOf("duff", {{5, 1}, {7, 1}})};
    curves[1].parameters["tension"] = 0.25;
    expectRefused(joinCurves(inOneDocument(curves), {0, 1}, {1, 0}), "/curves/1/parameters/tension",
                  "differs");
}

TEST(Join, splinesOfDifferentDegreeAndUnequalWeights) {
    Curve first = curveOf("nurbs", {{0, 0}, {1, 3}, {4, 4}, {6, 0}});
    first.weights = {1, 2, 3, 4};
    Curve second = curveOf("nurbs", {{9, 0}, {12, 5}, {15, 0}});
    second.parameters["degree"] = 2;
    second.weights = {3, 1, 2};
    const Document after = joined(inOneDocument({first, second}), {0, 3}, {1, 0});
    EXPECT_FALSE(problemOf(after));
    const Pieces pieces = piecesOf(*after.curves[0]);
    ASSERT_EQ(pieces.size(), 3u);
    expectNear(pieces.position({0, 0.4}), piecesOf(first).position({0, 0.4}), 1e-13, "first");
    expectNear(pieces.position({1, 0.5}), {7.5, 0}, 1e-13, "the leg between");
    expectNear(pieces.position({2, 0.4}), piecesOf(second).position({0, 0.4}), 1e-13, "second");
}

TEST(Join, refusesWhatHasNoTwoEnds) {
    Curve ring = curveOf("linear", {{0, 0}, {1, 1}, {2, 0}});
    ring.closed = true;
    const Document document =
        inOneDocument({curveOf("linear", {{0, 0}, {1, 1}, {2, 0}}), ring,
                       curveOf("linear", {{0, 0, 1}, {1, 1, 1}}),
                       curveOf("bezier", {{0, 0}, {1, 1}}), curveOf("bezier", {{1, 1}, {5, 2}})});
    expectRefused(joinCurves(document, {0, 1}, {2, 0}), "/curves/0/points/1", "not at an end");
    expectRefused(joinCurves(document, {0, 2}, {1, 0}), "/curves/1/closed", "closed");
    expectRefused(joinCurves(document, {0, 2}, {0, 0}), "/curves/0", "both ends");
    expectRefused(joinCurves(document, {0, 2}, {2, 0}), "/curves/2/points", "3 coordinates");
    expectRefused(joinCurves(document, {3, 1}, {4, 0}), "/curves/4/family", "one piece");
}

TEST(Split, staysInItsFamilyAtAPoint) {
    for (const std::string family : {"cardinal", "kochanek-bartels", "hermite", "linear"}) {
        Dice dice(3);
        Curve curve = curveOf(family, Points(2));
        rollPoints(curve, 6, {9, 9}, 20, dice);
        const auto result = splitCurve(inOneDocument({curve}), PointId{0, 2});
        ASSERT_TRUE(std::holds_alternative<Document>(result)) << family;
        const auto& after = std::get<Document>(result);
        ASSERT_EQ(after.curves.size(), 2u);
        EXPECT_EQ(after.curves[0]->family, family);
        EXPECT_EQ(after.curves[1]->name, curve.name + " 2");
        EXPECT_EQ(after.curves[1].look.colour, 1) << "that of the whole";
    }
}

TEST(Split, refusesEnds) {
    const Document document = inOneDocument({curveOf("cardinal", {{0, 0}, {1, 1}, {4, 2}})});
    expectRefused(splitCurve(document, PointId{0, 0}), "/curves/0", "ends there");
    expectRefused(splitCurve(document, PointId{0, 2}), "/curves/0", "ends there");
    expectRefused(openAt(document, {0, 1}), "/curves/0/closed", "open");
    const Document none = inOneDocument({curveOf("cardinal", {{1, 1}})});
    expectRefused(splitCurve(none, PointId{0, 0}), "/curves/0", "too few points");
}

TEST(Split, modesGoWithTheirAnchors) {
    Document document = inOneDocument({curveOf("bezier-spline", {{0, 0},
                                                                 {1, 2},
                                                                 {3, 4},
                                                                 {4, 4},
                                                                 {5, 4},
                                                                 {8, 1},
                                                                 {9, 0},
                                                                 {10, -1},
                                                                 {5, -2},
                                                                 {4, 0},
                                                                 {3, 2},
                                                                 {0, 5},
                                                                 {0, 7},
                                                                 {0, 8},
                                                                 {1, 9},
                                                                 {3, 9}})});
    document.curves[0].handleModes = {{3, HandleMode::corner}, {12, HandleMode::corner}};
    const auto split = std::get<Document>(splitCurve(document, 0, {2, 0.5}));
    EXPECT_EQ(split.curves[0].handleModes, (HandleModes{{3, HandleMode::corner}}));
    EXPECT_EQ(split.curves[1].handleModes, (HandleModes{{6, HandleMode::corner}}));
    EXPECT_EQ(joined(split, {0, 9}, {1, 0}).curves[0].handleModes,
              (HandleModes{{3, HandleMode::corner}, {15, HandleMode::corner}}));
    document = setClosed(document, 0, true);
    const auto opened = std::get<Document>(openAt(document, {0, 6}));
    EXPECT_EQ(opened.curves[0].handleModes,
              (HandleModes{{6, HandleMode::corner}, {15, HandleMode::corner}}));
    EXPECT_EQ(opened.curves[0]->points.at(0), document.curves[0]->points.at(6));
}

} // namespace
} // namespace splineloft
