#include "ui/canvas/wording.h"
#include "ui/lettering.h"
#include "ui/panels/panels.h"
#include "ui/widgets.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace splineloft::ui {
namespace {

// Design pixels.
constexpr double headHeight = 40;
constexpr double footHeight = 26;
constexpr double weightsWidth = 190;
constexpr double segmentsWidth = 210;
constexpr double gap = 44;
constexpr double leastForWeights = 560;
constexpr double margin = 14;
constexpr double between = 14; // the parts of the transport
constexpr double playWidth = 86;
constexpr double pacesWidth = 126;
constexpr double fieldWidth = 52;

/// A number that was typed in, or the old one where it was none.
double clampedTo(double typed, double least, double most, double old) {
    return std::isfinite(typed) ? std::clamp(typed, least, most) : old;
}

/// What of the transport there is room for; playing itself always has it.
struct TransportParts {
    bool paces = false, words = false, duration = false, beads = false;
};

TransportParts partsThatFit(const View& view, const Stage& stage) {
    const auto width = [&](const char* words) {
        return ImGui::CalcTextSize(words).x / stage.scale + 8;
    };
    double room = stage.rect.width / stage.scale - 2 * margin - playWidth;
    const auto take = [&room](double wanted) {
        room -= wanted;
        return room >= 0;
    };
    TransportParts parts;
    parts.paces = take(between + pacesWidth);
    parts.duration = take(between + width("in") + fieldWidth + width("s"));
    parts.beads = take(between + width("beads") + 28 + (view.layers.beads ? fieldWidth + 8 : 0));
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
    explain("Seconds from start to end");
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

/// Play and pause, pace, duration, beads.
void drawTransport(View& view, const Stage& stage) {
    const auto parts = partsThatFit(view, stage);
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
}

/// Each control's share at the cursor, and their sum.
void drawWeights(const Study& study, const View& view, const Stage& stage, const ScreenRect& rect) {
    auto& list = *ImGui::GetWindowDrawList();
    const auto& s = stage.theme.surfaces;
    const double line = 21 * stage.scale;
    double y = rect.top;
    const auto row = [&](const std::string& name, double weight, Colour colour) {
        const auto value = fixed(weight, 4);
        drawMath(list, {rect.left + 18 * stage.scale, y}, colour, name, Face::regular);
        drawMath(list, {rect.right() - mathWidth(value, Face::regular), y}, colour, value,
                 Face::regular);
        y += line;
    };
    drawMath(list, {rect.left, y}, s.quiet, "weights at u = " + fixed(view.cursor.u, 3),
             Face::small);
    y += line;
    const Blend basis = study.blends()->basis(view.cursor);
    const auto n = study.curve().points.size();
    const auto room = static_cast<std::size_t>(std::max((rect.bottom() - y) / line - 1, 0.0));
    std::size_t shown = 0;
    for (const auto& [control, weight] : basis.shares()) {
        if (++shown > room) {
            break;
        }
        const Colour dot = colourOf(
            stage.theme, {Role::control, static_cast<int>(control < n ? control : control - n)});
        list.AddCircleFilled(
            {stage.px(6) + static_cast<float>(rect.left), static_cast<float>(y + 9 * stage.scale)},
            stage.px(4.5), packed(dot));
        row(control < n ? pointName(control) : "T_" + std::to_string(control - n), weight, s.text);
    }
    if (shown <= room) {
        const auto middle = static_cast<float>(y);
        list.AddLine({static_cast<float>(rect.left), middle},
                     {static_cast<float>(rect.right()), middle}, packed(s.line));
        y += 3 * stage.scale;
        row(study.family().usesTangents ? "sum of P" : "sum", basis.sumBelow(n), s.text);
    } else {
        row("… " + std::to_string(basis.shares().size()) + " in all, sum", basis.sumBelow(n),
            s.quiet);
    }
}

/// An area that moves the cursor while the button is held on it; returns the value under it.
std::optional<double> slidOver(const char* id, const PlotFrame& plot) {
    ImGui::SetCursorScreenPos(
        {static_cast<float>(plot.frame.left), static_cast<float>(plot.frame.top)});
    ImGui::InvisibleButton(
        id, {static_cast<float>(plot.frame.width), static_cast<float>(plot.frame.height)});
    if (ImGui::IsItemHovered()) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    }
    return ImGui::IsItemActive() ? std::optional(plot.across(ImGui::GetIO().MousePos.x))
                                 : std::nullopt;
}

/// Where the strip is narrow the values give way to the graphs.
bool hasWeights(const Stage& stage) {
    return stage.rect.width >= leastForWeights * stage.scale;
}

ScreenRect weightsFrame(const Stage& stage) {
    const auto& r = stage.rect;
    return {r.right() - weightsWidth * stage.scale, r.top + headHeight * stage.scale,
            (weightsWidth - 18) * stage.scale, r.height - (headHeight + 4) * stage.scale};
}

StripFrames framesIn(const Stage& stage) {
    const auto& r = stage.rect;
    const double top = r.top + headHeight * stage.scale;
    const double height = r.bottom() - footHeight * stage.scale - top;
    const double right = r.right() - (hasWeights(stage) ? weightsWidth + 24 : 14) * stage.scale;
    const double segments = std::min(segmentsWidth * stage.scale, 0.3 * (right - r.left));
    const double left = r.left + gap * stage.scale;
    const double middle = right - segments - gap * stage.scale;
    return {{left, top, std::max(middle - left, 20 * stage.scale), height},
            {right - segments, top, std::max(segments - 16 * stage.scale, 1.0), height}};
}

} // namespace

std::optional<StripFrames> drawStrip(const Session& session, View& view, const Stage& stage) {
    if (stage.rect.height < (headHeight + footHeight + 40) * stage.scale) {
        return std::nullopt;
    }
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {stage.px(margin), stage.px(7)});
    beginPanel("strip", stage,
               ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollbar |
                   ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PopStyleVar();
    const Study* study = session.active();
    std::optional<StripFrames> frames;
    if (study == nullptr || study->pieces().empty()) {
        const auto few = study == nullptr
                             ? "No curve yet."
                             : "The curve begins with " +
                                   std::to_string(fewestPoints(study->curve())) + " points.";
        ImGui::TextDisabled("%s", few.c_str());
    } else {
        drawTransport(view, stage);
        if (study->blends() == nullptr) {
            ImGui::TextDisabled("Too many points to show every basis function.");
        } else {
            frames = framesIn(stage);
            const auto& knots = study->pieces().knots();
            if (const auto t = slidOver("whole", wholeRangeFrame(*study, frames->whole))) {
                view.cursor = knots.locate(*t);
                view.playing = false;
            }
            if (const auto u = slidOver("segments", segmentFrame(*study, frames->segments))) {
                view.cursor.u = *u;
                view.playing = false;
            }
            if (hasWeights(stage)) {
                drawWeights(*study, view, stage, weightsFrame(stage));
            }
        }
    }
    ImGui::End();
    return frames;
}

} // namespace splineloft::ui
