// How curves look and how hands work on them, as it stands in a document's extras.
#include "core/formats/handling_json.h"

#include "core/document/edits.h"
#include "core/document/handle_modes.h"
#include "core/formats/document_json.h"

#include <gtest/gtest.h>

namespace splineloft {
namespace {

/// A cardinal curve and a Bézier spline with anchors 0, 3 and 6.
Document plain() {
    Document document;
    Curve cardinal;
    cardinal.points = {{0, 0}, {1, 2}, {3, 1}};
    completeParameters(cardinal);
    Curve bezier;
    bezier.family = "bezier-spline";
    bezier.ends = Ends::none;
    bezier.points = {{0, 0}, {1, 2}, {3, 4}, {4, 4}, {5, 4}, {8, 1}, {9, 0}};
    document.curves = {std::make_shared<Curve>(cardinal), std::make_shared<Curve>(bezier),
                       std::make_shared<Curve>(cardinal)};
    return document;
}

Document handled() {
    Document document = plain();
    document.curves[0].look = {.visible = false, .locked = true, .colour = 3};
    document.curves[1].handleModes = {{3, HandleMode::corner}, {6, HandleMode::automatic}};
    return document;
}

Document readBack(const std::string& text) {
    auto document = readDocument(text);
    EXPECT_TRUE(document) << document.refusal().message() << '\n' << text;
    return document ? *document : Document();
}

TEST(Handling, isLeftOutWhereAllIsAsUsual) {
    EXPECT_EQ(handlingAsJson(plain()), "");
    EXPECT_EQ(writeDocument(plain()).find("splineloft\": {"), std::string::npos);
    EXPECT_EQ(readBack(writeDocument(plain())), plain());
}

TEST(Handling, standsInTheExtras) {
    const auto text = writeDocument(handled());
    EXPECT_NE(text.find(R"(
  "extras": {
    "splineloft": {
      "curves": [
        {
          "visible": false,
          "locked": true,
          "colour": 3
        },
        {
          "handles": {
            "3": "corner",
            "6": "automatic"
          }
        }
      ]
    }
  }
)"),
              std::string::npos)
        << text;
}

TEST(Handling, readsBackToTheSameBytesBesideWhatOthersKeep) {
    const char* const others = R"({
  "a": [
    {
      "splineloft": 1.50
    }
  ],
  "z": {}
})";
    for (const std::string extras : {"{}", others}) {
        Document document = handled();
        document.extras = extras;
        const auto text = writeDocument(document);
        const Document read = readBack(text);
        EXPECT_EQ(read, document);
        EXPECT_EQ(read.extras, extras) << "without our own";
        EXPECT_EQ(writeDocument(read), text);
    }
}

TEST(Handling, mayStandBetweenWhatOthersKeep) {
    Document document = readBack(
        R"({"format": "splineloft", "version": 1, "curves": [{"family": "linear", "points": []}],
            "extras": {"a": 1, "splineloft": {"curves": [{"colour": 7}]}, "b": {"c": [2]}}})");
    EXPECT_EQ(document.curves[0].look.colour, 7);
    EXPECT_EQ(document.extras, "{\n  \"a\": 1,\n  \"b\": {\n    \"c\": [2]\n  }\n}");
    document = readBack(writeDocument(document));
    EXPECT_EQ(document.curves[0].look.colour, 7);
}

TEST(Handling, isNoPartOfExtrasInMemory) {
    Document document = handled();
    document.extras = R"({"splineloft": {}})";
    EXPECT_THROW(writeDocument(document), std::invalid_argument);
}

struct Malformed {
    std::string own, place, what, remedy;
};

TEST(Handling, isRefusedWithItsPlaceWhereItIsMalformed) {
    const std::string start =
        R"({"format": "splineloft", "version": 1, "curves": [{"family": "bezier-spline",)"
        R"("points": [[0, 0], [1, 1], [2, 1], [3, 0]]}, {"points": [[1, 2]], "family": "linear"}],)"
        R"("extras": {"splineloft": )";
    for (const auto& [own, place, what, remedy] : std::vector<Malformed>{
             {"3", "", "is a number", "an object"},
             {R"({"camera": 1})", "/camera", "is no key", "curves"},
             {R"({"curves": {}})", "/curves", "is an object", "an array"},
             {R"({"curves": [{}, {}, {}]})", "/curves/2", "more than there are curves",
              "at most 2"},
             {R"({"curves": [{"visible": 1}]})", "/curves/0/visible", "is a number",
              "true or false"},
             {R"({"curves": [{"locked": null}]})", "/curves/0/locked", "is null", "true or false"},
             {R"({"curves": [{"colour": 8}]})", "/curves/0/colour", "is 8", "0 to 7"},
             {R"({"curves": [{"colour": 1.5}]})", "/curves/0/colour", "is 1.5", "whole number"},
             {R"({"curves": [{"colour": "red"}]})", "/curves/0/colour", "is a string", "a number"},
             {R"({"curves": [{"color": 1}]})", "/curves/0/color", "is no key", "colour"},
             {R"({"curves": [{"handles": []}]})", "/curves/0/handles", "is an array", "an object"},
             {R"({"curves": [{"handles": {"3": "round"}}]})", "/curves/0/handles/3", "\"round\"",
              "automatic"},
             {R"({"curves": [{"handles": {"4": "corner"}}]})", "/curves/0/handles/4",
              "is no anchor", "0, 3, 6"},
             {R"({"curves": [{"handles": {"6": "corner"}}]})", "/curves/0/handles/6",
              "is no anchor", "0, 3, 6"},
             {R"({"curves": [{"handles": {"03": "corner"}}]})", "/curves/0/handles/03",
              "is no anchor", "0, 3, 6"},
             {R"({"curves": [{}, {"handles": {"0": "corner"}}]})", "/curves/1/handles/0",
              "is no anchor", "Bézier spline"},
             {R"({"curves": [], "curves": []})", "/curves", "stands twice", "once"}}) {
        const auto document = readDocument(start + own + "}}");
        ASSERT_FALSE(document) << own;
        const auto& refusal = document.refusal();
        EXPECT_EQ(refusal.place, "/extras/splineloft" + place) << refusal.message();
        EXPECT_NE(refusal.what.find(what), std::string::npos) << refusal.message();
        EXPECT_NE(refusal.remedy.find(remedy), std::string::npos) << refusal.message();
    }
}

} // namespace
} // namespace splineloft
