#include "ui/stage.h"

#include "ui/frame.h"
#include "ui/imgui_compat.h"

#include <algorithm>
#include <cmath>

namespace splineloft::ui {
namespace {

// Design pixels.
constexpr double menuHeight = 32;
constexpr double statusHeight = 28;
constexpr double toolsWidth = 46;
constexpr double leastInspector = 260;
constexpr double mostInspector = 560;
constexpr double leastStrip = 130;
constexpr double leastCanvas = 160;

/// Where there is less room than this, everything gets smaller instead.
struct DesignSize {
    double width, height;
};
constexpr DesignSize leastWorkplace{640, 400};
constexpr DesignSize leastStage{480, 300}; // before an audience: the canvas and little else

constexpr double audienceScale = 1.6;

// The scale goes down in these steps, so that a window that is being made smaller does not load
// the fonts anew at every pixel.
constexpr double scaleStep = 0.125;

constexpr double regularSize = 15;
constexpr double smallSize = 12.5;

ImVec4 floating(Colour c) {
    return {static_cast<float>(c.red) / 255, static_cast<float>(c.green) / 255,
            static_cast<float>(c.blue) / 255, static_cast<float>(c.alpha) / 255};
}

} // namespace

double SizeRange::limited(double size) const {
    return std::min(std::max(size, least), most);
}

SizeRange inspectorRange(const Screen& screen) {
    return {leastInspector, std::min(mostInspector, screen.width / screen.scale / 2)};
}

SizeRange stripRange(const Screen& screen) {
    const double others = menuHeight + statusHeight + leastCanvas;
    return {leastStrip, std::max(screen.height / screen.scale - others, 0.0)};
}

Screen scaled(const Screen& screen, const View& view) {
    const DesignSize least = view.presenting ? leastStage : leastWorkplace;
    const double room = std::min(screen.width / least.width, screen.height / least.height);
    const double most = std::max(std::floor(room / scaleStep) * scaleStep, 0.5);
    const double wanted =
        screen.scale * view.interfaceScale * (view.presenting ? audienceScale : 1);
    return {screen.width, screen.height, std::min(wanted, most)};
}

Layout layOut(const Screen& screen, const View& view) {
    Layout layout;
    const double width = screen.width;
    const double scale = screen.scale;
    const bool panels = !view.presenting;
    const double top = panels ? menuHeight * scale : 0;
    const double left = panels ? toolsWidth * scale : 0;
    const double beside = panels ? inspectorRange(screen).limited(view.inspector) * scale : 0;
    const bool strip = view.layers.basis || (panels && view.log);
    const double below = strip ? stripRange(screen).limited(view.strip) * scale : 0;
    // However small the window, the canvas keeps a pixel.
    const double bottom = std::max(screen.height - statusHeight * scale, top + 1);
    const double right = std::max(width - beside, left + 1);
    const double plots = std::min(below, bottom - top - 1);
    layout.menu = {0, 0, width, top};
    layout.tools = {0, top, left, bottom - top - plots};
    layout.canvas = {left, top, right - left, bottom - top - plots};
    layout.strip = {0, bottom - plots, right, plots};
    layout.inspector = {right, top, width - right, bottom - top};
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
    style.DisabledAlpha = 0.75F; // still to be read
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
    drawGlyphs(atlas);
}

} // namespace splineloft::ui
