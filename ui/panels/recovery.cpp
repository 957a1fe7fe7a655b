// The offer of what an editor that died left unsaved.
#include "ui/file_choice.h"
#include "ui/panels/panels.h"
#include "ui/widgets.h"

#include <imgui.h>

#include <algorithm>

namespace splineloft::ui {
namespace {

constexpr double offerHeight = 92; // design pixels: three lines and a button

std::string counted(std::size_t count, const char* thing) {
    return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

/// The curves, small, on a ground as the canvas has it.
void drawThumbnail(const Thumbnail& thumbnail, const Stage& window) {
    const auto& s = window.theme.surfaces;
    auto& list = *ImGui::GetWindowDrawList();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 size{window.px(thumbnailWidth), window.px(thumbnailHeight)};
    list.AddRectFilled(at, {at.x + size.x, at.y + size.y}, packed(s.canvas), window.px(3));
    list.AddRect(at, {at.x + size.x, at.y + size.y}, packed(s.line), window.px(3));
    const auto colour = packed(colourOf(window.theme, {Role::curve}));
    for (const auto& line : thumbnail) {
        for (const auto& p : line) {
            list.PathLineTo({at.x + window.px(p.x), at.y + window.px(p.y)});
        }
        list.PathStroke(colour, 0, window.px(1.6));
    }
    ImGui::Dummy(size);
}

/// What is known of the work beside its picture.
void drawWords(const UnsavedWork& work, const Stage& window) {
    const auto name =
        work.path.empty() ? "untitled" : std::filesystem::path(work.path).filename().string();
    ImGui::TextUnformatted(name.c_str());
    quietText(work.path.empty() ? "in no file yet" : work.path, window);
    quietText(dateAndTime(work.time) + "  ·  " + counted(work.curves, "curve") + ", " +
                  counted(work.points, "point"),
              window);
}

/// One piece of work; whether the person decided on it.
bool drawOne(Session& session, const UnsavedWork& work, const Stage& window) {
    ImGui::PushID(work.id.c_str());
    drawThumbnail(work.thumbnail, window);
    ImGui::SameLine(0, window.px(14));
    ImGui::BeginGroup();
    drawWords(work, window);
    const bool restores = ImGui::Button("Restore", {window.px(110), 0});
    ImGui::SameLine();
    const bool discards = ImGui::Button("Discard", {window.px(110), 0});
    ImGui::EndGroup();
    ImGui::PopID();
    ImGui::Spacing();
    if (restores) {
        session.leave(RestoreWork{work.id});
    } else if (discards) {
        session.requests.emplace_back(DiscardWork{work.id});
    }
    return restores || discards;
}

} // namespace

void drawRecoveryOffer(Session& session, const Stage& window) {
    ImGui::TextUnformatted("The editor came to an end before this was saved.");
    quietText("Restoring opens it as unsaved changes; files stay as they are until you save.",
              window);
    ImGui::Spacing();
    const float row = window.px(offerHeight) + 2 * ImGui::GetStyle().ItemSpacing.y;
    const float wanted = row * static_cast<float>(session.unsavedWork.size()) + window.px(20);
    const float room = static_cast<float>(window.rect.height) - window.px(260);
    if (ImGui::BeginChild("work", {window.px(600), std::clamp(wanted, row, std::max(row, room))},
                          true)) {
        for (const auto& work : session.unsavedWork) {
            if (drawOne(session, work, window)) {
                break; // the list is about to change
            }
        }
    }
    ImGui::EndChild();
    if (!session.dialog || !std::holds_alternative<RecoveryOffer>(*session.dialog)) {
        return; // something else is asked now
    }
    const bool later = ImGui::Button("Later", {window.px(128), 0});
    if (later || session.unsavedWork.empty()) {
        session.dismiss();
    }
}

} // namespace splineloft::ui
