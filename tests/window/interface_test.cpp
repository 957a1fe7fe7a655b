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

/// The interface with what draws it.
struct Drawn {
    explicit Drawn(const ui::Screen& expected) : interface(expected) {}

    Image of(ui::Session session, const ui::Screen& screen) {
        if (interface.fit(screen)) {
            renderer.uploadFonts();
        }
        for (int i = 0; i < 3; ++i) {
            ui::runFrame(session, screen, {}, 1.0 / 60);
        }
        const auto frame = ui::runFrame(session, screen, {}, 1.0 / 60);
        return drawOffscreen(renderer, frame, screen);
    }

    Interface interface;
    Renderer renderer;
};

TEST(Interface, looksTheSameWhateverScaleItHadBefore) {
    const ui::Screen once{1280, 800, 1};
    const ui::Screen twice{1280, 800, 2};
    const OffscreenContext context;
    const Image expectedOnce = Drawn(once).of(sessionToDraw(), once);
    const Image expectedTwice = Drawn(twice).of(sessionToDraw(), twice);
    ASSERT_NE(expectedOnce.rgba, expectedTwice.rgba);
    EXPECT_EQ(Drawn(twice).of(sessionToDraw(), once).rgba, expectedOnce.rgba) << "not as expected";
    Drawn drawn(once);
    for (const bool large : {false, true, false, true}) {
        const Image image = drawn.of(sessionToDraw(), large ? twice : once);
        EXPECT_EQ(image.rgba, (large ? expectedTwice : expectedOnce).rgba) << large;
    }
}

} // namespace
} // namespace splineloft::app
