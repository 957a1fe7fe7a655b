#include "ui/panels/browser.h"

#include "ui/file_choice.h"
#include "ui/widgets.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <vector>

namespace splineloft::ui {
namespace {

namespace fs = std::filesystem;

struct Entry {
    std::string name;
    bool isFolder = false;
};

bool isShown(const fs::directory_entry& entry, FilePurpose purpose) {
    const auto name = entry.path().filename().string();
    std::error_code failed;
    if (name.empty() || name.front() == '.') {
        return false;
    }
    const auto ending = entry.path().extension();
    return entry.is_directory(failed) || ending == ".json" ||
           (purpose == FilePurpose::exportSamples && ending == ".csv");
}

/// Folders first, then files, each by name. Nothing where the folder cannot be read.
std::vector<Entry> entriesOf(const FileBrowser& browser) {
    std::vector<Entry> entries;
    std::error_code failed;
    for (fs::directory_iterator at(browser.folder, failed), end; !failed && at != end;
         at.increment(failed)) {
        if (isShown(*at, browser.purpose)) {
            std::error_code ignored;
            entries.push_back({at->path().filename().string(), at->is_directory(ignored)});
        }
    }
    std::ranges::sort(entries, [](const Entry& a, const Entry& b) {
        return a.isFolder != b.isFolder ? a.isFolder : a.name < b.name;
    });
    return entries;
}

/// The files of late that are still there, above those of the folder.
std::optional<Request> drawRecent(const FileBrowser& browser, std::span<const RecentFile> recent) {
    constexpr int most = 6; // of them, so that the folder is in sight
    std::optional<Request> request;
    int shown = 0;
    for (const auto& file : recent) {
        if (!file.isThere || shown == most) {
            continue;
        }
        if (ImGui::Selectable(nameWithFolder(file.path).c_str()) && !request) {
            request = OpenFiles{{file.path}, browser};
        }
        ++shown;
    }
    if (shown > 0) {
        ImGui::Separator();
    }
    return request;
}

/// The list; a click names a file or enters a folder, a double click takes the file.
std::optional<Request> drawList(FileBrowser& browser, std::span<const RecentFile> recent,
                                const Stage& window) {
    std::optional<Request> request;
    const auto height =
        std::min(window.px(320), static_cast<float>(window.rect.height) - window.px(280));
    if (ImGui::BeginChild("files", {window.px(560), height}, true)) {
        request = drawRecent(browser, recent);
        if (browser.folder.has_parent_path() && ImGui::Selectable("↑  ..", false)) {
            browser.folder = browser.folder.parent_path();
        }
        for (const auto& entry : entriesOf(browser)) {
            const auto label = (entry.isFolder ? "▸  " : "    ") + entry.name;
            if (ImGui::Selectable(label.c_str(), entry.name == browser.name,
                                  ImGuiSelectableFlags_AllowDoubleClick)) {
                browser.overwriteAsked = false;
                if (entry.isFolder) {
                    browser.folder /= entry.name;
                } else {
                    browser.name = entry.name;
                    request = ImGui::IsMouseDoubleClicked(0) ? accept(browser) : std::nullopt;
                }
            }
        }
    }
    ImGui::EndChild();
    return request;
}

/// What the samples are even in, and how many.
void drawSampleChoice(FileBrowser& browser, const Stage& window) {
    static constexpr std::array<std::string_view, 2> kinds = {"even in length", "even in u"};
    if (const auto chosen =
            choiceOf("even", kinds, browser.even == Even::length ? 0 : 1, window, window.px(260))) {
        browser.even = *chosen == 0 ? Even::length : Even::parameter;
    }
    ImGui::SameLine();
    ImGui::SetNextItemWidth(window.px(130));
    ImGui::InputInt("samples", &browser.count, 0);
    browser.count = std::clamp(browser.count, 2, 1'000'000);
    quietText("The ending .csv or .json decides the format.", window);
}

void drawWarning(const std::string& text, const Stage& window) {
    if (!text.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, packed(window.theme.surfaces.warning));
        ImGui::TextUnformatted(brokenAtSpaces(text, window.px(560)).c_str());
        ImGui::PopStyleColor();
    }
}

} // namespace

std::optional<Request> drawBrowser(FileBrowser& browser, std::span<const RecentFile> recent,
                                   const Stage& window) {
    ImGui::TextDisabled("%s", endThatFits(browser.folder.string(), window.px(560)).c_str());
    const bool opens = browser.purpose == FilePurpose::open;
    auto request = drawList(browser, opens ? recent : std::span<const RecentFile>(), window);
    ImGui::SetNextItemWidth(window.px(560));
    if (browser.takesKeyboard) {
        ImGui::SetKeyboardFocusHere();
        browser.takesKeyboard = false;
    }
    if (ImGui::InputText("##name", &browser.name,
                         ImGuiInputTextFlags_EnterReturnsTrue |
                             ImGuiInputTextFlags_AutoSelectAll)) {
        request = accept(browser);
        browser.takesKeyboard = !request; // for the next Enter, or another name
    }
    if (ImGui::IsItemEdited()) {
        browser.overwriteAsked = false;
        browser.problem.clear();
    }
    if (browser.purpose == FilePurpose::exportSamples) {
        drawSampleChoice(browser, window);
    }
    drawWarning(browser.overwriteAsked
                    ? "“" + chosenPath(browser).filename().string() + "” is there already."
                    : browser.problem,
                window);
    const char* verb = browser.overwriteAsked                 ? "Replace it"
                       : browser.purpose == FilePurpose::open ? "Open"
                       : browser.purpose == FilePurpose::save ? "Save"
                                                              : "Export";
    const ImVec2 size{window.px(128), 0};
    if (ImGui::Button(verb, size)) {
        request = accept(browser);
    }
    ImGui::SameLine();
    browser.closed = ImGui::Button("Cancel", size);
    return request;
}

} // namespace splineloft::ui
