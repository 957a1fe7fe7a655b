#include "ui/stage.h"

#include "ui/frame.h"
#include "ui/imgui_compat.h"

#include <algorithm>

namespace splineloft::ui {
namespace {

// Design pixels.
constexpr double menuHeight = 32;
constexpr double statusHeight = 28;
constexpr double toolsWidth = 46;
constexpr double inspectorWidth = 312;
constexpr double leastCanvas = 160;

constexpr double regularSize = 15;
constexpr double smallSize = 12.5;

ImVec4 floating(Colour c) {
    return {static_cast<float>(c.red) / 255, static_cast<float>(c.green) / 255,
            static_cast<float>(c.blue) / 255, static_cast<float>(c.alpha) / 255};
}

} // namespace

Layout layOut(double width, double height, double scale, double strip) {
    Layout layout;
    const double top = menuHeight * scale;
    const double left = toolsWidth * scale;
    // However small the window, the canvas keeps a pixel.
    const double bottom = std::max(height - statusHeight * scale, top + 1);
    const double right = std::max(width - std::min(inspectorWidth * scale, width / 2), left + 1);
    const double most = std::max(bottom - top - leastCanvas * scale, 0.0);
    const double plots = std::min(strip * scale, most);
    layout.menu = {0, 0, width, top};
    layout.tools = {0, top, left, bottom - top - plots};
    layout.canvas = {left, top, right - left, bottom - top - plots};
    layout.strip = {0, bottom - plots, right, plots};
    layout.inspector = {right, top, std::max(width - right, 1.0), bottom - top};
    layout.status = {0, bottom, width, statusHeight * scale};
    return layout;
}

ImFont* font(Face face) {
    const auto& fonts = ImGui::GetIO().Fonts->Fonts;
    return fonts[std::min(static_cast<int>(face), fonts.Size - 1)];
}

unsigned packed(Colour c) {
    return IM_COL32(c.red, c.green, c.blue, c.alpha);
}

void applyStyle(const Theme& theme, double scale) {
    const auto& s = theme.surfaces;
    ImGuiStyle style;
    style.WindowRounding = 0;
    style.WindowBorderSize = 0;
    style.WindowPadding = {16, 12};
    style.FramePadding = {9, 5};
    style.FrameRounding = 5;
    style.FrameBorderSize = 1;
    style.PopupRounding = 6;
    style.PopupBorderSize = 1;
    style.ItemSpacing = {8, 7};
    style.ScrollbarSize = 10;
    style.ScrollbarRounding = 5;
    style.CellPadding = {4, 2};
    style.ScaleAllSizes(static_cast<float>(scale));
    const auto set = [&style](int index, Colour colour) { style.Colors[index] = floating(colour); };
    set(ImGuiCol_Text, s.text);
    set(ImGuiCol_TextDisabled, s.quiet);
    set(ImGuiCol_WindowBg, s.panel);
    set(ImGuiCol_PopupBg, s.panel);
    set(ImGuiCol_MenuBarBg, s.panel);
    set(ImGuiCol_Border, s.line);
    set(ImGuiCol_FrameBg, s.field);
    set(ImGuiCol_FrameBgHovered, s.raised);
    set(ImGuiCol_FrameBgActive, s.raised);
    set(ImGuiCol_Button, s.field);
    set(ImGuiCol_ButtonHovered, s.raised);
    set(ImGuiCol_ButtonActive, s.accentSoft);
    set(ImGuiCol_Header, s.accentSoft);
    set(ImGuiCol_HeaderHovered, s.raised);
    set(ImGuiCol_HeaderActive, s.accentSoft);
    set(ImGuiCol_CheckMark, s.accent);
    set(ImGuiCol_SliderGrab, s.accent);
    set(ImGuiCol_Separator, s.line);
    set(ImGuiCol_TitleBg, s.raised);
    set(ImGuiCol_TitleBgActive, s.raised);
    set(ImGuiCol_ScrollbarGrab, mixed(s.text, s.panel, 0.3));
    set(ImGuiCol_ScrollbarGrabHovered, mixed(s.text, s.panel, 0.45));
    set(ImGuiCol_ScrollbarGrabActive, mixed(s.text, s.panel, 0.55));
    set(ImGuiCol_TextSelectedBg, mixed(s.accent, s.field, 0.45));
    set(ImGuiCol_NavHighlight, s.accent);
    style.Colors[ImGuiCol_ScrollbarBg] = {0, 0, 0, 0};
    style.Colors[ImGuiCol_ModalWindowDimBg] = {0, 0, 0, 0.45F};
    ImGui::GetStyle() = style;
}

void startInterface() {
    ImGui::CreateContext();
    auto& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    mapKeys(io);
}

void stopInterface() {
    ImGui::DestroyContext();
}

void loadFonts(const Fonts& fonts, const Screen& screen) {
    auto& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    const auto load = [&](const std::string& file, double size) {
        const auto pixels = static_cast<float>(size * screen.scale);
        if (file.empty() ||
            atlas.AddFontFromFileTTF(file.c_str(), pixels, nullptr, glyphRanges()) == nullptr) {
            atlas.AddFontDefault();
        }
    };
    load(fonts.regular, regularSize);
    load(fonts.regular, smallSize);
    load(fonts.bold.empty() ? fonts.regular : fonts.bold, regularSize);
    atlas.Build();
}

} // namespace splineloft::ui
