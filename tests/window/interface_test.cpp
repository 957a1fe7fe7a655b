// The interface as it is drawn, when its scale changes while it runs.
#include "app/interface.h"
#include "app/offscreen.h"

#include <gtest/gtest.h>

namespace splineloft::app {
namespace {

ui::Session sessionToDraw() {
    Curve curve;
    curve.family = "linear";
    curve.ends = Ends::none;
    curve.points = {{0, 0}, {1, 2}, {3, 1}};
    Document document;
    document.curves.push_back(std::make_shared<Curve>(curve));
    return ui::Session(document);
}

Image drawn(Interface& interface, ui::Session& session, const ui::Screen& screen) {
    interface.fit(screen);
    for (int i = 0; i < 3; ++i) {
        ui::runFrame(session, screen, {}, 1.0 / 60);
    }
    const auto frame = ui::runFrame(session, screen, {}, 1.0 / 60);
    return drawOffscreen(interface.renderer(), frame, screen);
}

TEST(Interface, looksTheSameWhateverScaleItHadBefore) {
    const ui::Screen once{1280, 800, 1};
    const ui::Screen twice{1280, 800, 2};
    const OffscreenContext context;
    const auto fresh = [&](const ui::Screen& screen) {
        Interface interface;
        auto session = sessionToDraw();
        return drawn(interface, session, screen);
    };
    const Image expectedOnce = fresh(once);
    const Image expectedTwice = fresh(twice);
    ASSERT_NE(expectedOnce.rgba, expectedTwice.rgba);
    Interface interface;
    for (const bool large : {false, true, false, true}) {
        auto session = sessionToDraw();
        const Image image = drawn(interface, session, large ? twice : once);
        EXPECT_EQ(image.rgba, (large ? expectedTwice : expectedOnce).rgba) << large;
    }
}

} // namespace
} // namespace splineloft::app
