// What the reader of documents refuses: every fault with its place, what is wrong and what would be
// right. And what no text, however damaged, may do to it.
#include "core/formats/document_json.h"
#include "core/formats/json_tape.h"
#include "tests/unit/json_documents.h"

#include <gtest/gtest.h>

#include <ostream>
#include <random>

namespace splineloft {
namespace {

struct Refused {
    const char* title;
    std::string text;
    std::string place;  ///< exactly
    std::string what;   ///< part of it
    std::string remedy; ///< part of it
};

void PrintTo(const Refused& refused, std::ostream* out) {
    *out << refused.title;
}

class Refuses : public testing::TestWithParam<Refused> {};

TEST_P(Refuses, withPlaceAndRemedy) {
    const auto& expected = GetParam();
    const auto document = readDocument(expected.text);
    ASSERT_FALSE(document) << "was accepted: " << expected.text.substr(0, 200);
    const auto& refusal = document.refusal();
    EXPECT_EQ(refusal.place, expected.place) << refusal.message();
    EXPECT_NE(refusal.what.find(expected.what), std::string::npos) << refusal.message();
    EXPECT_NE(refusal.remedy.find(expected.remedy), std::string::npos) << refusal.message();
    EXPECT_FALSE(refusal.remedy.empty()) << refusal.message();
    EXPECT_EQ(refusal.message().find('\n'), std::string::npos) << "more than one line";
}

std::string titleOf(const testing::TestParamInfo<Refused>& info) {
    return info.param.title;
}

std::vector<Refused> noJson() {
    return {
        {"empty", "", "1:1", "unexpected end of input", "'{'"},
        {"notJson", "hello", "1:1", "invalid literal", "JSON"},
        {"unfinished", "{\"format\": \"splineloft\"", "1:24", "unexpected end of input", "'}'"},
        {"commaTooMuch", "{\n  \"format\": \"splineloft\",\n}", "3:1", "unexpected '}'", "string"},
        {"columnsCountCharacters", "{\"ä€😀\": x}", "1:9", "invalid literal", "JSON"},
        {"trailingBytes", withCurves("") + " x", "1:54", "invalid literal", "end of input"},
        {"secondDocument", withCurves("") + "\n" + withCurves(""), "2:1", "unexpected '{'",
         "end of input"},
        {"nulAtTheEnd", withCurves("") + std::string(1, '\0'), "1:53", "NUL", "text"},
        {"bytesAfterNul", withCurves("") + std::string("\0{}", 3), "1:53", "NUL", "text"},
        {"nulInside", "{\"for" + std::string(1, '\0') + "mat\": 1}", "1:6", "NUL", "text"},
        {"notANumber", R"({"a": NaN})", "1:7", "invalid literal", "JSON"},
        {"infinity", R"({"a": Infinity})", "1:7", "invalid literal", "JSON"},
        {"leadingPlus", R"({"a": +1})", "1:7", "invalid literal", "JSON"},
        {"leadingZero", R"({"a": 01})", "1:8", "unexpected number", "'}'"},
        {"comment", "// a comment\n" + withCurves(""), "1:1", "invalid literal", "JSON"},
        {"singleQuotes", "{'format': 1}", "1:2", "invalid literal", "string"},
        {"brokenUtf8", "{\"\xff\": 1}", "1:3", "ill-formed UTF-8", "string"},
        {"loneSurrogate", R"({"\ud800": 1})", "1:9", "surrogate", "string"},
        {"controlCharacter", "{\"a\tb\": 1}", "1:4", "control character", "string"},
    };
}

std::vector<Refused> badTree() {
    const std::string deepest = repeated("[", deepestNesting) + repeated("]", deepestNesting);
    const std::string huge = "123456789012345678901234567890";
    return {
        {"duplicateInRoot", R"({"format": "splineloft", "version": 1, "version": 1, "curves": []})",
         "/version", "stands twice", "once"},
        {"duplicateInCurve", curveWith(R"("name": "a", "name": "a")"), "/curves/0/name",
         "stands twice", "once"},
        {"duplicateParameter", curveWith(R"("parameters": {"tension": 1, "tension": 2})"),
         "/curves/0/parameters/tension", "stands twice", "once"},
        {"duplicateByEscape", curveWith(R"("parameters": {"tension": 1, "\u0074ension": 2})"),
         "/curves/0/parameters/tension", "stands twice", "once"},
        {"duplicateInExtras", R"({"extras": {"a": [{"b/~": 1, "b/~": 2}]}})", "/extras/a/0/b~1~0",
         "stands twice", "once"},
        {"tooDeep", R"({"curves": )" + deepest + "}",
         "/curves" + repeated("/0", deepestNesting - 1), "too deep", "64"},
        {"tooDeepInExtras", R"({"extras": {"a": )" + deepest + "}}",
         "/extras/a" + repeated("/0", deepestNesting - 2), "too deep", "64"},
        {"hugeExponent", curveWith(R"("parameters": {"tension": 1e999})"),
         "/curves/0/parameters/tension", "too large a number: \"1e999\"", "number"},
        {"hugeExponentInPoints",
         withCurves(R"({"family": "linear", "points": [[0, 0], [1, -1e999]]})"),
         "/curves/0/points/1/1", "too large a number", "number"},
        {"bigIntegerInExtras",
         R"({"format": "splineloft", "version": 1, "curves": [], "extras": {"id": [1, )" + huge +
             "]}}",
         "/extras/id/1", "more than 64 bits", "string"},
        {"bigNegativeIntegerInExtras", R"({"extras": {"id": -9223372036854775809}})", "/extras/id",
         "more than 64 bits", "string"},
        {"bigIntegerInPoints", withCurves(R"({"family": "linear", "points": [[)" + huge + ", 0]]}"),
         "/curves/0/points/0/0", "too large a coordinate", "-1e9 to 1e9"},
    };
}

std::vector<Refused> badHead() {
    return {
        {"rootIsArray", "[]", "", "is an array", "an object"},
        {"rootIsNumber", "123", "", "is a number", "an object"},
        {"formatMissing", R"({"version": 1, "curves": []})", "/format", "missing",
         "\"splineloft\""},
        {"formatOfAnother", R"({"format": "gltf", "version": 1, "curves": []})", "/format",
         "\"gltf\"", "\"splineloft\""},
        {"formatNotText", R"({"format": 1, "version": 1, "curves": []})", "/format", "is a number",
         "a string"},
        {"versionMissing", R"({"format": "splineloft", "curves": []})", "/version", "missing", "1"},
        {"versionUnknown", R"({"format": "splineloft", "version": 2, "curves": []})", "/version",
         "does not know", "1"},
        {"versionText", R"({"format": "splineloft", "version": "1", "curves": []})", "/version",
         "is a string", "a number"},
        {"versionTrue", R"({"format": "splineloft", "version": true, "curves": []})", "/version",
         "is true or false", "a number"},
        {"curvesMissing", R"({"format": "splineloft", "version": 1})", "/curves", "missing",
         "array"},
        {"curvesObject", R"({"format": "splineloft", "version": 1, "curves": {}})", "/curves",
         "is an object", "an array"},
        {"unknownKey", R"({"format": "splineloft", "version": 1, "curves": [], "camera": 1})",
         "/camera", "\"camera\" is no key of a document", "extras"},
        {"emptyKey", R"({"format": "splineloft", "version": 1, "curves": [], "": 1})", "/",
         "\"\" is no key", "extras"},
        {"schemaNotText", R"({"$schema": 1, "format": "splineloft", "version": 1, "curves": []})",
         "/$schema", "is a number", "a string"},
        {"extrasArray", R"({"format": "splineloft", "version": 1, "curves": [], "extras": [1]})",
         "/extras", "is an array", "an object"},
        {"extrasNull", R"({"format": "splineloft", "version": 1, "curves": [], "extras": null})",
         "/extras", "is null", "an object"},
    };
}

std::vector<Refused> badCurve() {
    return {
        {"curveIsNull", withCurves("null"), "/curves/0", "is null", "an object"},
        {"familyMissing", withCurves(R"({"points": []})"), "/curves/0/family", "missing", "family"},
        {"familyUnknown", withCurves(R"({"family": "spline", "points": []})"), "/curves/0/family",
         "no family \"spline\"", "cardinal"},
        {"familyNumber", withCurves(R"({"family": 1, "points": []})"), "/curves/0/family",
         "is a number", "a string"},
        {"unknownKeyOfCurve", curveWith(R"("colour": "red")"), "/curves/0/colour",
         "\"colour\" is no key of a curve", "extras"},
        {"keyWithSlash", curveWith(R"("a/b~c": 1)"), "/curves/0/a~1b~0c", "is no key", "extras"},
        {"knots", curveWith(R"("knots": [0, 1])"), "/curves/0/knots",
         "the family cardinal takes no knots", "leave"},
        {"weights", curveWith(R"("weights": [1, 1])"), "/curves/0/weights",
         "the family cardinal takes no weights", "leave"},
        {"local", withCurves(R"({"family": "linear", "points": [], "local": {}})"),
         "/curves/0/local", "the family linear takes no local", "leave"},
        {"tangentsOfCardinal", curveWith(R"("tangents": [])"), "/curves/0/tangents",
         "the family cardinal takes no tangents", "leave"},
        {"secondCurve",
         withCurves(R"({"family": "linear", "points": []}, {"family": "linear", "points": 1})"),
         "/curves/1/points", "is a number", "an array"},
        {"nameNumber", curveWith(R"("name": 1)"), "/curves/0/name", "is a number", "a string"},
        {"nameWithNul", curveWith(R"("name": "a\u0000b")"), "/curves/0/name", "NUL", "without"},
        {"parametersArray", curveWith(R"("parameters": [1])"), "/curves/0/parameters",
         "is an array", "an object"},
        {"parameterUnknown", curveWith(R"("parameters": {"bias": 1})"), "/curves/0/parameters/bias",
         "no parameter \"bias\"", "tension"},
        {"parameterEscaped", curveWith(R"("parameters": {"a/~": 1})"), "/curves/0/parameters/a~1~0",
         "no parameter", "tension"},
        {"parameterNull", curveWith(R"("parameters": {"tension": null})"),
         "/curves/0/parameters/tension", "is null", "a number"},
        {"parameterText", curveWith(R"("parameters": {"tension": "0.5"})"),
         "/curves/0/parameters/tension", "is a string", "a number"},
        {"parameterOutOfRange", curveWith(R"("parameters": {"tension": 101})"),
         "/curves/0/parameters/tension", "is 101", "-100 to 100"},
        {"parameterNotWhole",
         withCurves(R"({"family": "b-spline", "parameters": {"degree": 2.5}, "points": []})"),
         "/curves/0/parameters/degree", "is 2.5", "whole number from 1 to 25"},
        {"closedText", curveWith(R"("closed": "yes")"), "/curves/0/closed", "is a string",
         "true or false"},
        {"closedBezier", withCurves(R"({"family": "bezier", "points": [], "closed": true})"),
         "/curves/0/closed", "cannot be closed", "false"},
        {"endsUnknown", curveWith(R"("ends": "looped")"), "/curves/0/ends", "\"looped\"",
         "doubled"},
        {"endsNumber", curveWith(R"("ends": 0)"), "/curves/0/ends", "is a number", "a string"},
        {"endsOfAnother", curveWith(R"("ends": "clamped")"), "/curves/0/ends", "\"clamped\"",
         "doubled, open, reflected"},
        {"endsNoneWhereOpen", curveWith(R"("ends": "none")"), "/curves/0/ends", "\"none\"",
         "doubled"},
        {"endsOfClosed", curveWith(R"("closed": true, "ends": "clamped")"), "/curves/0/ends",
         "\"clamped\"", "doubled"},
    };
}

std::vector<Refused> badTables() {
    const std::string seventeen = "[" + repeated("0, ", 16) + "0]";
    const std::string names = R"(, "coordinates": )";
    return {
        {"pointsMissing", withCurves(R"({"family": "linear"})"), "/curves/0/points", "missing",
         "array of points"},
        {"pointIsNumber", linear("[1, 2]"), "/curves/0/points/0", "is a number", "an array"},
        {"pointIsObject", linear(R"([{"x": 1}])"), "/curves/0/points/0", "is an object",
         "an array"},
        {"coordinateNull", linear("[[0, 0], [0, null]]"), "/curves/0/points/1/1", "is null",
         "a number"},
        {"coordinateText", linear(R"([["0", 0]])"), "/curves/0/points/0/0", "is a string",
         "a number"},
        {"coordinateArray", linear("[[0, [0]]]"), "/curves/0/points/0/1", "is an array",
         "a number"},
        {"coordinateTooLarge", linear("[[0, 0], [1000000001, 0]]"), "/curves/0/points/1/0",
         "too large a coordinate", "1e9"},
        {"coordinateTooSmall", linear("[[0, -1.0000000001e9]]"), "/curves/0/points/0/1",
         "too large a coordinate", "1e9"},
        {"ragged", linear("[[0, 0], [1, 1], [2, 2, 2]]"), "/curves/0/points/2", "has 3 coordinates",
         "2, as many as the first"},
        {"noCoordinates", linear("[[]]"), "/curves/0/points/0", "has 0 coordinates", "1 to 16"},
        {"tooManyCoordinates", linear("[" + seventeen + "]"), "/curves/0/points/0",
         "has 17 coordinates", "1 to 16"},
        {"tooFewNames", linear("[[0, 0]]", names + R"(["x"])"), "/curves/0/coordinates",
         "names 1 coordinate", "one name for each"},
        {"noNames", linear("[[0, 0]]", names + "[]"), "/curves/0/coordinates", "has 0 names",
         "1 to 16"},
        {"sameNames", linear("[[0, 0]]", names + R"(["x", "x"])"), "/curves/0/coordinates/0",
         "stands twice", "of its own"},
        {"emptyName", linear("[[0, 0]]", names + R"(["x", ""])"), "/curves/0/coordinates/1",
         "is empty", "of its own"},
        {"nameIsNumber", linear("[[0, 0]]", names + R"(["x", 1])"), "/curves/0/coordinates/1",
         "is a number", "a string"},
        {"namesAreText", linear("[[0, 0]]", names + R"("xy")"), "/curves/0/coordinates",
         "is a string", "an array"},
        {"tangentsMissing", withCurves(R"({"family": "hermite", "points": [[0, 0]]})"),
         "/curves/0/tangents", "missing", "one for each point"},
        {"tooFewTangents",
         withCurves(R"({"family": "hermite", "points": [[0, 0], [1, 1]], "tangents": [[1, 0]]})"),
         "/curves/0/tangents", "has 1 tangent for 2 points", "one tangent for each point"},
        {"tangentsOfOtherDimension",
         withCurves(R"({"family": "hermite", "points": [[0, 0]], "tangents": [[1]]})"),
         "/curves/0/tangents", "has 1 coordinates", "2"},
        {"tangentTooLarge",
         withCurves(R"({"family": "hermite", "points": [[0, 0]], "tangents": [[1, 2e9]]})"),
         "/curves/0/tangents/0/1", "too large a coordinate", "1e9"},
        {"tooManyPointsOfBezier",
         withCurves(R"({"family": "bezier", "points": [[0, 0])" + repeated(", [1, 1]", 256) + "]}"),
         "/curves/0/points", "has 257 points", "at most 256"},
    };
}

/// A B-spline of degree 3 with four points; of a closed one the same points go around.
std::string bSpline(const std::string& keys, const std::string& family = "b-spline") {
    return withCurves(R"({"family": ")" + family +
                      R"(", "points": [[0, 1], [2, 3], [5, 4], [6, 1]], )" + keys + "}");
}

std::vector<Refused> badKnots() {
    const std::string good = R"("knots": [0, 0, 0, 0, 1, 1, 1, 1])";
    return {
        {"knotsEmpty", bSpline(R"("knots": [])"), "/curves/0/knots", "is empty", "numbers"},
        {"knotsNumber", bSpline(R"("knots": 8)"), "/curves/0/knots", "is a number", "an array"},
        {"knotText", bSpline(R"("knots": [0, "0"])"), "/curves/0/knots/1", "is a string",
         "a number"},
        {"tooFewKnots", bSpline(R"("knots": [0, 0, 0, 1, 1, 1, 1])"), "/curves/0/knots",
         "has 7 knots for 4 points and degree 3", "8 knots"},
        {"tooManyKnots", bSpline(R"("knots": [0, 0, 0, 0, 0.5, 1, 1, 1, 1])"), "/curves/0/knots",
         "has 9 knots", "8 knots"},
        {"knotsOfAnotherDegree", bSpline(good + R"(, "parameters": {"degree": 2})"),
         "/curves/0/knots", "has 8 knots for 4 points and degree 2", "7 knots"},
        {"openKnotsOfAClosedCurve", bSpline(good + R"(, "closed": true)"), "/curves/0/knots",
         "has 8 knots", "5 knots"},
        {"fallingKnot", bSpline(R"("knots": [0, 0, 0, 0.5, 0.25, 1, 1, 1])"), "/curves/0/knots/4",
         "falls from 0.5 to 0.25", "never fall"},
        {"knotTooOften", bSpline(R"("knots": [0, 0, 0, 0, 0, 1, 1, 1])"), "/curves/0/knots/4",
         "0 stands more than 4 times", "at most 4 times"},
        {"knotTooOftenAround", bSpline(R"("closed": true, "knots": [0, 1, 1, 1, 1])"),
         "/curves/0/knots/4", "1 stands more than 3 times", "at most 3 times"},
        {"knotTooLarge", bSpline(R"("knots": [0, 0, 0, 0, 1, 1, 1, 1e301])"), "/curves/0/knots/7",
         "is 1e+301", "-1e+300 to 1e+300"},
        {"noInterval", bSpline(R"("knots": [0, 0, 0, 1, 1, 1, 1, 2])"), "/curves/0/knots",
         "no interval", "knot 3 below knot 4"},
        {"endsBesideKnots", bSpline(good + R"(, "ends": "clamped")"), "/curves/0/ends",
         "is \"clamped\"", "with knots of its own: none"},
        {"endsBesideClosedKnots",
         bSpline(R"("closed": true, "knots": [0, 1, 2, 3, 4], "ends": "doubled")"),
         "/curves/0/ends", "is \"doubled\"", "with knots of its own: none"},
        {"noneWithoutKnots", bSpline(R"("ends": "none")"), "/curves/0/ends", "is \"none\"",
         "doubled, open, reflected, clamped"},
        {"knotsOfDuff", bSpline(good, "duff"), "/curves/0/knots", "the family duff takes no knots",
         "leave"},
    };
}

std::vector<Refused> badWeights() {
    const auto nurbs = [](const std::string& keys) { return bSpline(keys, "nurbs"); };
    return {
        {"weightsEmpty", nurbs(R"("weights": [])"), "/curves/0/weights", "is empty", "numbers"},
        {"tooFewWeights", nurbs(R"("weights": [1, 2, 1])"), "/curves/0/weights",
         "has 3 weights for 4 points", "one weight for each point"},
        {"tooManyWeights", nurbs(R"("weights": [1, 2, 1, 1, 1])"), "/curves/0/weights",
         "has 5 weights for 4 points", "one weight for each point"},
        {"weightZero", nurbs(R"("weights": [1, 2, 0, 1])"), "/curves/0/weights/2", "is 0",
         "1e-09 to 1e+09"},
        {"weightNegative", nurbs(R"("weights": [1, -2, 1, 1])"), "/curves/0/weights/1", "is -2",
         "1e-09 to 1e+09"},
        {"weightTooSmall", nurbs(R"("weights": [1, 1, 1, 1e-10])"), "/curves/0/weights/3",
         "is 1e-10", "1e-09 to 1e+09"},
        {"weightTooLarge", nurbs(R"("weights": [1.1e9, 1, 1, 1])"), "/curves/0/weights/0",
         "is 1.1e+09", "1e-09 to 1e+09"},
        {"weightNull", nurbs(R"("weights": [1, null, 1, 1])"), "/curves/0/weights/1", "is null",
         "a number"},
        {"weightsOfABSpline", bSpline(R"("weights": [1, 1, 1, 1])"), "/curves/0/weights",
         "the family b-spline takes no weights", "leave"},
    };
}

std::vector<Refused> badLocal() {
    const auto local = [](const std::string& keys, const std::string& family) {
        return bSpline(R"("local": )" + keys, family);
    };
    return {
        {"localArray", local("[]", "beta"), "/curves/0/local", "is an array", "an object"},
        {"localUnknown", local(R"({"slack": [1, 1, 1, 1]})", "beta"), "/curves/0/local/slack",
         "the family beta has no \"slack\" at each control point", "use bias, tension"},
        {"localNumber", local(R"({"bias": 1})", "beta"), "/curves/0/local/bias", "is a number",
         "an array"},
        {"localEmpty", local(R"({"bias": []})", "beta"), "/curves/0/local/bias", "is empty",
         "numbers"},
        {"tooFewLocal", local(R"({"tension": [1, 1, 1]})", "beta"), "/curves/0/local/tension",
         "has 3 values for 4 points", "one value for each point"},
        {"localOutOfRange", local(R"({"bias": [1, 2, 0, 1]})", "beta"), "/curves/0/local/bias/2",
         "is 0", "0.001 to 1000"},
        {"localOutOfRangeToo", local(R"({"continuity": [0, 1.5, 0, 0]})", "kochanek-bartels"),
         "/curves/0/local/continuity/1", "is 1.5", "-1 to 1"},
        {"localText", local(R"({"tension": [0, 0, "0", 0]})", "cardinal"),
         "/curves/0/local/tension/2", "is a string", "a number"},
        {"localDegree", local(R"({"degree": [3, 3, 3, 3]})", "b-spline"), "/curves/0/local",
         "the family b-spline takes no local", "leave"},
        {"localTwice", local(R"({"bias": [1, 1, 1, 1], "bias": [1, 1, 1, 1]})", "beta"),
         "/curves/0/local/bias", "stands twice", "once"},
    };
}

INSTANTIATE_TEST_SUITE_P(Knots, Refuses, testing::ValuesIn(badKnots()), titleOf);
INSTANTIATE_TEST_SUITE_P(Weights, Refuses, testing::ValuesIn(badWeights()), titleOf);
INSTANTIATE_TEST_SUITE_P(Local, Refuses, testing::ValuesIn(badLocal()), titleOf);
INSTANTIATE_TEST_SUITE_P(NoJson, Refuses, testing::ValuesIn(noJson()), titleOf);
INSTANTIATE_TEST_SUITE_P(Tree, Refuses, testing::ValuesIn(badTree()), titleOf);
INSTANTIATE_TEST_SUITE_P(Head, Refuses, testing::ValuesIn(badHead()), titleOf);
INSTANTIATE_TEST_SUITE_P(OfCurve, Refuses, testing::ValuesIn(badCurve()), titleOf);
INSTANTIATE_TEST_SUITE_P(Tables, Refuses, testing::ValuesIn(badTables()), titleOf);

TEST(ReadDocument, refusesMoreThanSixtyFourMegabytes) {
    const auto document = readDocument(withCurves("") + std::string(largestFile, ' '));
    ASSERT_FALSE(document);
    EXPECT_NE(document.refusal().message().find("64 MB"), std::string::npos)
        << document.refusal().message();
}

TEST(ReadDocument, refusesMoreThanAMillionPoints) {
    const auto document = readDocument(linear("[[0,0]" + repeated(",[1,1]", 1'000'000) + "]"));
    ASSERT_FALSE(document);
    EXPECT_EQ(document.refusal().place, "/curves/0/points");
    EXPECT_NE(document.refusal().message().find("at most 1000000"), std::string::npos)
        << document.refusal().message();
}

TEST(ReadDocument, survivesEveryPrefixOfADocument) {
    const std::string whole = curveWith(R"("name": "\u00e4", "closed": true)");
    for (std::size_t length = 0; length < whole.size(); ++length) {
        EXPECT_FALSE(readDocument(whole.substr(0, length))) << whole.substr(0, length);
    }
}

TEST(ReadDocument, survivesDamage) {
    std::mt19937 random(20250101);
    const std::string whole = curveWith(R"("ends": "open", "parameters": {"tension": 0.25})");
    const std::string bytes = "\0\"{}[],:0-.e\\ \xff" + std::string("tfn");
    for (int i = 0; i < 20'000; ++i) {
        std::string damaged = whole;
        for (int k = 0; k < 3; ++k) {
            damaged[random() % damaged.size()] = bytes[random() % bytes.size()];
        }
        const auto document = readDocument(damaged);
        if (document) {
            EXPECT_TRUE(readDocument(writeDocument(*document))) << damaged;
        } else {
            EXPECT_FALSE(document.refusal().message().empty()) << damaged;
        }
    }
}

TEST(ReadDocument, takesHostileNestingWithoutRecursion) {
    EXPECT_FALSE(readDocument(std::string(10'000'000, '[')));
    EXPECT_FALSE(readDocument(repeated("{\"a\":", 1'000'000)));
}

} // namespace
} // namespace splineloft
