#include "ui/panels/key_list.h"

#include "ui/commands.h"
#include "ui/panels/menus.h"
#include "ui/widgets.h"

#include <imgui.h>

#include <algorithm>

namespace splineloft::ui {
namespace {

// Design pixels.
constexpr double columnWidth = 380;
constexpr double keysWidth = 128; // of the keys within a column
constexpr double columnGap = 24;
constexpr double rowGap = 4;
constexpr double leftFree = 90; // around the list
constexpr int mostColumns = 4;

/// What is pressed or done, and what comes of it.
struct Line {
    std::string hand, deed;
};

struct Group {
    std::string title;
    std::vector<Line> lines;
};

Group mouseGroup() {
    return {
        "Mouse",
        {{"Click", "select a point"},
         {"Shift+click", "add it to the selection or take it away"},
         {"Alt+click", "select the point beneath it"},
         {"Drag a point", "move the selection: Shift keeps the axis or 45°, Ctrl snaps"},
         {"Drag on nothing", "select the points in a box"},
         {"Drag the curve", "slide u"},
         {"Double-click", "on a point: type in its numbers; on the curve: insert a point there "
                          "(also Ctrl+click)"},
         {"Click with the pen", "add a point at the end: Shift keeps to 45°, Ctrl snaps; drag to "
                                "pull out handles"},
         {"Right click", "what can be done there; in mid-drag: restore"},
         {"Wheel", "zoom at the pointer"},
         {"Middle-drag", "move the view (also with Space held down)"},
         {"Double-click", "on a slider or an edge of a panel: its usual value"}}};
}

std::string keysOf(const Session& session, const Command& command) {
    std::string keys;
    for (const auto& shortcut : shortcutsOf(session, command)) {
        keys += (keys.empty() ? "" : ", ") + nameOf(shortcut);
    }
    return keys;
}

/// The commands of a menu that have keys, by the names that they have before anything was done;
/// those of no menu under a title of their own.
Group groupOf(const std::string& menu, const Session& session) {
    static const Session untouched;
    Group group{menu.empty() ? "Further keys" : menu, {}};
    for (const auto& command : commands()) {
        if (auto keys = keysOf(session, command); command.menu == menu && !keys.empty()) {
            group.lines.push_back({std::move(keys), command.name(untouched)});
        }
    }
    return group;
}

std::vector<Group> allGroups(const Session& session) {
    std::vector<Group> groups = {mouseGroup()};
    for (const char* menu : menuTitles) {
        groups.push_back(groupOf(menu, session));
    }
    groups.push_back(groupOf("", session));
    std::erase_if(groups, [](const Group& group) { return group.lines.empty(); });
    return groups;
}

/// A list being laid out, or measured.
class KeyPage {
  public:
    KeyPage(std::vector<Group> groups, const Stage& window)
        : groups_(std::move(groups)), window_(window) {
        ImGui::PushFont(font(Face::small));
        for (auto& group : groups_) {
            for (auto& line : group.lines) {
                line.hand = brokenAtSpaces(line.hand, window.px(keysWidth - 12));
                line.deed = brokenAtSpaces(line.deed, window.px(columnWidth - keysWidth));
            }
        }
        ImGui::PopFont();
    }

    /// Height of the whole list in so many columns: groups follow one another, and begin a new
    /// column where the one before is full.
    float height(int columns) const {
        float total = 0;
        float highest = 0;
        for (const auto& group : groups_) {
            total += heightOf(group);
            highest = std::max(highest, heightOf(group));
        }
        // The least height at which the groups do not need more columns than there are.
        float limit = std::max(highest, total / static_cast<float>(columns));
        while (columnsAt(limit) > columns) {
            limit += lineHeight();
        }
        return limit;
    }

    void draw(float limit) const {
        const ImVec2 start = ImGui::GetCursorPos();
        float x = start.x;
        float y = start.y;
        for (const auto& group : groups_) {
            if (y > start.y && y - start.y + heightOf(group) > limit + 0.5F) {
                x += window_.px(columnWidth + columnGap);
                y = start.y;
            }
            draw(group, x, y);
            y += heightOf(group);
        }
        ImGui::SetCursorPos(start);
        ImGui::Dummy({x - start.x + window_.px(columnWidth), limit});
    }

  private:
    static float lineHeight() { return font(Face::small)->FontSize; }

    float heightOf(const Line& line) const {
        const auto rows =
            1 + std::max(std::ranges::count(line.hand, '\n'), std::ranges::count(line.deed, '\n'));
        return static_cast<float>(rows) * lineHeight() + window_.px(rowGap);
    }

    float heightOf(const Group& group) const {
        float height = titleHeight() + window_.px(12);
        for (const auto& line : group.lines) {
            height += heightOf(line);
        }
        return height;
    }

    float titleHeight() const { return font(Face::bold)->FontSize + window_.px(6); }

    int columnsAt(float limit) const {
        int columns = 1;
        float y = 0;
        for (const auto& group : groups_) {
            if (y > 0 && y + heightOf(group) > limit + 0.5F) {
                ++columns;
                y = 0;
            }
            y += heightOf(group);
        }
        return columns;
    }

    void draw(const Group& group, float x, float y) const {
        ImGui::SetCursorPos({x, y});
        ImGui::PushFont(font(Face::bold));
        ImGui::TextUnformatted(group.title.c_str());
        ImGui::PopFont();
        y += titleHeight();
        ImGui::PushFont(font(Face::small));
        for (const auto& line : group.lines) {
            ImGui::SetCursorPos({x, y});
            ImGui::TextUnformatted(line.hand.c_str());
            ImGui::SetCursorPos({x + window_.px(keysWidth), y});
            ImGui::TextDisabled("%s", line.deed.c_str());
            y += heightOf(line);
        }
        ImGui::PopFont();
    }

    std::vector<Group> groups_;
    const Stage& window_;
};

} // namespace

bool drawKeyList(const Session& session, const Stage& window) {
    const double room = window.rect.width / window.scale - leftFree;
    const int columns = std::clamp(static_cast<int>((room + columnGap) / (columnWidth + columnGap)),
                                   1, mostColumns);
    const KeyPage list(allGroups(session), window);
    const float limit = list.height(columns);
    const float most = static_cast<float>(window.rect.height) - window.px(150);
    const double width = columns * (columnWidth + columnGap) - columnGap;
    const float bar = limit > most ? ImGui::GetStyle().ScrollbarSize + window.px(4) : 0;
    if (ImGui::BeginChild("keys", {window.px(width) + bar, std::min(limit, most)})) {
        list.draw(limit);
    }
    ImGui::EndChild();
    return ImGui::Button("Close", {window.px(128), 0});
}

} // namespace splineloft::ui
