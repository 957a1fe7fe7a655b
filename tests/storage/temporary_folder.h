// A folder for one test, and a few things to put into it.
#pragma once

#include "core/formats/document_json.h"
#include "ui/session.h"

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include <unistd.h>

namespace splineloft::app {

namespace fs = std::filesystem;

class TemporaryFolder {
  public:
    TemporaryFolder() {
        static std::atomic<int> count = 0;
        path_ = fs::temp_directory_path() / ("splineloft-storage-" + std::to_string(::getpid()) +
                                             "-" + std::to_string(count++));
        fs::create_directories(path_);
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        fs::permissions(path_, fs::perms::owner_all, ignored);
        fs::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const fs::path& path() const { return path_; }
    fs::path operator/(const std::string& name) const { return path_ / name; }

  private:
    fs::path path_;
};

inline std::string contents(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

inline void put(const fs::path& path, std::string_view text) {
    fs::create_directories(path.parent_path());
    std::ofstream(path) << text;
}

/// Names of all that lies in a folder; none where it does not exist.
inline std::set<std::string> names(const fs::path& folder) {
    std::set<std::string> found;
    std::error_code failed;
    for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end; ++entry) {
        found.insert(entry->path().filename().string());
    }
    return found;
}

/// A document with one curve, told from others by where its first point is.
inline Document documentWith(double x) {
    Curve curve;
    curve.family = "linear";
    curve.ends = Ends::none;
    curve.points = {{x, 1}, {2, 3.5}, {4, -1.25}};
    Document document;
    document.curves.push_back(std::make_shared<Curve>(curve));
    return document;
}

/// An edit of the kind that a hand makes.
inline void change(ui::Session& session, double x) {
    session.apply({documentWith(x), ui::Phase::commit, "Change"});
}

} // namespace splineloft::app
