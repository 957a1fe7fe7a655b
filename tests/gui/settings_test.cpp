// What is remembered from one start to the next, as text.
#include "ui/settings.h"

#include <gtest/gtest.h>

namespace splineloft::ui {
namespace {

/// A session with no setting as it usually is.
Session unusual() {
    Session session;
    session.view.theme = ThemeKind::light;
    session.view.strip = 155.5;
    session.view.duration = 2.25;
    session.view.pace = Even::parameter;
    session.view.beads = 7;
    session.view.plot = Plot::acceleration;
    for (const auto& [name, layer] : namedLayers) {
        session.view.layers.*layer = !(session.view.layers.*layer);
    }
    session.habits = {false, 1000, 700};
    return session;
}

TEST(Settings, areReadBack) {
    const auto text = settingsText(unusual());
    Session other;
    ASSERT_NE(settingsText(other), text);
    const auto done = applySettings(other, text);
    ASSERT_TRUE(done) << done.refusal().message();
    EXPECT_EQ(settingsText(other), text);
    EXPECT_EQ(other.view.layers, unusual().view.layers);
    EXPECT_EQ(other.view.beads, 7);
    EXPECT_EQ(other.view.plot, Plot::acceleration);
    EXPECT_FALSE(other.habits.systemDialogs);
}

TEST(Settings, outliveADocument) {
    auto session = unusual();
    const auto before = settingsText(session);
    session.opened({}, "/there/other.json");
    EXPECT_EQ(settingsText(session), before);
}

TEST(Settings, whatIsMissingOrUnknownStaysAsItIs) {
    auto session = unusual();
    ASSERT_TRUE(applySettings(session, R"({"beads": 9, "hologram": true})"));
    EXPECT_EQ(session.view.beads, 9);
    EXPECT_EQ(session.view.theme, ThemeKind::light);
}

TEST(Settings, numbersAreKeptWithinBounds) {
    Session session;
    ASSERT_TRUE(applySettings(session, R"({"beads": -5, "duration": 1e300, "windowWidth": 1})"));
    EXPECT_GE(session.view.beads, 2);
    EXPECT_LE(session.view.duration, 3600);
    EXPECT_GE(session.habits.windowWidth, 320);
}

TEST(Settings, damagedOnesChangeNothingAndSayWhere) {
    const auto refused = [](const char* text, const char* place) {
        auto session = unusual();
        const auto before = settingsText(session);
        const auto done = applySettings(session, text);
        ASSERT_FALSE(done) << text;
        EXPECT_NE(done.refusal().message().find(place), std::string::npos)
            << done.refusal().message();
        EXPECT_EQ(settingsText(session), before) << text;
    };
    refused("", "1:1");
    refused(R"({"beads": 9)", "1:1");
    refused("[]", "is an array");
    refused(R"({"beads": 9, "theme": "pink"})", "/theme");
    refused(R"({"beads": "nine"})", "/beads");
    refused(R"({"plot": "jerk"})", "basis, speed, acceleration or curvature");
    refused(R"({"beads": 9, "layers": {"comb": 1}})", "/layers/comb");
    refused(R"({"beads": 9, "layers": []})", "/layers");
    refused(R"({"beads": 9, "systemDialogs": "no"})", "/systemDialogs");
}

} // namespace
} // namespace splineloft::ui
