// Every text can be read: at every size and scale, with panels and before an audience, nothing is
// cut off and nothing lies on anything else.
#include "driver.h"
#include "hand.h"
#include "letters.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <cmath>

namespace splineloft::ui {
namespace {

class Legibility : public testing::TestWithParam<Screen> {
  protected:
    void SetUp() override {
        if (testFonts().regular.empty() || IMGUI_VERSION_NUM >= 19200) {
            GTEST_SKIP() << "without DejaVu Sans, or with a Dear ImGui whose letters are elsewhere";
        }
    }

    void expectAllToBeRead(const std::string& what) {
        driver.frames(4);
        const auto letters = drawnLetters();
        EXPECT_GT(letters.size(), 40U) << what << ": letters are found at all";
        for (const auto& fault : illegible(letters)) {
            ADD_FAILURE() << what << ": " << fault;
        }
    }

    Driver driver{documentOf({curveOf("cardinal")}), GetParam()};
};

/// One curve for each arrangement of the inspector: few and many parameters, weights, parameters
/// and knots of one's own, more coordinates, long names.
std::vector<Document> documents() {
    Curve weighted = curveOf("nurbs");
    weighted.weights = {1, 2, 0.333333333, 1, 1, 5, 1};
    Curve local = curveOf("beta");
    local.local["tension"].assign(local.points.size(), 2.5);
    local.local["bias"].assign(local.points.size(), 1.25);
    Curve named = curveOf("kochanek-bartels");
    named.name = "a name that is a good deal longer than any panel is wide, as names may be";
    Curve large = curveOf("catmull-rom");
    large.points.set(2, {-123456.789012345, 98765432.123456});
    return {documentOf({curveOf("bezier-spline")}),
            documentOf({weighted}),
            documentOf({local}),
            documentOf({named, curveOf("hermite")}),
            documentOf({curveOf("natural", 3)}),
            documentOf({large})};
}

TEST_P(Legibility, ofAllPanels) {
    for (const auto& document : documents()) {
        driver.session.opened(document, "a-file-of-some-name.json");
        driver.session.view.layers.beads = true;
        expectAllToBeRead(document.curves.front()->family);
    }
}

TEST_P(Legibility, ofPlots) {
    Curve large = curveOf("catmull-rom");
    large.points.set(2, {-123456.789012345, 98765432.123456});
    for (const auto& document : {documentOf({curveOf("natural", 3)}), documentOf({large})}) {
        driver.session.opened(document, "");
        for (const auto plot : {Plot::speed, Plot::acceleration, Plot::curvature}) {
            for (const bool present : {false, true}) {
                driver.session.view.plot = plot;
                driver.session.view.pace = Even::parameter;
                driver.session.present(present);
                expectAllToBeRead(std::string(plotNames[static_cast<std::size_t>(plot)]) +
                                  (present ? " before an audience" : ""));
            }
        }
    }
}

TEST_P(Legibility, beforeAnAudience) {
    driver.session.present(true);
    for (const auto& document : documents()) {
        driver.session.opened(document, "");
        expectAllToBeRead(document.curves.front()->family);
    }
}

TEST_P(Legibility, ofNoticesHoweverLong) {
    driver.session.complain("Set alpha is not possible: /curves/0/points has coincident control "
                            "points; right would be: points that are apart, or alpha = 0, or "
                            "another family");
    expectAllToBeRead("a complaint");
    driver.session.present(true);
    expectAllToBeRead("a complaint before an audience");
}

TEST_P(Legibility, ofWhatStandsInFront) {
    driver.session.dialog = KeyList{};
    expectAllToBeRead("list of keys");
    driver.session.dialog = Palette{};
    expectAllToBeRead("palette");
    driver.session.dialog = UnsavedQuestion{StartNew{}};
    expectAllToBeRead("question");
    driver.session.dismiss();
    driver.frames(2);
    driver.press(driver.atPoint(2), Button::right);
    driver.release(Button::right);
    expectAllToBeRead("menu of a point");
}

TEST_P(Legibility, withPanelsOfAnySize) {
    for (const double part : {0.0, 1.0}) {
        const Screen screen = scaled(driver.screen, driver.session.view);
        const auto across = inspectorRange(screen);
        const auto along = stripRange(screen);
        driver.session.view.inspector = std::lerp(across.least, across.most, part);
        driver.session.view.strip = std::lerp(along.least, along.most, part);
        expectAllToBeRead(part > 0 ? "large" : "small");
    }
}

INSTANTIATE_TEST_SUITE_P(Sizes, Legibility,
                         testing::Values(Screen{800, 600, 1}, Screen{800, 600, 1.5},
                                         Screen{800, 600, 2}, Screen{1024, 768, 1},
                                         Screen{1280, 800, 1}, Screen{1280, 800, 1.5},
                                         Screen{1280, 800, 2}, Screen{1920, 1080, 1},
                                         Screen{1920, 1080, 1.5}, Screen{1920, 1080, 2},
                                         Screen{2560, 1440, 1}, Screen{2560, 1440, 1.5},
                                         Screen{2560, 1440, 2}),
                         [](const auto& tested) {
                             const Screen& s = tested.param;
                             return std::to_string(s.width) + "x" + std::to_string(s.height) +
                                    "at" + std::to_string(std::lround(100 * s.scale));
                         });

} // namespace
} // namespace splineloft::ui
