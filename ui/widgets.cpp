#include "ui/widgets.h"

#include "ui/arithmetic.h"
#include "ui/canvas/wording.h"
#include "ui/imgui_compat.h"
#include "ui/track.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

namespace splineloft::ui {
namespace {

/// The number with as many digits as fit into a field of that width.
std::string fitting(double value, float width) {
    const float room = width - 2 * ImGui::GetStyle().FramePadding.x;
    auto digits = exact(value);
    for (int count = 9; count > 2 && ImGui::CalcTextSize(digits.c_str()).x > room; --count) {
        digits = shortened(value, count);
    }
    return withTrueMinus(digits);
}

constexpr double knobRadius = 7.5; // design pixels

/// What a slider remembers of the press that holds it.
class Hold {
  public:
    /// Begins with a press at x: on the knob, which then keeps its place below the pointer and
    /// stays until the pointer moves; or beside it, and it comes there.
    void begin(float x, float knob, float reach) {
        const bool onKnob = std::abs(x - knob) <= reach;
        memory_.SetFloat(offset_, onKnob ? x - knob : 0);
        memory_.SetFloat(start_, x);
        memory_.SetBool(resting_, onKnob);
        memory_.SetBool(over_, false);
    }
    /// The slider has been decided on, before the button is released.
    void end() { memory_.SetBool(over_, true); }
    /// Where the knob is to be, for a pointer at x; nowhere if it is to stay as it is.
    std::optional<float> knobAt(float x) {
        if (x != memory_.GetFloat(start_)) {
            memory_.SetBool(resting_, false);
        }
        const bool moves = !memory_.GetBool(over_) && !memory_.GetBool(resting_);
        return moves ? std::optional(x - memory_.GetFloat(offset_)) : std::nullopt;
    }

  private:
    ImGuiStorage& memory_ = *ImGui::GetStateStorage();
    ImGuiID offset_ = ImGui::GetID("offset");
    ImGuiID start_ = ImGui::GetID("start");
    ImGuiID resting_ = ImGui::GetID("resting");
    ImGuiID over_ = ImGui::GetID("over");
};

void drawTrack(const Parameter& parameter, double value, ImVec2 from, ImVec2 size,
               const Stage& stage, bool lively) {
    auto& list = *ImGui::GetWindowDrawList();
    const auto& s = stage.theme.surfaces;
    const float y = from.y + size.y / 2;
    const auto x = [&](double position) { return from.x + static_cast<float>(position) * size.x; };
    const double knob = std::clamp(trackPosition(parameter, value), 0.0, 1.0);
    const double neutral = std::clamp(trackPosition(parameter, parameter.neutral), 0.0, 1.0);
    const float half = stage.px(2.5);
    list.AddRectFilled({from.x, y - half}, {from.x + size.x, y + half},
                       packed(mixed(s.text, s.panel, 0.2)), half);
    list.AddRectFilled({x(std::min(knob, neutral)), y - half},
                       {x(std::max(knob, neutral)), y + half}, packed(s.accent), half);
    list.AddRectFilled({x(neutral) - stage.px(1), y - stage.px(7)},
                       {x(neutral) + stage.px(1), y + stage.px(7)}, packed(s.quiet));
    list.AddCircleFilled({x(knob), y}, stage.px(lively ? knobRadius + 1 : knobRadius),
                         packed(s.text), 24);
}

/// The track of a slider and what a hand does to it.
std::optional<Turned> slide(const Parameter& parameter, double value, ImVec2 from, ImVec2 size,
                            const Stage& stage) {
    ImGui::InvisibleButton("track", size);
    const float pointer = ImGui::GetIO().MousePos.x;
    Hold hold;
    if (ImGui::IsItemActivated()) {
        const auto position = std::clamp(trackPosition(parameter, value), 0.0, 1.0);
        hold.begin(pointer, from.x + static_cast<float>(position) * size.x, stage.px(knobRadius));
    }
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0)) {
        hold.end();
        return Turned{parameter.neutral, Phase::commit};
    }
    if (ImGui::IsItemActive() && ImGui::IsKeyPressed(escapeKey())) {
        hold.end();
        return Turned{value, Phase::cancel};
    }
    if (!ImGui::IsItemActive() && !ImGui::IsItemDeactivated()) {
        return std::nullopt;
    }
    const auto knob = hold.knobAt(pointer);
    if (!knob) {
        return std::nullopt;
    }
    return Turned{valueOnTrack(parameter, (*knob - from.x) / size.x),
                  ImGui::IsItemActive() ? Phase::preview : Phase::commit};
}

} // namespace

std::optional<double> numberField(const char* id, double value, double width) {
    // What was typed so far: Dear ImGui forgets it when a click goes to a widget drawn earlier.
    static std::array<char, 64> typed{};
    const float wide = width < 0 ? ImGui::GetContentRegionAvail().x : static_cast<float>(width);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 opposite{corner.x + wide, corner.y + ImGui::GetFrameHeight()};
    // A field shows as much as it has room for, and every digit as soon as it is entered.
    const bool entered = isActiveWidget(ImGui::GetID(id)) || ImGui::IsKeyDown(tabKey()) ||
                         (ImGui::IsMouseDown(0) && ImGui::IsMouseHoveringRect(corner, opposite));
    const auto digits = entered ? exact(value) : fitting(value, wide);
    std::array<char, 64> text{};
    std::copy_n(digits.begin(), std::min(digits.size(), text.size() - 1), text.begin());
    ImGui::SetNextItemWidth(wide);
    ImGui::InputText(id, text.data(), text.size(), ImGuiInputTextFlags_AutoSelectAll);
    if (ImGui::IsItemActive()) {
        typed = text;
    }
    if (!ImGui::IsItemDeactivatedAfterEdit() || ImGui::IsKeyPressed(escapeKey())) {
        return std::nullopt;
    }
    const bool here = std::strcmp(text.data(), digits.c_str()) != 0;
    const char* now = here ? text.data() : typed.data();
    if (fitting(value, wide) == now) {
        return std::nullopt; // Tab came too soon for every digit: what was shown was not changed
    }
    const double wanted = valueOf(now).value_or(std::numeric_limits<double>::quiet_NaN());
    return wanted != value ? std::optional(wanted) : std::nullopt;
}

Typing textField(const char* id, const std::string& text, float width, bool takeKeyboard) {
    static std::vector<char> typed; // as in numberField
    std::vector<char> buffer(std::max<std::size_t>(256, 2 * text.size() + 1));
    std::ranges::copy(text, buffer.begin());
    if (takeKeyboard) {
        ImGui::SetKeyboardFocusHere();
    }
    ImGui::SetNextItemWidth(width);
    ImGui::InputText(id, buffer.data(), buffer.size(), ImGuiInputTextFlags_AutoSelectAll);
    if (ImGui::IsItemActive()) {
        typed = buffer;
        return {.begun = true, .over = false, .text = std::nullopt};
    }
    if (!ImGui::IsItemDeactivated()) {
        return {};
    }
    const std::string entered = buffer.data() != text ? buffer.data() : typed.data();
    const bool wanted = entered != text && !ImGui::IsKeyPressed(escapeKey());
    return {.begun = true, .over = true, .text = wanted ? std::optional(entered) : std::nullopt};
}

std::optional<Turned> parameterSlider(const Parameter& parameter, double value,
                                      const Stage& stage) {
    std::optional<Turned> turned;
    ImGui::PushID(parameter.key.data());
    const std::string label(parameter.label);
    const std::string symbol(parameter.symbol);
    const float width = std::max(ImGui::GetContentRegionAvail().x, 1.0F);
    const float field = stage.px(92);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(label.c_str());
    ImGui::SameLine();
    ImGui::TextDisabled("%s", symbol.c_str());
    ImGui::SameLine(ImGui::GetCursorStartPos().x + width - field);
    if (const auto entered = numberField("##value", value, field)) {
        turned = Turned{*entered, Phase::commit};
    }

    const ImVec2 from = ImGui::GetCursorScreenPos();
    const ImVec2 size{width, stage.px(20)};
    if (auto slid = slide(parameter, value, from, size, stage)) {
        turned = slid;
    }
    drawTrack(parameter, turned ? turned->value : value, from, size, stage,
              ImGui::IsItemHovered() || ImGui::IsItemActive());
    explain("Double-click for the neutral value, " + significant(parameter.neutral, 4));
    quietText(std::string(parameter.meaning), stage);
    ImGui::PopID();
    return turned;
}

/// Buttons of a width, of which 0 means what each name wants.
static std::optional<int> choice(const char* id, std::span<const std::string_view> names,
                                 int chosen, const Stage& stage, float width) {
    std::optional<int> clicked;
    ImGui::PushID(id);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {stage.px(3), stage.px(7)});
    for (int i = 0; i < static_cast<int>(names.size()); ++i) {
        const bool pressed = i == chosen;
        ImGui::PushStyleColor(ImGuiCol_Button, packed(pressed ? stage.theme.surfaces.accentSoft
                                                              : stage.theme.surfaces.field));
        const std::string name(names[static_cast<std::size_t>(i)]);
        if (ImGui::Button(name.c_str(), {width, 0}) && !pressed) {
            clicked = i;
        }
        ImGui::PopStyleColor();
        if (i + 1 < static_cast<int>(names.size())) {
            ImGui::SameLine();
        }
    }
    ImGui::PopStyleVar();
    ImGui::PopID();
    return clicked;
}

std::optional<int> choiceOf(const char* id, std::span<const std::string_view> names, int chosen,
                            const Stage& stage, double width) {
    const auto count = static_cast<double>(names.size());
    const auto each = static_cast<float>((width - 3 * stage.scale * (count - 1)) / count);
    return choice(id, names, chosen, stage, each);
}

std::optional<int> choiceOf(const char* id, std::span<const std::string_view> names, int chosen,
                            const Stage& stage) {
    return choice(id, names, chosen, stage, 0);
}

bool toggle(const char* label, bool& on, const Stage& stage) {
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {stage.px(2), stage.px(2)});
    const float down = (ImGui::GetTextLineHeight() + stage.px(10) - ImGui::GetFrameHeight()) / 2;
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() + down);
    const bool clicked = ImGui::Checkbox(label, &on);
    ImGui::PopStyleVar();
    return clicked;
}

bool quietButton(const char* label, bool pressed, const Stage& stage) {
    const auto& s = stage.theme.surfaces;
    const float height = ImGui::GetFrameHeight();
    ImGui::PushFont(font(Face::small));
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {stage.px(7), 0});
    ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 0);
    ImGui::PushStyleColor(ImGuiCol_Button, pressed ? packed(s.accentSoft) : 0);
    ImGui::PushStyleColor(ImGuiCol_Text, packed(pressed ? s.text : s.quiet));
    const bool clicked = ImGui::Button(label, {0, height});
    ImGui::PopStyleColor(2);
    ImGui::PopStyleVar(2);
    ImGui::PopFont();
    return clicked;
}

float quietButtonWidth(const std::string& words, const Stage& stage) {
    ImGui::PushFont(font(Face::small));
    const float width = ImGui::CalcTextSize(words.c_str()).x + 2 * stage.px(7);
    ImGui::PopFont();
    return width;
}

void chips(std::span<const Chip> row, const Stage& stage) {
    ImGui::PushFont(font(Face::small));
    auto& list = *ImGui::GetWindowDrawList();
    const auto& s = stage.theme.surfaces;
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float right = start.x + ImGui::GetContentRegionAvail().x;
    ImVec2 at = start;
    float height = 0;
    for (const auto& [text, holds] : row) {
        const ImVec2 words = ImGui::CalcTextSize(text.c_str());
        const ImVec2 size{words.x + stage.px(18), words.y + stage.px(9)};
        if (at.x > start.x && at.x + size.x > right) {
            at = {start.x, at.y + size.y + stage.px(6)};
        }
        const ImVec2 end{at.x + size.x, at.y + size.y};
        const auto colour = packed(holds ? s.text : s.quiet);
        list.AddRectFilled(at, end, packed(holds ? s.raised : s.panel), size.y / 2);
        list.AddRect(at, end, packed(s.line), size.y / 2);
        const ImVec2 first{at.x + stage.px(9), at.y + stage.px(4.5)};
        list.AddText(first, colour, text.c_str());
        if (!holds) {
            const float y = first.y + words.y * 0.55F;
            list.AddLine({first.x, y}, {first.x + words.x, y}, colour, stage.px(1.2));
        }
        height = end.y - start.y;
        at.x = end.x + stage.px(6);
    }
    ImGui::Dummy({right - start.x, height});
    ImGui::PopFont();
}

std::string brokenAtSpaces(const std::string& text, float width) {
    std::string broken;
    std::size_t lineStart = 0;
    for (std::size_t at = 0; at < text.size();) {
        const auto end = std::min(text.find_first_of(" \n", at), text.size());
        const auto word = text.substr(at, end - at);
        const auto line = broken.substr(lineStart) + word;
        if (broken.size() > lineStart && ImGui::CalcTextSize(line.c_str()).x > width) {
            broken.back() = '\n'; // the space before the word
            lineStart = broken.size();
        }
        broken += word;
        if (end < text.size()) {
            broken += text[end];
            lineStart = text[end] == '\n' ? broken.size() : lineStart;
        }
        at = end + 1;
    }
    return broken;
}

/// Whether a letter goes on at this byte of UTF-8.
static bool isWithinLetter(char byte) {
    return (static_cast<unsigned char>(byte) & 0xc0U) == 0x80U;
}

static bool fits(const std::string& text, float width) {
    return ImGui::CalcTextSize(text.c_str()).x <= width;
}

std::string cutToFit(const std::string& text, float width) {
    std::string cut = text;
    constexpr std::string_view between = " · ";
    for (auto end = cut.rfind(between); !fits(cut, width) && end != cut.npos;
         end = cut.rfind(between)) {
        cut.erase(end);
    }
    if (fits(cut, width)) {
        return cut;
    }
    while (!cut.empty() && !fits(cut + "…", width)) {
        while (cut.size() > 1 && isWithinLetter(cut.back())) {
            cut.pop_back();
        }
        cut.pop_back();
    }
    return cut + "…";
}

std::string endThatFits(const std::string& text, float width) {
    if (fits(text, width)) {
        return text;
    }
    std::size_t from = 0;
    while (from < text.size() &&
           (isWithinLetter(text[from]) || !fits("…" + text.substr(from), width))) {
        ++from;
    }
    return "…" + text.substr(from);
}

void quietText(const std::string& text, const Stage& stage) {
    ImGui::PushFont(font(Face::small));
    ImGui::PushStyleColor(ImGuiCol_Text, packed(stage.theme.surfaces.quiet));
    ImGui::TextUnformatted(brokenAtSpaces(text, ImGui::GetContentRegionAvail().x).c_str());
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

void explain(const std::string& text) {
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) && !ImGui::IsItemActive()) {
        ImGui::BeginTooltip();
        ImGui::PushTextWrapPos(32 * ImGui::GetFontSize());
        ImGui::TextUnformatted(text.c_str());
        ImGui::PopTextWrapPos();
        ImGui::EndTooltip();
    }
}

} // namespace splineloft::ui
