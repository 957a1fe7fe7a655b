#include "ui/commands.h"
#include "ui/imgui_compat.h"
#include "ui/panels/browser.h"
#include "ui/panels/panels.h"
#include "ui/widgets.h"

#include <imgui.h>

#include <algorithm>
#include <array>

namespace splineloft::ui {
namespace {

struct Mouse {
    const char* hand;
    const char* deed;
};

constexpr std::array mouse = {
    Mouse{"Click, Shift+click", "select a point; add it to the selection or take it away"},
    Mouse{"Drag a point", "move the selection: Shift keeps the axis, Ctrl snaps"},
    Mouse{"Drag on empty space", "select the points in a box"},
    Mouse{"Drag along the curve", "slide u"},
    Mouse{"Double-click the curve", "insert a point there (also Ctrl+click)"},
    Mouse{"Wheel", "zoom at the pointer"},
    Mouse{"Middle-drag", "move the view"},
    Mouse{"Double-click a slider", "back to its neutral value"},
    Mouse{"Esc or right click in mid-drag", "restore what was there"}};

void question(Session& session, const UnsavedQuestion& asked, const Stage& window) {
    const auto departure = asked.departure;
    ImGui::Text("“%s” has changes that are in no file.", session.fileName().c_str());
    ImGui::TextDisabled("They are lost if you go on without saving.");
    ImGui::Spacing();
    const ImVec2 size{window.px(128), 0};
    if (ImGui::Button("Save", size)) {
        session.save(departure);
        return;
    }
    ImGui::SameLine();
    if (ImGui::Button("Don't save", size)) {
        session.leaveAnyway(departure);
        return;
    }
    ImGui::SameLine();
    if (ImGui::Button("Cancel", size)) {
        session.dismiss();
    }
}

void keyRow(const std::string& keys, const std::string& deed, const Stage& window) {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(keys.c_str());
    ImGui::TableNextColumn();
    ImGui::PushStyleColor(ImGuiCol_Text, packed(window.theme.surfaces.quiet));
    ImGui::TextUnformatted(deed.c_str());
    ImGui::PopStyleColor();
}

void keyList(Session& session, const Stage& window) {
    const double room = window.rect.width / window.scale - 90;
    const bool sideBySide = room >= 1000;
    const float width = window.px(std::min(room, sideBySide ? 1120.0 : 560.0));
    const auto height = static_cast<float>(window.rect.height) - window.px(190);
    if (ImGui::BeginTable("keys", sideBySide ? 4 : 2, ImGuiTableFlags_ScrollY,
                          {width, std::min(height, window.px(560))})) {
        for (int i = 0; i < (sideBySide ? 2 : 1); ++i) {
            ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, window.px(222));
            ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch);
        }
        for (const auto& [hand, deed] : mouse) {
            keyRow(hand, deed, window);
        }
        for (const auto& command : commands()) {
            if (!command.shortcuts.empty()) {
                std::string keys;
                for (const auto& shortcut : command.shortcuts) {
                    keys += (keys.empty() ? "" : ", ") + nameOf(shortcut);
                }
                keyRow(keys, command.name(session), window);
            }
        }
        ImGui::EndTable();
    }
    if (ImGui::Button("Close", {window.px(128), 0})) {
        session.dialog.reset();
    }
}

const char* titleOf(const Dialog& dialog) {
    if (const auto* browser = std::get_if<FileBrowser>(&dialog)) {
        return browser->purpose == FilePurpose::open   ? "Open###dialog"
               : browser->purpose == FilePurpose::save ? "Save as###dialog"
                                                       : "Export samples###dialog";
    }
    return std::holds_alternative<UnsavedQuestion>(dialog) ? "Save the changes?###dialog"
                                                           : "Keys and mouse###dialog";
}

} // namespace

void drawDialog(Session& session, const Stage& window) {
    if (!session.dialog) {
        return;
    }
    const char* title = titleOf(*session.dialog);
    if (!ImGui::IsPopupOpen(title)) {
        ImGui::OpenPopup(title);
    }
    const auto& r = window.rect;
    ImGui::SetNextWindowPos(
        {static_cast<float>(r.left + r.width / 2), static_cast<float>(r.top + r.height / 2)},
        ImGuiCond_Always, {0.5F, 0.5F});
    if (!ImGui::BeginPopupModal(title, nullptr,
                                ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove)) {
        return;
    }
    const bool escaped = ImGui::IsKeyPressed(escapeKey());
    if (auto* browser = std::get_if<FileBrowser>(&*session.dialog)) {
        if (const auto request = drawBrowser(*browser, window)) {
            session.dialog.reset();
            session.requests.push_back(*request);
        } else if (escaped || browser->closed) {
            session.dismiss();
        }
    } else if (escaped) {
        session.dismiss();
    } else if (const auto* asked = std::get_if<UnsavedQuestion>(&*session.dialog)) {
        question(session, *asked, window);
    } else {
        keyList(session, window);
    }
    if (!session.dialog) {
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

} // namespace splineloft::ui
