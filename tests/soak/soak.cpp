// Editors killed with SIGKILL at random moments of saving and of autosaving. Whatever the moment:
// the file is an old or a new one, whole to the byte; the next start offers what was last known to
// be kept, or later; and no litter stays.
//
// usage: soak COUNT    kills COUNT editors while they save and COUNT while they autosave
// SPLINELOFT_SEED chooses the moments.
#include "app/storage/autosave.h"
#include "core/formats/document_json.h"
#include "core/formats/file.h"
#include "ui/session.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iostream>
#include <random>

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

namespace splineloft::app {
namespace {

namespace fs = std::filesystem;

constexpr int pointsOfACurve = 4000; // about a hundred kilobytes: a save takes a while
constexpr auto longestLife = std::chrono::microseconds(60'000);

/// The document after so many edits. Each is of another length, so that mixtures would show.
Document version(int number) {
    Curve curve;
    curve.family = "linear";
    curve.ends = Ends::none;
    curve.points = Points(2);
    for (int i = 0; i < pointsOfACurve + number % 97; ++i) {
        curve.points.append(Point{number + 0.5 * i, 1.0 / (i + 1)});
    }
    Document document;
    document.curves.push_back(std::make_shared<Curve>(std::move(curve)));
    return document;
}

int versionOf(const Document& document) {
    return static_cast<int>(document.curves.at(0)->points[0][0]);
}

/// A child that does something over and over and tells which version is surely on the disk, until
/// it is killed. Returns the last that it told, or `before` where that was none.
int live(std::chrono::microseconds life, int before,
         const std::function<void(const std::function<void(int)>& tell)>& deeds) {
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) != 0) {
        std::exit(2);
    }
    const auto child = ::fork();
    if (child == 0) {
        deeds([&](int number) {
            [[maybe_unused]] const auto told = ::write(ends[1], &number, sizeof number);
        });
        ::_exit(0);
    }
    ::close(ends[1]);
    ::usleep(static_cast<useconds_t>(life.count()));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    int last = before;
    for (int number = 0; ::read(ends[0], &number, sizeof number) == sizeof number;) {
        last = number;
    }
    ::close(ends[0]);
    return last;
}

struct Count {
    int kills = 0, faults = 0, litter = 0, kept = 0;
    void fault(const std::string& what) {
        ++faults;
        std::cerr << "kill " << kills << ": " << what << '\n';
    }
};

std::size_t entriesIn(const fs::path& folder) {
    std::error_code failed;
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder, failed), {}));
}

/// Kills editors while they save: the file is the version last told, or the one after it.
Count killWhileSaving(const fs::path& folder, int kills, std::mt19937& random) {
    std::uniform_int_distribution<long> life(0, longestLife.count());
    Count count;
    const auto file = folder / "path.json";
    int number = 0;
    if (!saveFile(file, writeDocument(version(number)))) {
        count.fault("the first save failed");
    }
    for (count.kills = 1; count.kills <= kills; ++count.kills) {
        const int told =
            live(std::chrono::microseconds(life(random)), number, [&](const auto& tell) {
                for (int next = number + 1;; ++next) {
                    if (saveFile(file, writeDocument(version(next)))) {
                        tell(next);
                    }
                }
            });
        count.kept += told > number ? 1 : 0;
        const auto text = readFile(file);
        if (!text ||
            (*text != writeDocument(version(told)) && *text != writeDocument(version(told + 1)))) {
            count.fault("the file is neither old nor new");
        } else {
            number = *text == writeDocument(version(told)) ? told : told + 1;
        }
        count.litter += static_cast<int>(entriesIn(folder)) - 1;
        sweepStaleTemporaries(folder);
        if (entriesIn(folder) != 1) {
            count.fault("litter stays");
        }
    }
    --count.kills;
    return count;
}

/// An editor that keeps every change at once.
void editAndKeep(const fs::path& folder, int first, const std::function<void(int)>& tell) {
    Autosave autosave(folder, {1, 1});
    ui::Session session;
    for (int number = first;; ++number) {
        session.history.commit(version(number), "Change");
        autosave.look(session, Clock::now());
        while (autosave.patience(Clock::now()) < never) {
            ::usleep(20);
            autosave.look(session, Clock::now());
        }
        if (!autosave.takeComplaint()) {
            tell(number);
        }
    }
}

/// Kills editors while they autosave: the next one is offered the version last told or the one
/// after it, and nothing else is there.
Count killWhileKeeping(const fs::path& folder, int kills, std::mt19937& random) {
    std::uniform_int_distribution<long> life(0, longestLife.count());
    Count count;
    for (count.kills = 1; count.kills <= kills; ++count.kills) {
        constexpr int none = 0;
        const int told = live(std::chrono::microseconds(life(random)), none,
                              [&](const auto& tell) { editAndKeep(folder, 1, tell); });
        std::vector<std::string> problems;
        const auto before = entriesIn(folder);
        auto found = findUnsavedWork(folder, problems);
        count.litter += static_cast<int>(before - 2 * found.size());
        count.kept += told > none ? 1 : 0;
        if (!problems.empty() || found.size() > 1 || (found.empty() && told > none)) {
            count.fault("told version " + std::to_string(told) + ", offered " +
                        std::to_string(found.size()) + " documents");
        } else if (!found.empty()) {
            const int number = versionOf(found[0].document);
            const bool whole =
                *readFile(found[0].slot->document()) == writeDocument(version(number));
            if (!whole || number < told || number > told + 1) {
                count.fault("told version " + std::to_string(told) + ", offered " +
                            std::to_string(number));
            }
            found[0].slot->remove();
        }
        if (entriesIn(folder) != 0) {
            count.fault("litter stays");
        }
    }
    --count.kills;
    return count;
}

void print(const char* what, const Count& count) {
    std::cout << what << ": " << count.kills << " kills, " << count.kept
              << " after at least one whole write, " << count.litter << " stale files swept, "
              << count.faults << " faults\n";
}

int run(int kills) {
    const char* const seed = std::getenv("SPLINELOFT_SEED");
    std::mt19937 random(seed != nullptr ? static_cast<unsigned>(std::atoi(seed)) : 1);
    const auto folder =
        fs::temp_directory_path() / ("splineloft-soak-" + std::to_string(::getpid()));
    fs::create_directories(folder / "saving");
    fs::create_directories(folder / "keeping");
    const auto saving = killWhileSaving(folder / "saving", kills, random);
    const auto keeping = killWhileKeeping(folder / "keeping", kills, random);
    fs::remove_all(folder);
    print("save", saving);
    print("autosave", keeping);
    return saving.faults + keeping.faults == 0 ? 0 : 1;
}

} // namespace
} // namespace splineloft::app

int main(int argc, char** argv) {
    const int kills = argc == 2 ? std::atoi(argv[1]) : 0;
    if (kills <= 0) {
        std::cerr << "usage: soak COUNT\n";
        return 2;
    }
    return splineloft::app::run(kills);
}
