// Every kind of document, size of window and theme is drawn without a fault, and every widget has
// an id of its own.
#include "driver.h"
#include "hand.h"

#include "core/spline/catalog.h"
#include "tests/cases.h"

#include <gtest/gtest.h>
#include <imgui_internal.h>

#include <cmath>
#include <map>

namespace splineloft::ui {
namespace {

void showEverything(Session& session) {
    for (const auto& named : namedLayers) {
        session.view.layers.*named.layer = true;
    }
}

TEST(Drawing, everyFamilyWithAnyNumberOfPointsClosedOrNot) {
    Driver driver;
    showEverything(driver.session);
    for (const auto& family : catalog()) {
        for (const bool closed : {false, true}) {
            for (std::size_t count = 0; count <= 7; ++count) {
                Curve curve = curveOf(family.id);
                while (curve.points.size() > count) {
                    curve.points.erase(curve.points.size() - 1);
                    if (family.usesTangents) {
                        curve.tangents.erase(curve.tangents.size() - 1);
                    }
                }
                curve.closed = closed && family.closable;
                const Document document = documentOf({curve});
                if (problemOf(document)) {
                    continue;
                }
                driver.session.opened(document, "");
                showEverything(driver.session);
                driver.frames(2);
                driver.session.view.selection = {};
                driver.session.view.cursor.u = 1;
                driver.frames(1);
                EXPECT_EQ(driver.faults(), "") << family.id << " of " << count << closed;
            }
        }
    }
}

TEST(Drawing, everySpaceAndBothThemesAtSeveralScales) {
    for (const double scale : {1.0, 1.5, 2.0}) {
        Driver driver({}, {static_cast<int>(1280 * scale), static_cast<int>(800 * scale), scale});
        for (const int dimension : {1, 2, 3, 6, 16}) {
            for (const auto* family : {"cardinal", "hermite", "bezier-spline", "natural"}) {
                driver.session.opened(documentOf({curveOf(family, dimension), curveOf("linear")}),
                                      "");
                showEverything(driver.session);
                driver.session.view.theme = dimension % 2 == 0 ? ThemeKind::light : ThemeKind::dark;
                driver.frames(2);
                EXPECT_EQ(driver.faults(), "") << family << dimension;
            }
        }
    }
}

TEST(Drawing, windowsOfAnySize) {
    for (const auto& [width, height] : std::vector<std::pair<int, int>>{{0, 0},
                                                                        {1, 1},
                                                                        {46, 60},
                                                                        {60, 60},
                                                                        {92, 200},
                                                                        {200, 100},
                                                                        {320, 240},
                                                                        {640, 100},
                                                                        {100, 900},
                                                                        {3840, 200},
                                                                        {5120, 2880}}) {
        Driver driver(documentOf({curveOf("cardinal")}), {width, height, 1});
        showEverything(driver.session);
        driver.frames(3);
        EXPECT_EQ(driver.faults(), "") << width << "x" << height;
        driver.key(Key::f1);
        driver.key(Key::escape);
        driver.key(Key::o, withControl);
        driver.key(Key::escape);
        EXPECT_EQ(driver.faults(), "") << width << "x" << height;
    }
}

TEST(Drawing, aLongCurveIsDrawnWithoutItsBasisFunctions) {
    Curve curve = curveOf("cardinal");
    for (int i = 0; i < 20'000; ++i) {
        curve.points.append(Point{std::sin(0.1 * i), std::cos(0.13 * i)});
    }
    Driver driver(documentOf({curve}));
    showEverything(driver.session);
    driver.frames(2);
    EXPECT_EQ(driver.faults(), "");
}

/// All items that the pointer meets in a rectangle, each with where it was met.
std::map<unsigned, std::vector<ScreenPoint>> itemsIn(Driver& driver, const ScreenRect& rect) {
    constexpr double coarser = testing_curves::underSanitizers ? 2 : 1;
    std::map<unsigned, std::vector<ScreenPoint>> met;
    for (double y = rect.top + 2; y < rect.bottom(); y += coarser * 9) {
        for (double x = rect.left + 2; x < rect.right(); x += coarser * 17) {
            driver.queue.push(PointerMoved{x, y});
            driver.frames(1);
            if (GImGui->HoveredId != 0) {
                met[GImGui->HoveredId].push_back({x, y});
            }
        }
    }
    return met;
}

TEST(Drawing, noTwoWidgetsShareAnId) {
    Driver driver(documentOf({curveOf("hermite"), curveOf("linear")}));
    for (const char* name : {"inspector", "strip", "tools"}) {
        const ImGuiWindow* window = ImGui::FindWindowByName(name);
        const ScreenRect rect{window->Pos.x, window->Pos.y, window->Size.x, window->Size.y};
        const auto met = itemsIn(driver, rect);
        EXPECT_GE(met.size(), 5U) << name;
        for (const auto& [id, places] : met) {
            driver.move(places.front());
            GImGui->NavId = id;
            GImGui->NavWindow = ImGui::FindWindowByName(name);
            GImGui->NavIdIsAlive = false;
            driver.frames(1);
            if (!GImGui->NavIdIsAlive) {
                continue; // a scrollbar
            }
            const ImRect own = ImGui::WindowRectRelToAbs(
                GImGui->NavWindow, GImGui->NavWindow->NavRectRel[GImGui->NavLayer]);
            for (const auto& place : places) {
                const ImVec2 p{static_cast<float>(place.x), static_cast<float>(place.y)};
                EXPECT_TRUE(own.Contains(p)) << name << ": the item at " << place.x << ", "
                                             << place.y << " also stands elsewhere";
            }
        }
    }
}

} // namespace
} // namespace splineloft::ui
