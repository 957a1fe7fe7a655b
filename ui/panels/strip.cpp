#include "ui/panels/panels.h"
#include "ui/panels/strip_parts.h"

#include <imgui.h>

#include <algorithm>

namespace splineloft::ui {
namespace {

// Design pixels.
constexpr double headHeight = 40;
constexpr double captionHeight = 18;
constexpr double footHeight = 26;
constexpr double numbersWidth = 190;
constexpr double segmentsWidth = 210;
constexpr double gap = 44;
constexpr double leastForNumbers = 560;
constexpr double stripMargin = 14;

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
bool hasNumbers(const Stage& stage) {
    return stage.rect.width >= leastForNumbers * stage.scale;
}

ScreenRect numbersFrame(const Stage& stage) {
    const auto& r = stage.rect;
    return {r.right() - numbersWidth * stage.scale, r.top + headHeight * stage.scale,
            (numbersWidth - 18) * stage.scale, r.height - (headHeight + 4) * stage.scale};
}

/// Left of the numbers, between the controls above and the numbers of the axis below.
ScreenRect plotsFrame(const Stage& stage) {
    const auto& r = stage.rect;
    const double top = r.top + headHeight * stage.scale;
    const double right = r.right() - (hasNumbers(stage) ? numbersWidth + 24 : 14) * stage.scale;
    const double left = r.left + gap * stage.scale;
    return {left, top, right - left, r.bottom() - footHeight * stage.scale - top};
}

/// A motion is plotted over the whole width, under a line of words.
ScreenRect motionFrame(const Stage& stage) {
    const auto plots = plotsFrame(stage);
    const double words = captionHeight * stage.scale;
    const double end = hasNumbers(stage) ? 0 : 10 * stage.scale; // for the last number's other half
    return {plots.left, plots.top + words, std::max(plots.width - end, 20 * stage.scale),
            plots.height - words};
}

StripFrames basisFrames(const Stage& stage) {
    const auto& r = stage.rect;
    const auto plots = plotsFrame(stage);
    const auto [left, top, width, height] = plots;
    const double right = plots.right();
    const double segments = std::min(segmentsWidth * stage.scale, 0.3 * (right - r.left));
    const double middle = right - segments - gap * stage.scale;
    return {{left, top, std::max(middle - left, 20 * stage.scale), height},
            ScreenRect{right - segments, top, std::max(segments - 16 * stage.scale, 1.0), height}};
}

StripFrames drawBasisPart(const Study& study, View& view, const Stage& stage) {
    const auto frames = basisFrames(stage);
    if (const auto t = slidOver("whole", wholeRangeFrame(study, frames.whole))) {
        view.cursor = study.pieces().knots().locate(*t);
        view.playing = false;
    }
    if (const auto u = slidOver("segments", segmentFrame(study, *frames.segments))) {
        view.cursor.u = *u;
        view.playing = false;
    }
    if (hasNumbers(stage)) {
        drawWeights(study, view, stage, numbersFrame(stage));
    }
    return frames;
}

StripFrames drawMotionPart(const Study& study, View& view, const Stage& stage) {
    const ScreenRect frame = motionFrame(stage);
    if (const auto time = slidOver("whole", motionPlot(study, view, frame)->frame)) {
        view.cursor = study.motion(view.pace, view.duration).spotAt(*time);
        view.playing = false;
    }
    if (hasNumbers(stage)) {
        drawMotionNumbers(*motionPlot(study, view, frame), stage, numbersFrame(stage));
    }
    return {frame, std::nullopt, hasNumbers(stage) ? Caption::unit : Caption::value};
}

} // namespace

std::optional<StripFrames> drawStrip(const Session& session, View& view, const Stage& stage) {
    if (stage.rect.height < (headHeight + footHeight + 40) * stage.scale) {
        return std::nullopt;
    }
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {stage.px(stripMargin), stage.px(7)});
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
        if (view.plot != Plot::basis) {
            frames = drawMotionPart(*study, view, stage);
        } else if (study->blends() != nullptr) {
            frames = drawBasisPart(*study, view, stage);
        } else {
            ImGui::TextDisabled("Too many points to show every basis function.");
        }
    }
    ImGui::End();
    return frames;
}

} // namespace splineloft::ui
