#include "ui/widgets.h"

#include "ui/canvas/wording.h"
#include "ui/imgui_compat.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>

namespace splineloft::ui {
namespace {

// How near to the neutral value the knob is drawn to it: part of the track.
constexpr double magnet = 0.012;

std::optional<double> parsed(const char* text) {
    while (*text == ' ' || *text == '+') {
        ++text;
    }
    const auto length = std::strlen(text);
    double value = 0;
    const auto [end, error] = std::from_chars(text, text + length, value);
    const bool whole = std::string_view(end).find_first_not_of(' ') == std::string_view::npos;
    return error == std::errc() && whole && std::isfinite(value) ? std::optional(value)
                                                                 : std::nullopt;
}

/// Few digits, as a hand can set them: a thousandth of the range, three digits of a ratio.
double tidied(const Parameter& parameter, double value) {
    if (parameter.scale == Scale::whole) {
        return std::round(value);
    }
    const double size = parameter.scale == Scale::ratio
                            ? std::abs(value)
                            : (parameter.sliderMost - parameter.sliderLeast) / 2;
    const double steps = std::pow(10.0, 3 - std::ceil(std::log10(size)));
    return std::round(value * steps) / steps;
}

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
    list.AddCircleFilled({x(knob), y}, stage.px(lively ? 8.5 : 7.5), packed(s.text), 24);
}

} // namespace

double trackPosition(const Parameter& parameter, double value) {
    const double least = parameter.sliderLeast;
    const double most = parameter.sliderMost;
    return parameter.scale == Scale::ratio ? std::log(value / least) / std::log(most / least)
                                           : (value - least) / (most - least);
}

double valueOnTrack(const Parameter& parameter, double position) {
    const double at = std::clamp(position, 0.0, 1.0);
    if (std::abs(at - trackPosition(parameter, parameter.neutral)) < magnet) {
        return parameter.neutral;
    }
    const double least = parameter.sliderLeast;
    const double most = parameter.sliderMost;
    const double value = parameter.scale == Scale::ratio ? least * std::pow(most / least, at)
                                                         : least + (most - least) * at;
    return std::clamp(tidied(parameter, value), least, most);
}

std::optional<double> numberField(const char* id, double value, double width) {
    // What was typed so far: Dear ImGui forgets it when a click goes to a widget drawn earlier.
    static std::array<char, 64> typed{};
    std::array<char, 64> text{};
    const auto digits = exact(value);
    std::copy_n(digits.begin(), std::min(digits.size(), text.size() - 1), text.begin());
    ImGui::SetNextItemWidth(static_cast<float>(width));
    ImGui::InputText(id, text.data(), text.size(),
                     ImGuiInputTextFlags_CharsScientific | ImGuiInputTextFlags_AutoSelectAll);
    if (ImGui::IsItemActive()) {
        typed = text;
    }
    if (!ImGui::IsItemDeactivatedAfterEdit() ||
        ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) {
        return std::nullopt;
    }
    const auto entered =
        parsed(std::strcmp(text.data(), digits.c_str()) != 0 ? text.data() : typed.data());
    return entered != value ? entered : std::nullopt;
}

std::optional<Turned> parameterSlider(const Parameter& parameter, double value,
                                      const Stage& stage) {
    std::optional<Turned> turned;
    ImGui::PushID(parameter.key.data());
    const std::string label(parameter.label);
    const std::string symbol(parameter.symbol);
    const float width = ImGui::GetContentRegionAvail().x;
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
    ImGui::InvisibleButton("track", size);
    const auto under = [&] {
        return valueOnTrack(parameter, (ImGui::GetIO().MousePos.x - from.x) / size.x);
    };
    auto& memory = *ImGui::GetStateStorage();
    const ImGuiID over = ImGui::GetID("over"); // the drag has ended before the button was released
    if (ImGui::IsItemActivated()) {
        memory.SetBool(over, false);
    }
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0)) {
        memory.SetBool(over, true);
        turned = Turned{parameter.neutral, Phase::commit};
    } else if (ImGui::IsItemActive() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) {
        memory.SetBool(over, true);
        turned = Turned{value, Phase::cancel};
    } else if (ImGui::IsItemActive() && !memory.GetBool(over)) {
        turned = Turned{under(), Phase::preview};
    } else if (ImGui::IsItemDeactivated() && !memory.GetBool(over)) {
        turned = Turned{under(), Phase::commit};
    }
    drawTrack(parameter, turned ? turned->value : value, from, size, stage,
              ImGui::IsItemHovered() || ImGui::IsItemActive());
    explain("Double-click for the neutral value, " + significant(parameter.neutral, 4));
    quietText(std::string(parameter.meaning), stage);
    ImGui::PopID();
    return turned;
}

std::optional<int> choiceOf(const char* id, std::span<const std::string_view> names, int chosen,
                            const Stage& stage, double width) {
    std::optional<int> clicked;
    ImGui::PushID(id);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {stage.px(3), stage.px(7)});
    const auto count = static_cast<double>(names.size());
    const auto each = static_cast<float>((width - 3 * stage.scale * (count - 1)) / count);
    for (int i = 0; i < static_cast<int>(names.size()); ++i) {
        const bool pressed = i == chosen;
        ImGui::PushStyleColor(ImGuiCol_Button, packed(pressed ? stage.theme.surfaces.accentSoft
                                                              : stage.theme.surfaces.field));
        const std::string name(names[static_cast<std::size_t>(i)]);
        if (ImGui::Button(name.c_str(), {each, 0}) && !pressed) {
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

void chip(const std::string& text, bool holds, const Stage& stage) {
    ImGui::PushFont(font(Face::small));
    const ImVec2 words = ImGui::CalcTextSize(text.c_str());
    const ImVec2 size{words.x + stage.px(18), words.y + stage.px(9)};
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    if (ImGui::GetItemRectMax().x + stage.px(6) + size.x < right) {
        ImGui::SameLine(0, stage.px(6));
    }
    const ImVec2 at = ImGui::GetCursorScreenPos();
    auto& list = *ImGui::GetWindowDrawList();
    const auto& s = stage.theme.surfaces;
    const auto colour = packed(holds ? s.text : s.quiet);
    const ImVec2 end{at.x + size.x, at.y + size.y};
    list.AddRectFilled(at, end, packed(holds ? s.raised : s.panel), size.y / 2);
    list.AddRect(at, end, packed(s.line), size.y / 2);
    const ImVec2 words0{at.x + stage.px(9), at.y + stage.px(4.5)};
    list.AddText(words0, colour, text.c_str());
    if (!holds) {
        const float y = words0.y + words.y * 0.55F;
        list.AddLine({words0.x, y}, {words0.x + words.x, y}, colour, stage.px(1.2));
    }
    ImGui::Dummy(size);
    ImGui::PopFont();
}

void quietText(const std::string& text, const Stage& stage) {
    ImGui::PushFont(font(Face::small));
    ImGui::PushStyleColor(ImGuiCol_Text, packed(stage.theme.surfaces.quiet));
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

void explain(const std::string& text) {
    if (ImGui::IsItemHovered() && !ImGui::IsItemActive()) {
        ImGui::SetTooltip("%s", text.c_str());
    }
}

} // namespace splineloft::ui
