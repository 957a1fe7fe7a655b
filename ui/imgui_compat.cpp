#include "ui/imgui_compat.h"

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <utility>

namespace splineloft::ui {
namespace {

#if IMGUI_VERSION_NUM >= 18700

constexpr std::array keys = {std::pair{Key::tab, ImGuiKey_Tab},
                             std::pair{Key::left, ImGuiKey_LeftArrow},
                             std::pair{Key::right, ImGuiKey_RightArrow},
                             std::pair{Key::up, ImGuiKey_UpArrow},
                             std::pair{Key::down, ImGuiKey_DownArrow},
                             std::pair{Key::pageUp, ImGuiKey_PageUp},
                             std::pair{Key::pageDown, ImGuiKey_PageDown},
                             std::pair{Key::home, ImGuiKey_Home},
                             std::pair{Key::end, ImGuiKey_End},
                             std::pair{Key::insert, ImGuiKey_Insert},
                             std::pair{Key::del, ImGuiKey_Delete},
                             std::pair{Key::backspace, ImGuiKey_Backspace},
                             std::pair{Key::space, ImGuiKey_Space},
                             std::pair{Key::enter, ImGuiKey_Enter},
                             std::pair{Key::escape, ImGuiKey_Escape},
                             std::pair{Key::keypadEnter, ImGuiKey_KeypadEnter},
                             std::pair{Key::a, ImGuiKey_A},
                             std::pair{Key::c, ImGuiKey_C},
                             std::pair{Key::v, ImGuiKey_V},
                             std::pair{Key::x, ImGuiKey_X},
                             std::pair{Key::y, ImGuiKey_Y},
                             std::pair{Key::z, ImGuiKey_Z}};

void feedKey(ImGuiIO& io, const KeyChanged& change) {
    io.AddKeyEvent(ImGuiMod_Ctrl, change.modifiers.control);
    io.AddKeyEvent(ImGuiMod_Shift, change.modifiers.shift);
    io.AddKeyEvent(ImGuiMod_Alt, change.modifiers.alt);
    for (const auto& [ours, theirs] : keys) {
        if (ours == change.key) {
            io.AddKeyEvent(theirs, change.down);
        }
    }
}

void feedPointer(ImGuiIO& io, double x, double y) {
    io.AddMousePosEvent(static_cast<float>(x), static_cast<float>(y));
}

void feedButton(ImGuiIO& io, int button, bool down) {
    io.AddMouseButtonEvent(button, down);
}

void feedWheel(ImGuiIO& io, double dx, double dy) {
    io.AddMouseWheelEvent(static_cast<float>(dx), static_cast<float>(dy));
}

void feedFocus(ImGuiIO& io, bool focused) {
    io.AddFocusEvent(focused);
}

#else

constexpr std::array keys = {std::pair{ImGuiKey_Tab, Key::tab},
                             std::pair{ImGuiKey_LeftArrow, Key::left},
                             std::pair{ImGuiKey_RightArrow, Key::right},
                             std::pair{ImGuiKey_UpArrow, Key::up},
                             std::pair{ImGuiKey_DownArrow, Key::down},
                             std::pair{ImGuiKey_PageUp, Key::pageUp},
                             std::pair{ImGuiKey_PageDown, Key::pageDown},
                             std::pair{ImGuiKey_Home, Key::home},
                             std::pair{ImGuiKey_End, Key::end},
                             std::pair{ImGuiKey_Insert, Key::insert},
                             std::pair{ImGuiKey_Delete, Key::del},
                             std::pair{ImGuiKey_Backspace, Key::backspace},
                             std::pair{ImGuiKey_Space, Key::space},
                             std::pair{ImGuiKey_Enter, Key::enter},
                             std::pair{ImGuiKey_Escape, Key::escape},
                             std::pair{ImGuiKey_KeyPadEnter, Key::keypadEnter},
                             std::pair{ImGuiKey_A, Key::a},
                             std::pair{ImGuiKey_C, Key::c},
                             std::pair{ImGuiKey_V, Key::v},
                             std::pair{ImGuiKey_X, Key::x},
                             std::pair{ImGuiKey_Y, Key::y},
                             std::pair{ImGuiKey_Z, Key::z}};

void feedKey(ImGuiIO& io, const KeyChanged& change) {
    io.KeyCtrl = change.modifiers.control;
    io.KeyShift = change.modifiers.shift;
    io.KeyAlt = change.modifiers.alt;
    const auto code = static_cast<std::size_t>(change.key);
    if (code < std::size(io.KeysDown)) {
        io.KeysDown[code] = change.down;
    }
}

void feedPointer(ImGuiIO& io, double x, double y) {
    io.MousePos = {static_cast<float>(x), static_cast<float>(y)};
}

void feedButton(ImGuiIO& io, int button, bool down) {
    io.MouseDown[button] = down;
}

void feedWheel(ImGuiIO& io, double dx, double dy) {
    io.MouseWheelH += static_cast<float>(dx);
    io.MouseWheel += static_cast<float>(dy);
}

void feedFocus(ImGuiIO& io, bool focused) {
    if (!focused) {
        std::ranges::fill(io.KeysDown, false);
        io.KeyCtrl = io.KeyShift = io.KeyAlt = false;
    }
}

#endif

} // namespace

void feed(ImGuiIO& io, const InputEvent& event) {
    if (const auto* moved = std::get_if<PointerMoved>(&event)) {
        feedPointer(io, moved->x, moved->y);
    } else if (const auto* button = std::get_if<PointerButton>(&event)) {
        feedButton(io, static_cast<int>(button->button), button->down);
    } else if (const auto* wheel = std::get_if<WheelTurned>(&event)) {
        feedWheel(io, wheel->dx, wheel->dy);
    } else if (const auto* key = std::get_if<KeyChanged>(&event)) {
        feedKey(io, *key);
    } else if (const auto* text = std::get_if<TextTyped>(&event)) {
        io.AddInputCharacter(static_cast<unsigned>(text->character));
    } else if (const auto* focus = std::get_if<FocusChanged>(&event)) {
        feedFocus(io, focus->focused);
    }
}

void mapKeys([[maybe_unused]] ImGuiIO& io) {
#if IMGUI_VERSION_NUM < 18700
    for (const auto& [theirs, ours] : keys) {
        io.KeyMap[theirs] = static_cast<int>(ours);
    }
#endif
}

void followKeys(ImGuiIO& io, bool wanted) {
    if (wanted) {
        io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
#if IMGUI_VERSION_NUM < 18700
        // Enter was for fields alone, and Space for all else.
        if (io.KeysDown[static_cast<std::size_t>(Key::enter)]) {
            io.NavInputs[ImGuiNavInput_Activate] = 1;
        }
#endif
    } else {
        io.ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard;
    }
}

void showChosen() {
#if IMGUI_VERSION_NUM >= 19140
    ImGui::SetNavCursorVisible(true);
#else
    GImGui->NavDisableHighlight = false;
#endif
}

ImGuiKeyCode escapeKey() {
    return ImGui::GetKeyIndex(ImGuiKey_Escape);
}
ImGuiKeyCode tabKey() {
    return ImGui::GetKeyIndex(ImGuiKey_Tab);
}
ImGuiKeyCode enterKey() {
    return ImGui::GetKeyIndex(ImGuiKey_Enter);
}
ImGuiKeyCode upKey() {
    return ImGui::GetKeyIndex(ImGuiKey_UpArrow);
}
ImGuiKeyCode downKey() {
    return ImGui::GetKeyIndex(ImGuiKey_DownArrow);
}

bool isActiveWidget(unsigned id) {
    return ImGui::GetActiveID() == id;
}

bool isPopupOpen() {
    return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
}

void closePopups() {
    if (isPopupOpen()) {
        ImGui::ClosePopupToLevel(0, true);
    }
}

void releaseActiveWidget() {
    ImGui::ClearActiveID();
}

const ImWchar* glyphRanges() {
    // What the interface shows and what names are made of. Each letter costs time at the start.
    static constexpr std::array<ImWchar, 23> ranges = {
        0x0020, 0x017F, // Latin
        0x0370, 0x03FF, // Greek
        0x0400, 0x045F, // Cyrillic
        0x2010, 0x2044, // dashes, quotes, dots, primes
        0x2070, 0x209F, // super- and subscripts
        0x2150, 0x215F, // fractions
        0x2190, 0x2199, // arrows
        0x2200, 0x226B, // mathematical operators
        0x2302, 0x2302, // house
        0x25A0, 0x25FF, // shapes
        0x2700, 0x275A, // pencils, bars
        0};
    return ranges.data();
}

void drawGlyphs([[maybe_unused]] ImFontAtlas& atlas) {
#if IMGUI_VERSION_NUM < 19200
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    atlas.GetTexDataAsRGBA32(&pixels, &width, &height); // which it keeps
#endif
}

} // namespace splineloft::ui
