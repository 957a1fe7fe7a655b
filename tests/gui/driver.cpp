#include "driver.h"

#include "ui/canvas/hints.h"
#include "ui/canvas/viewport.h"

#include <gtest/gtest.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace splineloft::ui {
namespace {

Modifiers with(Modifiers held, Key modifier, bool down) {
    switch (modifier) {
    case Key::leftShift: held.shift = down; break;
    case Key::leftControl: held.control = down; break;
    case Key::leftAlt: held.alt = down; break;
    default: break;
    }
    return held;
}

/// The window of that name, or one that is drawn and has it in its name.
ImGuiWindow* drawnWindow(const std::string& name) {
    if (ImGuiWindow* window = ImGui::FindWindowByName(name.c_str())) {
        return window;
    }
    for (ImGuiWindow* window : GImGui->Windows) {
        if (window->WasActive && std::string(window->Name).find(name) != std::string::npos) {
            return window;
        }
    }
    return nullptr;
}

ImGuiID idOf(const Widget& widget, ImGuiID window) {
    ImGuiID id = window;
    for (const auto& step : widget.path) {
        if (const auto* number = std::get_if<int>(&step)) {
            id = ImHashData(number, sizeof *number, id);
        } else {
            id = ImHashStr(std::get<std::string>(step).c_str(), 0, id);
        }
    }
    return id;
}

ScreenPoint middleOf(const ScreenRect& rect) {
    return {rect.left + rect.width / 2, rect.top + rect.height / 2};
}

Widget tableField(int kind, std::size_t index, int coordinate) {
    return {"inspector", {"points", kind, static_cast<int>(index), coordinate, "##value"}};
}

} // namespace

Fonts testFonts() {
    for (const std::string folder :
         {"/usr/share/fonts/truetype/dejavu/", "/usr/share/fonts/dejavu-sans-fonts/",
          "/usr/share/fonts/TTF/", "/usr/share/fonts/dejavu/"}) {
        if (std::filesystem::exists(folder + "DejaVuSans.ttf")) {
            return {folder + "DejaVuSans.ttf", folder + "DejaVuSans-Bold.ttf"};
        }
    }
    return {};
}

Widget slider(std::string key) {
    return {"inspector", {std::move(key), "track"}};
}
Widget sliderField(std::string key) {
    return {"inspector", {std::move(key), "##value"}};
}
Widget pointField(std::size_t index, int coordinate) {
    return tableField(0, index, coordinate);
}
Widget tangentField(std::size_t index, int coordinate) {
    return tableField(1, index, coordinate);
}
Widget pointRow(std::size_t index) {
    return {"inspector", {"points", 0, static_cast<int>(index), "##row"}};
}
Widget inInspector(std::string label) {
    return {"inspector", {std::move(label)}};
}
Widget inDialog(std::string label) {
    return {"###dialog", {std::move(label)}};
}

Driver::Driver(Document document, Screen window) : session(std::move(document)), screen(window) {
    startInterface();
    frames(2);
}

Driver::~Driver() {
    stopInterface();
}

void Driver::frames(int count, double seconds) {
    for (int i = 0; i < count; ++i) {
        const Screen now = scaled(screen, session.view);
        if (now.scale != fontScale_) {
            fontScale_ = now.scale;
            loadFonts(testFonts(), now);
        }
        result = runFrame(session, screen, queue.takeFrame(), seconds);
    }
}

void Driver::settle() {
    do {
        frames(1);
    } while (!queue.empty());
    frames(1);
}

void Driver::send(InputEvent event) {
    queue.push(std::move(event));
    settle();
}

void Driver::move(ScreenPoint to) {
    send(PointerMoved{to.x, to.y});
}

void Driver::press(ScreenPoint at, Button button) {
    move(at);
    send(PointerButton{button, true, held_});
}

void Driver::release(Button button) {
    send(PointerButton{button, false, held_});
}

void Driver::click(ScreenPoint at) {
    frames(1, 1); // no double click with the one before
    press(at);
    release();
}

void Driver::doubleClick(ScreenPoint at) {
    click(at);
    press(at);
    release();
}

void Driver::drag(ScreenPoint from, ScreenPoint to) {
    frames(1, 1);
    press(from);
    for (const double part : {0.3, 0.8, 1.0}) {
        move({std::lerp(from.x, to.x, part), std::lerp(from.y, to.y, part)});
    }
    release();
}

void Driver::hold(Key modifier) {
    held_ = with(held_, modifier, true);
    send(KeyChanged{modifier, true, false, held_});
}

void Driver::letGo(Key modifier) {
    held_ = with(held_, modifier, false);
    send(KeyChanged{modifier, false, false, held_});
}

void Driver::key(Key key, Modifiers held) {
    queue.push(KeyChanged{key, true, false, held});
    queue.push(KeyChanged{key, false, false, held});
    settle();
    queue.push(KeyChanged{Key::rightSuper, false, false, held_}); // the modifiers are up again
    settle();
}

void Driver::type(const std::string& ascii) {
    for (const char sign : ascii) {
        const auto upper = static_cast<Key>(std::toupper(static_cast<unsigned char>(sign)));
        queue.push(KeyChanged{upper, true, false, held_});
        queue.push(TextTyped{static_cast<char32_t>(sign)});
        queue.push(KeyChanged{upper, false, false, held_});
    }
    settle();
}

std::optional<ScreenRect> Driver::rectOf(const Widget& widget) {
    ImGuiWindow* window = drawnWindow(widget.window);
    if (window == nullptr || !window->WasActive) {
        return std::nullopt;
    }
    auto& g = *GImGui;
    const auto before = std::tuple(g.NavId, g.NavWindow, g.NavLayer);
    std::tie(g.NavId, g.NavWindow) = std::tuple(idOf(widget, window->ID), window);
    g.NavIdIsAlive = false;
    frames(1);
    const bool alive = g.NavIdIsAlive;
    const ImRect rect = ImGui::WindowRectRelToAbs(window, window->NavRectRel[g.NavLayer]);
    std::tie(g.NavId, g.NavWindow, g.NavLayer) = before;
    if (!alive) {
        return std::nullopt;
    }
    return ScreenRect{rect.Min.x, rect.Min.y, rect.GetWidth(), rect.GetHeight()};
}

std::optional<ScreenRect> Driver::find(const Widget& widget) {
    auto rect = rectOf(widget);
    ImGuiWindow* window = drawnWindow(widget.window);
    if (window != nullptr && window->ScrollMax.y > 0 && widget.window == "inspector") {
        // Rows far below are not even laid out: look through the whole length.
        const float step = window->InnerRect.GetHeight() / 2;
        for (float y = 0; !rect && y < window->ScrollMax.y + step; y += step) {
            ImGui::SetScrollY(window, std::min(y, window->ScrollMax.y));
            frames(2);
            rect = rectOf(widget);
        }
        if (rect &&
            (rect->top < window->InnerRect.Min.y || rect->bottom() > window->InnerRect.Max.y)) {
            const auto middle = static_cast<float>(middleOf(*rect).y);
            ImGui::SetScrollY(window, window->Scroll.y + middle - window->InnerRect.GetCenter().y);
            frames(2);
            rect = rectOf(widget);
        }
    }
    return rect;
}

ScreenPoint Driver::middle(const Widget& widget) {
    const auto rect = find(widget);
    if (!rect) {
        std::string words = widget.window;
        for (const auto& step : widget.path) {
            const auto* number = std::get_if<int>(&step);
            words += " / " + (number ? std::to_string(*number) : std::get<std::string>(step));
        }
        ADD_FAILURE() << "there is no widget " << words;
        return {-1, -1};
    }
    return middleOf(*rect);
}

void Driver::enter(const Widget& field, const std::string& text, Key with) {
    click(field);
    type(text);
    key(with);
}

void Driver::takeFromMenu(int menu, int entry) {
    // The n-th item that the pointer meets on its way along the bar, then down the menu.
    const auto walk = [this](ScreenPoint at, double dx, double dy, int count) {
        unsigned last = 0;
        for (int seen = -1; at.x < screen.width && at.y < screen.height; at.x += dx, at.y += dy) {
            move(at);
            if (const unsigned now = hoveredItem(); now != 0 && now != last) {
                last = now;
                if (++seen == count) {
                    return at;
                }
            }
        }
        ADD_FAILURE() << "the menu has no entry " << count;
        return at;
    };
    const ScreenPoint title = walk({2, 16 * screen.scale}, 3, 0, menu);
    click(title);
    const ScreenPoint item = walk({title.x + 20, title.y + 22 * screen.scale}, 0, 3, entry);
    click(item);
}

Widget Driver::option(std::string label) const {
    return {"##Combo_", {std::move(label)}};
}

unsigned Driver::hoveredItem() const {
    return GImGui->HoveredIdPreviousFrame;
}

ScreenPoint Driver::at(PlanePoint place) const {
    return Viewport{session.view.camera, session.canvas}.toScreen(place);
}

ScreenPoint Driver::atPoint(std::size_t index) const {
    return at(controlPlaces(curve(), session.view.axes)[index]);
}

int Driver::steps() const {
    History past = session.history;
    int count = 0;
    for (; past.canUndo(); past.undo()) {
        ++count;
    }
    return count;
}

std::string Driver::hint() const {
    return hintFor(session.gesture, session.view, session.document());
}

std::string Driver::faults() const {
    const auto& view = session.view;
    const auto finite = [](auto... values) { return (std::isfinite(values) && ...); };
    if (!finite(view.camera.centre.x, view.camera.centre.y, view.camera.pixelsPerUnit,
                view.cursor.u, view.duration, view.strip)) {
        return "the view has a number that is not finite";
    }
    for (const auto& picture : result.pictures) {
        for (const auto& v : picture.ribbons) {
            if (!finite(v.x, v.y, v.along, v.halfWidth)) {
                return "a ribbon has a number that is not finite";
            }
        }
        for (const auto& s : picture.signs) {
            if (!finite(s.x, s.y, s.radius, s.angle)) {
                return "a sign has a number that is not finite";
            }
        }
    }
    if (const auto problem = problemOf(session.document())) {
        return "the document: " + problem->place + " " + problem->what;
    }
    const Study* study = session.active();
    if (study != nullptr && !study->pieces().empty() &&
        view.cursor.segment >= study->pieces().size()) {
        return "u is on a piece that the curve does not have";
    }
    for (const auto& id : view.selection) {
        if (id.curve >= session.document().curves.size()) {
            return "a curve is selected that is not there";
        }
        const Curve& curve = *session.document().curves[id.curve];
        if (id.index >= (id.part == Part::point ? curve.points : curve.tangents).size()) {
            return "a point is selected that is not there";
        }
    }
    return "";
}

} // namespace splineloft::ui
