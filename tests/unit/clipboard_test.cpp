// Curves as text: out as documents, in from whatever people copy.
#include "core/formats/clipboard.h"

#include "core/formats/document_json.h"
#include "tests/property/random_curves.h"

#include <array>

namespace splineloft {
namespace {

using namespace testing_curves;

std::vector<CurveEntry> pastedCurves(const std::string& text) {
    auto result = pasted(text);
    EXPECT_TRUE(result) << text << ": " << result.refusal().message();
    return result ? result->curves : std::vector<CurveEntry>();
}

Curve pastedAlone(const std::string& text) {
    const auto curves = pastedCurves(text);
    EXPECT_EQ(curves.size(), 1u) << text;
    return curves.empty() ? Curve() : *curves.front();
}

void expectRefused(const std::string& text, const std::string& place, const std::string& what) {
    const auto result = pasted(text);
    ASSERT_FALSE(result) << text;
    EXPECT_EQ(result.refusal().place, place) << text << ": " << result.refusal().message();
    EXPECT_NE(result.refusal().what.find(what), std::string::npos) << result.refusal().message();
    EXPECT_FALSE(result.refusal().remedy.empty());
}

Document everyFamily() {
    Document document;
    for (const auto& form : everyForm()) {
        Curve curve = randomCurve(form, 5);
        completeParameters(curve);
        if (curve.tangents.empty()) {
            curve.tangents = Points(); // of no dimension that a file could tell
        }
        document.curves.push_back(std::make_shared<Curve>(curve));
    }
    document.curves[1].look.colour = 4;
    document.extras = R"({"a": 1})";
    return document;
}

TEST(Clipboard, copiedCurvesComeBack) {
    const Document document = everyFamily();
    for (std::size_t i = 0; i < document.curves.size(); ++i) {
        const auto curves = pastedCurves(copiedCurves(document, std::array{i}));
        ASSERT_EQ(curves.size(), 1u);
        EXPECT_EQ(curves[0], document.curves[i]);
    }
    const auto two = pastedCurves(copiedCurves(document, std::array<std::size_t, 3>{3, 1, 3}));
    ASSERT_EQ(two.size(), 2u);
    EXPECT_EQ(two[0], document.curves[1]);
    EXPECT_EQ(copiedCurves(document, std::array<std::size_t, 1>{0}).find("\"a\""),
              std::string::npos)
        << "what others keep belongs to the whole document";
}

TEST(Clipboard, copiedPointsBringWhatBelongsToThem) {
    Curve curve = emptyCurve({"nurbs", true, Ends::clamped}, 2);
    curve.points = {{0, 0}, {1, 3}, {4, 4}, {6, 0}, {9, -1}};
    curve.weights = {1, 2, 3, 4, 5};
    completeParameters(curve);
    const Document document = {{std::make_shared<Curve>(curve)}, "{}"};
    const Curve few =
        pastedAlone(copiedPoints(document, std::vector<PointId>{{0, 3}, {0, 1}, {0, 3}}));
    EXPECT_EQ(few.points, (Points{{1, 3}, {6, 0}}));
    EXPECT_EQ(few.weights, (std::vector<double>{2, 4}));
    EXPECT_FALSE(few.closed);
    std::vector<PointId> all;
    for (std::size_t i = 0; i < 5; ++i) {
        all.push_back({0, i});
    }
    EXPECT_EQ(pastedAlone(copiedPoints(document, all)), curve);
}

TEST(Clipboard, copiedAnchorsBringTheirHandles) {
    Curve curve = emptyCurve({"bezier-spline", true, Ends::none}, 2);
    curve.points = {{0, 0}, {1, 2}, {3, 4}, {4, 4}, {5, 5}, {8, 1}, {9, 0}, {7, -3}, {1, -2}};
    Document document = {{std::make_shared<Curve>(curve)}, "{}"};
    document.curves[0].handleModes = {{3, HandleMode::automatic}};
    EXPECT_EQ(pastedAlone(copiedPoints(document, std::vector<PointId>{{0, 4}, {0, 6}})).points,
              (Points{{4, 4}, {5, 5}, {8, 1}, {9, 0}}));
    EXPECT_EQ(pastedAlone(copiedPoints(document, std::vector<PointId>{{0, 6}})).points,
              (Points{{9, 0}}));
}

/// Found by the undo laws: the anchor of the last handle is not there yet.
TEST(Clipboard, aLastHandleBringsTheLastAnchor) {
    Curve curve;
    curve.family = "bezier-spline";
    curve.ends = Ends::none;
    curve.points = {{0, 0}, {1, 1}, {2, 1}, {3, 0}, {4, -1}, {5, -1}};
    const Document document{{std::make_shared<const Curve>(curve)}, "{}"};
    const std::array last = {PointId{0, 5}};
    const auto copied = pasted(copiedPoints(document, last));
    ASSERT_TRUE(copied) << copied.refusal().message();
    ASSERT_EQ(copied->curves.size(), 1u);
    EXPECT_EQ(copied->curves[0]->points.at(0), (Point{3, 0}));
}

TEST(Clipboard, pointsOfSeveralCurvesStaySeveral) {
    const Document document = everyFamily();
    std::vector<PointId> ids;
    for (std::size_t i = 0; i < document.curves.size(); ++i) {
        ids.push_back({i, 0});
        ids.push_back({i, document.curves[i]->points.size() - 1});
        if (!document.curves[i]->tangents.empty()) {
            ids.push_back({i, 1, Part::tangent});
        }
    }
    const auto curves = pastedCurves(copiedPoints(document, ids));
    ASSERT_EQ(curves.size(), document.curves.size());
    for (std::size_t i = 0; i < curves.size(); ++i) {
        EXPECT_EQ(curves[i]->points.at(0), document.curves[i]->points.at(0));
        EXPECT_EQ(curves[i]->family, document.curves[i]->family);
    }
}

TEST(Paste, takesACurveAndPointsAsJson) {
    const Curve curve = pastedAlone(R"( {"family": "linear", "points": [[1, 2], [3, 4]]} )");
    EXPECT_EQ(curve.family, "linear");
    const Curve points = pastedAlone("\n[[1, 2, 0.5], [3, 4, 1e2]]");
    EXPECT_EQ(points.points, (Points{{1, 2, 0.5}, {3, 4, 100}}));
    EXPECT_EQ(points.family, "cardinal");
    EXPECT_EQ(points.coordinates, (std::vector<std::string>{"x", "y", "z"}));
}

TEST(Paste, refusesJsonAtItsOwnPlaces) {
    expectRefused("[[1, 2], [3]]", "/1", "1 coordinates");
    expectRefused("[1, 2]", "/0", "is a number");
    expectRefused("[[1, 2],\n [3, ]]", "2:6", "unexpected");
    expectRefused(R"({"family": "wavy", "points": []})", "/family", "no family");
    expectRefused(R"({"points": [[1, 2]]})", "/family", "missing");
    expectRefused(R"({"format": "splineloft", "version": 2, "curves": []})", "/version", "version");
    expectRefused(R"({"format": "splineloft", "version": 1, "curves": []})", "", "no curve");
    expectRefused("", "", "empty");
    expectRefused(" \n\t ", "", "empty");
}

TEST(Paste, takesLinesAsSpreadsheetsCopyThem) {
    const Points wanted = {{1, 2.5}, {-3, 4}, {0.001, 600}};
    for (const std::string text :
         {"1\t2.5\n-3\t4\n1e-3\t600\n", "1,2.5\r\n-3,4\r\n0.001,6e2",
          "1 2.5\n\n  -3   4 \n.001 600", "1;2.5\n-3;4\n0.001;600;\n", "1;2,5\n-3;4\n0,001;600\n",
          "1\t2,5\n-3\t4\n0,001\t+600", "\"1\",\"2.5\"\n\"-3\",\"4\"\n\"0.001\",\"600\"\n",
          "1, 2.5\n-3, 4\n0.001, 600"}) {
        EXPECT_EQ(pastedAlone(text).points, wanted) << text;
    }
    EXPECT_EQ(pastedAlone("7\n8\n9").points, (Points{{7}, {8}, {9}}));
    const Curve named = pastedAlone("time,height\n1,2\n3,4");
    EXPECT_EQ(named.coordinates, (std::vector<std::string>{"time", "height"}));
    EXPECT_EQ(named.points, (Points{{1, 2}, {3, 4}}));
    EXPECT_EQ(pastedAlone("a,a\n1,2").coordinates, (std::vector<std::string>{"x", "y"}))
        << "not unique";
}

/// Found by a fuzzer: a name of a coordinate had one, and then the document could not be read
/// again.
TEST(Paste, refusesNulCharacters) {
    const auto result = pasted(std::string_view("x y\0z\n1 2\n", 10));
    ASSERT_FALSE(result);
    EXPECT_EQ(result.refusal().place, "byte 3");
}

/// Found by a fuzzer: two names that differ in what is no UTF-8 are one name in the file.
TEST(Paste, namesCoordinatesItselfWhereTheirNamesWouldBeAlike) {
    const auto result = pasted("\xdf\t\xb2\n3\t4\n");
    ASSERT_TRUE(result) << result.refusal().message();
    EXPECT_EQ(result->curves[0]->coordinates, (std::vector<std::string>{"x", "y"}));
    const auto repaired = pasted("a\xdf\tb\n3\t4\n");
    ASSERT_TRUE(repaired);
    EXPECT_EQ(repaired->curves[0]->coordinates[0], "a\uFFFD");
}

TEST(Paste, refusesLinesAtLineAndColumn) {
    expectRefused("1,2\n3,4,5\n", "2:1", "3 numbers");
    expectRefused("1,2\n3,four\n", "2:3", "\"four\"");
    expectRefused("1,2\n3,\n5,6", "2:1", "1 numbers");
    expectRefused("1,2\n3,,4", "2:3", "no number");
    expectRefused("hello", "", "no numbers");
    expectRefused("hello\nworld", "2:1", "\"world\"");
    expectRefused("1,nan", "1:3", "no number");
    expectRefused("1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17", "1:1", "17 numbers");
    expectRefused("1,2\n1e300,4", "/curves/0/points/1/0", "too large");
}

TEST(Paste, takesPathsUpright) {
    const auto curves = pastedCurves("M0 0H10V2Z M 0 5 L 10 10");
    ASSERT_EQ(curves.size(), 2u);
    EXPECT_EQ(curves[0]->points, (Points{{0, 10}, {10, 10}, {10, 8}})) << "what was above stays so";
    EXPECT_EQ(curves[1]->points, (Points{{0, 5}, {10, 0}}));
    EXPECT_EQ(pastedAlone("m.1.2.1.1").points, (Points{{0.1, 0.3}, {0.2, 0.2}}));
    expectRefused("M0 0L1", "byte 6", "the data end");
    expectRefused("M5 5", "", "no curve");
}

TEST(Paste, takesThePathsOfAnSvgFile) {
    const auto curves = pastedCurves(R"(<?xml version="1.0"?>
<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 16 16">
  <defs><path d="M9 9L99 99"/></defs>
  <g><path id="roof" d="M0 4L4 0L8 4"/></g>
  <rect width="3" height="3"/><path d=""/>
  <path d="M0 4v4h8v-4z"/>
</svg>)");
    ASSERT_EQ(curves.size(), 2u);
    EXPECT_EQ(curves[0]->name, "roof");
    EXPECT_EQ(curves[0]->points, (Points{{0, 4}, {4, 8}, {8, 4}}));
    EXPECT_TRUE(curves[1]->closed);
    expectRefused("<svg><path d='M0 0L1 1'/><path d='M0 0L1'/></svg>", "byte 6", "path 2");
    expectRefused("<svg><path</svg>", "byte 11", "start element");
    expectRefused("<svg/>", "", "no curve");
}

} // namespace
} // namespace splineloft
