// Beside the plots: the numbers at the cursor.
#include "ui/canvas/wording.h"
#include "ui/lettering.h"
#include "ui/panels/strip_parts.h"

#include <imgui.h>

#include <algorithm>

namespace splineloft::ui {
namespace {

constexpr double lineHeight = 21; // design pixels

/// Lines of text from the top of a rectangle down.
class Lines {
  public:
    Lines(const Stage& stage, const ScreenRect& rect)
        : list_(*ImGui::GetWindowDrawList()), stage_(stage), rect_(rect), y_(rect.top) {}

    bool hasRoom() const { return y_ + lineHeight * stage_.scale <= rect_.bottom(); }

    void title(const std::string& words) {
        drawMath(list_, {rect_.left, y_}, stage_.theme.surfaces.quiet, words, Face::small);
        next();
    }

    void value(const std::string& words) {
        drawMath(list_, {rect_.left, y_}, stage_.theme.surfaces.text, words, Face::regular);
        next();
    }

    /// A name at the left, a value at the right.
    void row(const std::string& name, const std::string& value) {
        const auto& s = stage_.theme.surfaces;
        drawMath(list_, {rect_.left, y_}, s.quiet, name, Face::small);
        drawMath(list_, {rect_.right() - mathWidth(value, Face::small), y_}, s.text, value,
                 Face::small);
        next();
    }

    void rule() {
        const auto y = static_cast<float>(y_ + 2 * stage_.scale);
        list_.AddLine({static_cast<float>(rect_.left), y}, {static_cast<float>(rect_.right()), y},
                      packed(stage_.theme.surfaces.line));
        y_ += 7 * stage_.scale;
    }

  private:
    void next() { y_ += lineHeight * stage_.scale; }

    ImDrawList& list_;
    const Stage& stage_;
    const ScreenRect& rect_;
    double y_;
};

/// "1.234 at 2.10 s".
std::string inWords(const MotionPlot& plot, const Extreme& extreme) {
    const auto value = extreme.bounded     ? valueInWords(plot, extreme.value)
                       : extreme.value > 0 ? "∞"
                                           : "−∞";
    return value + " at " + fixed(extreme.time, 2) + " s";
}

bool isConstant(const MotionPlot& plot, const Extremes& extremes) {
    constexpr double alike = 1e-9;
    const double least = extremes.least.value, greatest = extremes.greatest.value;
    return plot.graph.range(plot.quantity).vanishes ||
           greatest - least <= alike * std::max(std::abs(greatest), std::abs(least));
}

} // namespace

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

void drawMotionNumbers(const MotionPlot& plot, const Stage& stage, const ScreenRect& rect) {
    Lines lines(stage, rect);
    lines.title(nameOf(plot.quantity) + " at u = " + fixed(plot.cursor.u, 3));
    lines.value(valueAtCursor(plot));
    const auto& extremes = plot.graph.extremes(plot.quantity);
    if (!extremes || !lines.hasRoom()) {
        return;
    }
    lines.rule();
    if (isConstant(plot, *extremes)) {
        const bool here = valueOf(plot.motion.at(plot.cursor), plot.quantity).has_value();
        lines.title(here ? "the same everywhere" : "the same wherever it is defined");
        return;
    }
    lines.row("most", inWords(plot, extremes->greatest));
    if (lines.hasRoom()) {
        lines.row("least", inWords(plot, extremes->least));
    }
}

} // namespace splineloft::ui
