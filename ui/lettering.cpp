#include "ui/lettering.h"

#include "ui/canvas/labels.h"

#include <imgui.h>

#include <algorithm>
#include <array>

namespace splineloft::ui {
namespace {

constexpr float lowered = 0.72F; // size of an index, and
constexpr float drop = 0.42F;    // how far its top lies below that of the text

/// Calls `use(part, isIndex)` for the parts of a text between its "_" and spaces.
template <class Use> void eachPart(std::string_view text, Use use) {
    bool index = false;
    while (!text.empty()) {
        const auto end = std::min(text.find(index ? ' ' : '_'), text.size());
        if (end > 0) {
            use(text.substr(0, end), index);
        }
        // The "_" itself is not drawn; the space is.
        text.remove_prefix(std::min(end + (index ? 0 : 1), text.size()));
        index = !index;
    }
}

float widthOf(std::string_view part, float size, ImFont& face) {
    return face.CalcTextSizeA(size, 1e6F, 0, part.data(), part.data() + part.size()).x;
}

ImVec2 vec(double x, double y) {
    return {static_cast<float>(x), static_cast<float>(y)};
}

Face faceOf(const SceneLabel& label) {
    const bool small = label.ink.role == Role::gridNumber || label.ink.role == Role::plotText ||
                       label.ink.role == Role::ladder;
    return small ? Face::small : Face::regular;
}

/// Text with a rim of the background's colour, so that lines under it do not disturb.
void drawWithRim(ImDrawList& list, ScreenPoint at, Colour colour, Colour background,
                 const SceneLabel& label, double rim) {
    constexpr std::array<ScreenPoint, 8> around = {
        {{-1, 0}, {1, 0}, {0, -1}, {0, 1}, {-0.7, -0.7}, {0.7, -0.7}, {-0.7, 0.7}, {0.7, 0.7}}};
    for (const auto& way : around) {
        drawMath(list, {at.x + rim * way.x, at.y + rim * way.y}, background, label.text,
                 faceOf(label));
    }
    drawMath(list, at, colour, label.text, faceOf(label));
}

} // namespace

double mathWidth(std::string_view text, Face face) {
    ImFont& type = *font(face);
    float width = 0;
    eachPart(text, [&](std::string_view part, bool index) {
        width += widthOf(part, index ? lowered * type.FontSize : type.FontSize, type);
    });
    return width;
}

void drawMath(ImDrawList& list, ScreenPoint topLeft, Colour colour, std::string_view text,
              Face face) {
    ImFont& type = *font(face);
    double x = topLeft.x;
    eachPart(text, [&](std::string_view part, bool index) {
        const float size = index ? lowered * type.FontSize : type.FontSize;
        const double y = topLeft.y + (index ? drop * type.FontSize : 0);
        list.AddText(&type, size, vec(x, y), packed(colour), part.data(),
                     part.data() + part.size());
        x += widthOf(part, size, type);
    });
}

void drawLabels(ImDrawList& list, const Scene& scene, const Theme& theme, Colour background,
                double scale) {
    const double padding = 7 * scale;
    const auto measure = [&](const SceneLabel& label) -> TextSize {
        const double extra = label.noted ? padding : 0;
        return {mathWidth(label.text, faceOf(label)) + 2 * extra,
                font(faceOf(label))->FontSize * 1.12 + extra};
    };
    list.PushClipRect(vec(scene.frame.left, scene.frame.top),
                      vec(scene.frame.right(), scene.frame.bottom()));
    for (const auto& [label, rect] : placeLabels(scene, measure, 7 * scale)) {
        const Colour colour = colourOf(theme, label->ink);
        if (label->noted) {
            list.AddRectFilled(vec(rect.left, rect.top), vec(rect.right(), rect.bottom()),
                               packed(theme.surfaces.raised), static_cast<float>(rect.height / 2));
            drawMath(list, {rect.left + padding, rect.top + padding / 2}, colour, label->text,
                     faceOf(*label));
        } else {
            drawWithRim(list, {rect.left, rect.top}, colour, background, *label, 1.5 * scale);
        }
    }
    list.PopClipRect();
}

} // namespace splineloft::ui
