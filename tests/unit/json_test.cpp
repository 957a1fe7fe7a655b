// The document's own format: defaults are filled in, and what was written reads back as it was.
#include "core/formats/document_json.h"
#include "core/formats/json_tape.h"
#include "core/spline/catalog.h"
#include "tests/cases.h"
#include "tests/unit/comma_locale.h"
#include "tests/unit/json_documents.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

namespace splineloft {
namespace {

Curve onlyCurve(const std::string& text) {
    const auto document = readDocument(text);
    if (!document) {
        ADD_FAILURE() << document.refusal().message() << " in " << text;
        return Curve();
    }
    EXPECT_EQ(document->curves.size(), 1u);
    return *document->curves.at(0);
}

TEST(ReadDocument, fillsInDefaults) {
    const auto curve = onlyCurve(curveWith(""));
    EXPECT_EQ(curve.name, "curve 1");
    EXPECT_EQ(curve.parameters, (std::map<std::string, double>{{"tension", 0.5}}));
    EXPECT_EQ(curve.coordinates, (std::vector<std::string>{"x", "y"}));
    EXPECT_FALSE(curve.closed);
    EXPECT_EQ(curve.ends, Ends::doubled);
    EXPECT_EQ(onlyCurve(linear("[]")).ends, Ends::none);
}

TEST(ReadDocument, namesCoordinatesByDimension) {
    EXPECT_EQ(onlyCurve(linear("[[1]]")).coordinates, (std::vector<std::string>{"x"}));
    EXPECT_EQ(onlyCurve(linear("[[1, 2, 3, 4, 5, 6]]")).coordinates,
              (std::vector<std::string>{"x", "y", "z", "w", "c4", "c5"}));
    EXPECT_EQ(usualCoordinates(16).size(), 16u);
    EXPECT_EQ(onlyCurve(linear("[]", R"(, "coordinates": ["a", "b", "c"])")).points.dimension(), 3);
}

TEST(ReadDocument, takesNoneOrTheFamilysEndsWhereClosed) {
    EXPECT_EQ(onlyCurve(curveWith(R"("closed": true, "ends": "none")")).ends, Ends::none);
    EXPECT_EQ(onlyCurve(curveWith(R"("closed": true, "ends": "reflected")")).ends, Ends::reflected);
    EXPECT_EQ(onlyCurve(curveWith(R"("closed": true)")).ends, Ends::doubled);
}

TEST(ReadDocument, takesKeysInAnyOrder) {
    const auto document = readDocument(
        R"({"extras": {}, "curves": [{"points": [[1, 2]], "parameters": {}, "family": "duff"}],)"
        R"("version": 1, "format": "splineloft"})");
    ASSERT_TRUE(document) << document.refusal().message();
    EXPECT_EQ(document->curves[0]->family, "duff");
}

TEST(ReadDocument, takesTheLargestOfEverything) {
    const auto curve = onlyCurve(linear("[[1e9, -1000000000, 0" + repeated(", 1", 13) + "]]"));
    EXPECT_EQ(curve.points.dimension(), 16);
    EXPECT_EQ(curve.points[0][0], 1e9);
    const std::string deep = repeated("[", deepestNesting - 2) + repeated("]", deepestNesting - 2);
    EXPECT_TRUE(readDocument(
        R"({"format": "splineloft", "version": 1, "curves": [], "extras": {"a": )" + deep + "}}"));
}

TEST(ReadDocument, readsNumbersExactly) {
    const auto points = onlyCurve(linear("[[0.1, 1e-300], [5e-324, 123456789.123456789],"
                                         " [-0.0, 0.30000000000000004], [1e-999, 2.5E+2]]"))
                            .points;
    EXPECT_EQ(points[0][0], 0.1);
    EXPECT_EQ(points[0][1], 1e-300);
    EXPECT_EQ(points[1][0], 5e-324);
    EXPECT_EQ(points[1][1], 123456789.123456789);
    EXPECT_TRUE(std::signbit(points[2][0]));
    EXPECT_EQ(points[2][1], 0.1 + 0.2);
    EXPECT_EQ(points[3][0], 0);
    EXPECT_EQ(points[3][1], 250);
}

Document awkwardDocument() {
    Document document;
    Curve path;
    path.name = "Straße 曲线 \"1\" \\ \n\t🙂";
    path.coordinates = {"x", "ü/~"};
    for (const double x : {0.1, 1e-300, -0.0, 123456789.123456789, 1e9, -1e9, 5e-324, 1.0 / 3,
                           2.2250738585072014e-308, 100000.0, 1e-5, 9.9e-6, 0.1 + 0.2, -2.5}) {
        path.points.append({x, -x});
    }
    path.parameters = {{"tension", 0.1 + 0.2}};
    document.curves.push_back(std::make_shared<const Curve>(path));
    Curve hermite;
    hermite.name = "";
    hermite.family = "hermite";
    hermite.ends = Ends::none;
    hermite.closed = true;
    hermite.coordinates = {"value"};
    hermite.points = Points{{1.0}, {2.0}, {4.0}};
    hermite.tangents = Points{{0.5}, {-0.0}, {1e-9}};
    document.curves.push_back(std::make_shared<const Curve>(hermite));
    document.extras = "{\"b\": [1, 2.50, 1E3], \"a\": {\"ok\": true, \"no\": null, \"id\": "
                      "18446744073709551615, \"low\": -9223372036854775808}, \"t\": \"ä\\n\"}";
    return document;
}

void expectStable(const Document& document) {
    const auto first = writeDocument(document);
    const auto read = readDocument(first);
    ASSERT_TRUE(read) << read.refusal().message();
    EXPECT_EQ(writeDocument(*read), first);
    const auto again = readDocument(writeDocument(*read));
    ASSERT_TRUE(again);
    EXPECT_TRUE(*again == *read);
    ASSERT_EQ(read->curves.size(), document.curves.size());
    for (std::size_t i = 0; i < read->curves.size(); ++i) {
        EXPECT_EQ(read->curves[i]->points, document.curves[i]->points) << "curve " << i;
        EXPECT_EQ(read->curves[i]->name, document.curves[i]->name) << "curve " << i;
    }
}

TEST(WriteDocument, readsBackToTheSameBytes) {
    expectStable(awkwardDocument());
}

TEST(WriteDocument, readsBackToTheSameBytesForEveryFamily) {
    for (const auto& family : catalog()) {
        for (const auto ends : family.ends) {
            Curve curve;
            curve.family = family.id;
            curve.ends = ends;
            curve.closed = family.closable;
            curve.coordinates = {"x", "y", "z"};
            curve.points = Points{{0.5, 1, -2}, {3, 1e-7, 4}, {-5, 0.7, 0.1}, {8, 8, 8}};
            if (family.usesTangents) {
                curve.tangents = curve.points;
            }
            SCOPED_TRACE(std::string(family.id) + " " + std::string(nameOf(ends)));
            expectStable({{std::make_shared<const Curve>(curve)}, "{}"});
        }
    }
}

/// B-splines, open and closed, with knots, weights and local parameters of awkward values.
Document documentWithLists() {
    Curve open;
    open.family = "nurbs";
    open.parameters = {{"degree", 2}, {"alpha", 0.1 + 0.2}};
    open.points = Points{{0.5, 1}, {3, 1e-7}, {-5, 0.7}, {8, 8}};
    open.ends = Ends::none;
    open.knots = {-1e300, -0.1, 1e-300, 0.25, 1.0 / 3, 1.0 / 3, 1e300};
    open.weights = {1e-9, 1, std::sqrt(2.0) / 2, 1e9};
    Curve closed = open;
    closed.family = "b-spline";
    closed.closed = true;
    closed.knots = {0, 0, 0.1 + 0.2, 2, 1e9};
    closed.weights.clear();
    Curve local;
    local.family = "beta";
    local.points = open.points;
    local.local = {{"bias", {1e-3, 1, 1.0 / 3, 1e3}}, {"tension", {0, -0.0, 1e6, 1e-7}}};
    Curve both = local;
    both.family = "kochanek-bartels";
    both.ends = Ends::open;
    both.local = {{"continuity", {-1, 1, 0, 0.1}}};
    Document document;
    for (const auto& curve : {open, closed, local, both}) {
        document.curves.push_back(std::make_shared<const Curve>(curve));
    }
    return document;
}

TEST(WriteDocument, readsKnotsWeightsAndLocalParametersBackToTheSameBytes) {
    const auto document = documentWithLists();
    expectStable(document);
    const auto read = readDocument(writeDocument(document));
    ASSERT_TRUE(read) << read.refusal().message();
    for (std::size_t i = 0; i < document.curves.size(); ++i) {
        EXPECT_EQ(read->curves[i]->knots, document.curves[i]->knots) << i;
        EXPECT_EQ(read->curves[i]->weights, document.curves[i]->weights) << i;
        EXPECT_EQ(read->curves[i]->local, document.curves[i]->local) << i;
        EXPECT_EQ(read->curves[i]->ends, document.curves[i]->ends) << i;
    }
}

TEST(WriteDocument, laysListsOutInLines) {
    const auto text = writeDocument(documentWithLists());
    for (const std::string line :
         {R"(      "knots": [0, 0, 0.30000000000000004, 2, 1000000000],)",
          R"(      "weights": [1e-09, 1, 0.7071067811865476, 1000000000],)",
          "      \"local\": {\n        \"bias\": [0.001, 1, 0.3333333333333333, 1000],\n"
          "        \"tension\": [0, -0.0, 1000000, 1e-07]\n      },\n"}) {
        EXPECT_NE(text.find(line), std::string::npos) << line << " in " << text;
    }
}

TEST(ReadDocument, fillsInTheEndsOfOwnKnots) {
    const std::string points = R"("points": [[0, 1], [2, 3], [5, 4], [6, 1]])";
    const std::string knots = R"("knots": [0, 0, 0, 0, 1, 1, 1, 1])";
    EXPECT_EQ(
        onlyCurve(withCurves(R"({"family": "b-spline", )" + points + ", " + knots + "}")).ends,
        Ends::none);
    EXPECT_EQ(onlyCurve(withCurves(R"({"family": "b-spline", )" + points + "}")).ends,
              Ends::doubled);
    const auto nurbs = onlyCurve(withCurves(R"({"family": "nurbs", )" + points + "}"));
    EXPECT_EQ(nurbs.ends, Ends::clamped);
    EXPECT_TRUE(nurbs.weights.empty());
    EXPECT_EQ(nurbs.parameters, (std::map<std::string, double>{{"alpha", 0}, {"degree", 3}}));
}

TEST(ReadDocument, takesAnEmptyObjectOfLocalParameters) {
    EXPECT_TRUE(onlyCurve(curveWith(R"("local": {})")).local.empty());
}

TEST(WriteDocument, keepsTheSignOfZero) {
    const auto text = writeDocument(awkwardDocument());
    EXPECT_NE(text.find("[-0.0, 0]"), std::string::npos) << text;
    const auto document = readDocument(text);
    ASSERT_TRUE(document);
    EXPECT_TRUE(std::signbit(document->curves[0]->points[2][0]));
}

TEST(WriteDocument, isLaidOutForPeople) {
    const auto document = readDocument(curveWith(R"("name": "path")"));
    ASSERT_TRUE(document);
    EXPECT_EQ(writeDocument(*document), R"({
  "$schema": "urn:splineloft:document:1",
  "format": "splineloft",
  "version": 1,
  "curves": [
    {
      "name": "path",
      "family": "cardinal",
      "parameters": {"tension": 0.5},
      "coordinates": ["x", "y"],
      "points": [
        [0, 1],
        [2, 3]
      ],
      "closed": false,
      "ends": "doubled"
    }
  ],
  "extras": {}
}
)");
}

TEST(WriteDocument, carriesExtrasAlongAsTheyWereSpelled) {
    const auto text = writeDocument(awkwardDocument());
    EXPECT_NE(text.find(R"(  "extras": {
    "b": [1, 2.50, 1E3],
    "a": {
      "ok": true,
      "no": null,
      "id": 18446744073709551615,
      "low": -9223372036854775808
    },
    "t": "ä\n"
  }
}
)"),
              std::string::npos)
        << text;
}

TEST(WriteDocument, laysOutNestedExtrasStably) {
    for (const std::string extras :
         {"{}", "{\"a\": []}", "{\"a\": [[1, 2], [3], []], \"b\": [{}]}",
          "{\"a\": [1, {\"b\": [2]}]}", "{\"a\": {\"b\": {\"c\": [[[1]]]}}}",
          "{\"\": 0, \"\\u0001\": \"\\\"\"}"}) {
        Document document;
        document.extras = extras;
        SCOPED_TRACE(extras);
        expectStable(document);
    }
}

TEST(WriteDocument, writesTheEmptyDocument) {
    expectStable({});
    expectStable({{std::make_shared<const Curve>()}, "{}"});
}

TEST(WriteDocument, throwsForWhatCouldNotBeReadBack) {
    auto document = awkwardDocument();
    document.extras = "{\"a\": 1, \"a\": 2}";
    EXPECT_THROW(writeDocument(document), std::invalid_argument);
    document.extras = "[]";
    EXPECT_THROW(writeDocument(document), std::invalid_argument);
    Curve broken;
    broken.points = Points{{0.0, std::nan("")}};
    EXPECT_THROW(writeDocument({{std::make_shared<const Curve>(broken)}, "{}"}),
                 std::invalid_argument);
}

TEST(WriteDocument, replacesWhatIsNotUtf8) {
    Curve curve;
    curve.name = "a\xff"
                 "b";
    EXPECT_EQ(onlyCurve(writeDocument({{std::make_shared<const Curve>(curve)}, "{}"})).name,
              "a\uFFFDb");
}

TEST(WriteDocument, doesNotFollowTheLocale) {
    const auto expected = writeDocument(awkwardDocument());
    const CommaLocale comma;
    SPLINELOFT_NEED_COMMA(comma);
    EXPECT_EQ(writeDocument(awkwardDocument()), expected);
    expectStable(awkwardDocument());
    EXPECT_EQ(onlyCurve(linear("[[0.1, 1e-3]]")).points[0][0], 0.1);
    const auto wrong = readDocument(curveWith(R"("parameters": {"tension": 1e999})"));
    ASSERT_FALSE(wrong);
    EXPECT_EQ(wrong.refusal().place, "/curves/0/parameters/tension");
}

// A quadratic step in it would take hours, and the time that ctest leaves to a test is minutes.
// (The sanitizers, for which it takes one, see fewer points.)
TEST(WriteDocument, takesAMillionPointsInItsStride) {
    constexpr auto count =
        testing_curves::underSanitizers ? mostPointsOfACurve / 20 : mostPointsOfACurve;
    Curve curve;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> anywhere(-1e6, 1e6);
    curve.points.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        curve.points.append({anywhere(random), anywhere(random)});
    }
    const Document document{{std::make_shared<const Curve>(std::move(curve))}, "{}"};
    const auto read = readDocument(writeDocument(document));
    ASSERT_TRUE(read) << read.refusal().message();
    EXPECT_EQ(read->curves[0]->points, document.curves[0]->points);
}

TEST(Examples, areDocumentsAsTheProgramWritesThem) {
    const auto folder = std::filesystem::path(SPLINELOFT_TESTS_DIR) / "../assets/examples";
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        std::ostringstream text;
        text << std::ifstream(entry.path()).rdbuf();
        const auto document = readDocument(text.str());
        ASSERT_TRUE(document) << entry.path() << document.refusal().message();
        EXPECT_EQ(writeDocument(*document), text.str()) << entry.path();
        ++count;
    }
    EXPECT_GE(count, catalog().size());
}

} // namespace
} // namespace splineloft
