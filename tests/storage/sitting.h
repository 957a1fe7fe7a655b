// A sitting at the editor as the disk sees it, for tests.
#pragma once

#include "app/files.h"
#include "app/storage/keeper.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <unistd.h>

namespace splineloft::app {

/// A sitting whose places are below a folder.
class Sitting {
  public:
    explicit Sitting(const fs::path& folder, const std::vector<std::string>& files = {},
                     AutosavePace pace = {})
        : keeper({folder / "config", folder / "state"}, pace) {
        if (!files.empty()) {
            openTogether(session, {files});
        }
        keeper.begin(session, files);
    }

    /// What the loop does after a frame; false where the program ends.
    bool frame() { return keeper.afterFrame(session, screen); }
    /// Lets frames pass until nothing is under way, or for so many seconds.
    void settle(double most = 3) {
        const auto end = after(Clock::now(), most);
        frame();
        while (Clock::now() < end && keeper.patience() < 1.5) {
            ::usleep(2000);
            keeper.attend(session);
        }
    }
    bool quit() {
        session.requests.emplace_back(ui::Quit{});
        return !frame();
    }
    void request(ui::Request request) {
        session.requests.push_back(std::move(request));
        frame();
    }

    Keeper keeper;
    ui::Session session;
    ui::Screen screen;
};

inline std::string noticeOf(const ui::Session& session) {
    return session.notice ? session.notice->text : "";
}

inline std::vector<std::string> namesOf(const std::vector<ui::RecentFile>& files) {
    std::vector<std::string> found;
    for (const auto& file : files) {
        found.push_back(fs::path(file.path).filename().string());
    }
    return found;
}

#define EXPECT_CONTAINS(text, part)                                                                \
    EXPECT_NE(std::string(text).find(part), std::string::npos) << "in: " << (text)

} // namespace splineloft::app
