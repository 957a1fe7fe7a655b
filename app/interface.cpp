#include "app/interface.h"

namespace splineloft::app {

Interface::Interface(const ui::Screen& expected) : scale_(expected.scale) {
    ui::startInterface();
    loading_ = std::async(std::launch::async, [expected] {
        auto fonts = findFonts();
        ui::loadFonts(fonts, expected);
        return fonts;
    });
}

Interface::~Interface() {
    if (loading_.valid()) {
        loading_.wait();
    }
    ui::stopInterface();
}

bool Interface::fit(const ui::Screen& screen) {
    const bool first = loading_.valid();
    if (first) {
        fonts_ = loading_.get();
    }
    if (screen.scale == scale_) {
        return first;
    }
    scale_ = screen.scale;
    ui::loadFonts(fonts_, screen);
    return true;
}

} // namespace splineloft::app
