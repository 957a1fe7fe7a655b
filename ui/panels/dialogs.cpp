#include "ui/imgui_compat.h"
#include "ui/panels/browser.h"
#include "ui/panels/key_list.h"
#include "ui/panels/palette.h"
#include "ui/panels/panels.h"
#include "ui/widgets.h"

#include <imgui.h>

namespace splineloft::ui {
namespace {

void question(Session& session, const UnsavedQuestion& asked, const Stage& window) {
    const auto departure = asked.departure;
    const auto name = cutToFit(session.fileName(), window.px(260));
    ImGui::Text("“%s” has changes that are in no file.", name.c_str());
    ImGui::TextDisabled("They are lost if you go on without saving.");
    ImGui::Spacing();
    const ImVec2 size{window.px(128), 0};
    if (ImGui::Button("Save", size)) {
        session.save(departure);
        return;
    }
    if (ImGui::IsWindowAppearing()) {
        ImGui::SetItemDefaultFocus();
        showChosen();
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

const char* titleOf(const Dialog& dialog) {
    if (std::holds_alternative<Palette>(dialog)) {
        return "###palette";
    }
    if (const auto* browser = std::get_if<FileBrowser>(&dialog)) {
        return browser->purpose == FilePurpose::open   ? "Open###dialog"
               : browser->purpose == FilePurpose::save ? "Save as###dialog"
                                                       : "Export samples###dialog";
    }
    return std::holds_alternative<UnsavedQuestion>(dialog) ? "Save the changes?###dialog"
           : std::holds_alternative<RecoveryOffer>(dialog) ? "Unsaved work###dialog"
                                                           : "Keys and mouse###dialog";
}

/// In the middle of the window.
bool beginDialog(const char* title, const Stage& window) {
    const auto& r = window.rect;
    ImGui::SetNextWindowPos(
        {static_cast<float>(r.left + r.width / 2), static_cast<float>(r.top + r.height / 2)},
        ImGuiCond_Always, {0.5F, 0.5F});
    return ImGui::BeginPopupModal(title, nullptr,
                                  ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove);
}

/// At the top, without a title.
bool beginPalette(const char* title, const Stage& window) {
    const auto middle = static_cast<float>(window.rect.left + window.rect.width / 2);
    const auto width = static_cast<float>(paletteWidth(window));
    ImGui::SetNextWindowPos({middle, static_cast<float>(paletteTop(window))}, ImGuiCond_Always,
                            {0.5F, 0});
    ImGui::SetNextWindowSizeConstraints({width, 0}, {width, 1e6F});
    return ImGui::BeginPopupModal(title, nullptr,
                                  ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoTitleBar);
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
    const bool isPalette = std::holds_alternative<Palette>(*session.dialog);
    if (!(isPalette ? beginPalette(title, window) : beginDialog(title, window))) {
        return;
    }
    const bool escaped = ImGui::IsKeyPressed(escapeKey());
    if (auto* browser = std::get_if<FileBrowser>(&*session.dialog)) {
        if (const auto request = drawBrowser(*browser, session.recent, window)) {
            session.dialog.reset();
            session.requests.push_back(*request);
        } else if (escaped || browser->closed) {
            session.dismiss();
        }
    } else if (escaped) {
        session.dismiss();
    } else if (const auto* asked = std::get_if<UnsavedQuestion>(&*session.dialog)) {
        question(session, *asked, window);
    } else if (std::holds_alternative<RecoveryOffer>(*session.dialog)) {
        drawRecoveryOffer(session, window);
    } else if (isPalette) {
        drawPalette(session, window);
    } else if (drawKeyList(session, window)) {
        session.dismiss();
    }
    // What a command from the palette opens is another window.
    if (!session.dialog || isPalette != std::holds_alternative<Palette>(*session.dialog)) {
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

} // namespace splineloft::ui
