// Above the plots: how the curve is played, and which plot is shown.
#include "ui/panels/strip_parts.h"
#include "ui/widgets.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace splineloft::ui {
namespace {

// Design pixels.
constexpr double margin = 14;
constexpr double between = 14;
constexpr double playWidth = 86;
constexpr double pacesWidth = 126;
constexpr double fieldWidth = 52;
constexpr double plotWidth = 128; // of the list of plots, closed

/// A number that was typed in, or the old one where it was none.
double clampedTo(double typed, double least, double most, double old) {
    return std::isfinite(typed) ? std::clamp(typed, least, most) : old;
}

/// What of the transport there is room for; playing itself and the choice of a plot always have it.
struct TransportParts {
    bool paces = false, words = false, duration = false, beads = false;
    bool plotsInRow = false; ///< side by side; else in a list that opens
};

/// The width of buttons side by side, each as wide as its name wants, design pixels.
double rowOfPlots(const Stage& stage) {
    double width = 3 * (static_cast<double>(plotNames.size()) - 1);
    for (const auto name : plotNames) {
        width += ImGui::CalcTextSize(name.data()).x / stage.scale + 18;
    }
    return width;
}

TransportParts partsThatFit(const View& view, const Stage& stage) {
    const auto width = [&](const char* words) {
        return ImGui::CalcTextSize(words).x / stage.scale + 8;
    };
    double room = stage.rect.width / stage.scale - 2 * margin - playWidth - between - plotWidth;
    const auto take = [&room](double wanted) {
        const bool fits = wanted <= room;
        room -= fits ? wanted : 0;
        return fits;
    };
    TransportParts parts;
    parts.paces = take(between + pacesWidth);
    parts.duration = take(between + width("in") + fieldWidth + width("s"));
    parts.beads = take(between + width("beads") + 28 + (view.layers.beads ? fieldWidth + 8 : 0));
    parts.plotsInRow = take(rowOfPlots(stage) - plotWidth);
    parts.words = take(width("even in"));
    return parts;
}

void drawPaces(View& view, bool words, const Stage& stage) {
    ImGui::SameLine(0, stage.px(between));
    if (words) {
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted("even in");
        ImGui::SameLine();
    }
    static constexpr std::array<std::string_view, 2> paces = {"length", "u"};
    const int pace = view.pace == Even::length ? 0 : 1;
    if (const auto chosen = choiceOf("pace", paces, pace, stage, stage.px(pacesWidth))) {
        view.pace = *chosen == 0 ? Even::length : Even::parameter;
    }
}

void drawDuration(View& view, const Stage& stage) {
    ImGui::SameLine(0, stage.px(between));
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("in");
    ImGui::SameLine();
    if (const auto seconds = numberField("##duration", view.duration, stage.px(fieldWidth))) {
        view.duration = clampedTo(*seconds, 0.1, 600, view.duration);
    }
    explain("Seconds from start to end: 0.1 to 600");
    ImGui::SameLine();
    ImGui::TextUnformatted("s");
}

void drawBeads(View& view, const Stage& stage) {
    ImGui::SameLine(0, stage.px(between));
    const float line = ImGui::GetCursorPosY();
    toggle("beads", view.layers.beads, stage);
    if (view.layers.beads) {
        ImGui::SameLine();
        ImGui::SetCursorPosY(line);
        if (const auto count = numberField("##beads", view.beads, stage.px(fieldWidth))) {
            view.beads = static_cast<int>(clampedTo(*count, 2, 1000, view.beads));
        }
        explain("How many beads: 2 to 1000");
    }
}

/// Which plot the strip shows, at its right end.
void drawPlotChoice(View& view, bool inRow, float line, const Stage& stage) {
    const double width = inRow ? rowOfPlots(stage) : plotWidth;
    ImGui::SameLine(static_cast<float>(stage.rect.width - (margin + width) * stage.scale));
    ImGui::SetCursorPosY(line); // the toggle before it stands lower
    const int shown = static_cast<int>(view.plot);
    if (inRow) {
        if (const auto chosen = choiceOf("plot", plotNames, shown, stage)) {
            view.plot = static_cast<Plot>(*chosen);
        }
        return;
    }
    ImGui::SetNextItemWidth(stage.px(width));
    if (ImGui::BeginCombo("##plot", plotNames.at(static_cast<std::size_t>(shown)).data())) {
        for (int i = 0; i < static_cast<int>(plotNames.size()); ++i) {
            if (ImGui::Selectable(plotNames.at(static_cast<std::size_t>(i)).data(), i == shown)) {
                view.plot = static_cast<Plot>(i);
            }
        }
        ImGui::EndCombo();
    }
}

} // namespace

void drawTransport(View& view, const Stage& stage) {
    const auto parts = partsThatFit(view, stage);
    const float line = ImGui::GetCursorPosY();
    if (ImGui::Button(view.playing ? "❚❚ Pause" : "▶ Play", {stage.px(playWidth), 0})) {
        view.playing = !view.playing;
    }
    explain("Plays u along the curve (Space)");
    if (parts.paces) {
        drawPaces(view, parts.words, stage);
    }
    if (parts.duration) {
        drawDuration(view, stage);
    }
    if (parts.beads) {
        drawBeads(view, stage);
    }
    drawPlotChoice(view, parts.plotsInRow, line, stage);
}

} // namespace splineloft::ui
