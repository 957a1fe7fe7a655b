// Saving: whatever goes wrong, the old file is still there, and no litter beside it. The failures
// are real ones: file size limits, read-only folders, a full and a read-only file system, kill -9.
#include "core/formats/file.h"
#include "core/formats/json_tape.h"
#include "tests/unit/child_process.h"
#include "tests/unit/comma_locale.h"

#include <gtest/gtest.h>

#include <csignal>
#include <fstream>
#include <functional>
#include <set>
#include <sstream>

#include <fcntl.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace splineloft {
namespace {

namespace fs = std::filesystem;

std::string contents(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

void put(const fs::path& path, std::string_view text) {
    std::ofstream(path) << text;
}

mode_t permissions(const fs::path& path) {
    struct stat status{};
    ::stat(path.c_str(), &status);
    return status.st_mode & 07777;
}

/// The refusal of a save in words, or "saved".
std::string outcome(const fs::path& path, std::string_view text) {
    const auto saved = saveFile(path, text);
    return saved ? "saved" : saved.refusal().message();
}

#define EXPECT_CONTAINS(text, part)                                                                \
    EXPECT_NE(std::string(text).find(part), std::string::npos) << "in: " << (text)

class Save : public testing::Test {
  protected:
    void SetUp() override {
        static int count = 0;
        folder_ = fs::temp_directory_path() /
                  ("splineloft-save-" + std::to_string(::getpid()) + "-" + std::to_string(count++));
        fs::create_directories(folder_);
        file_ = folder_ / "path.json";
    }
    void TearDown() override {
        fs::permissions(folder_, fs::perms::owner_all);
        fs::remove_all(folder_);
    }

    std::set<std::string> names() const {
        std::set<std::string> found;
        for (const auto& entry : fs::directory_iterator(folder_)) {
            found.insert(entry.path().filename().string());
        }
        return found;
    }

    fs::path folder_, file_;
};

TEST_F(Save, makesAndReplacesFiles) {
    EXPECT_EQ(outcome(file_, "one"), "saved");
    EXPECT_EQ(contents(file_), "one");
    EXPECT_EQ(outcome(file_, ""), "saved");
    EXPECT_EQ(contents(file_), "");
    const std::string large(3'000'000, 'x');
    EXPECT_EQ(outcome(file_, large), "saved");
    EXPECT_EQ(contents(file_), large);
    EXPECT_EQ(names(), std::set<std::string>{"path.json"});
}

TEST_F(Save, savesInTheCurrentFolder) {
    const auto before = fs::current_path();
    fs::current_path(folder_);
    EXPECT_EQ(outcome("bare.json", "x"), "saved");
    fs::current_path(before);
    EXPECT_EQ(contents(folder_ / "bare.json"), "x");
}

TEST_F(Save, takesTheLongestNames) {
    constexpr std::size_t longest = 255;
    EXPECT_EQ(outcome(folder_ / std::string(longest, 'n'), "x"), "saved");
    EXPECT_CONTAINS(outcome(folder_ / std::string(longest + 1, 'n'), "x"), "too long");
    EXPECT_EQ(names().size(), 1u);
}

TEST_F(Save, givesNewFilesThePermissionsOfTheUser) {
    const auto old = ::umask(027);
    EXPECT_EQ(outcome(file_, "x"), "saved");
    ::umask(old);
    EXPECT_EQ(permissions(file_), mode_t{0640});
}

TEST_F(Save, keepsPermissions) {
    put(file_, "old");
    for (const mode_t mode : {0600u, 0644u, 0664u, 0755u, 0666u}) {
        ::chmod(file_.c_str(), mode);
        EXPECT_EQ(outcome(file_, "new"), "saved");
        EXPECT_EQ(permissions(file_), mode);
    }
}

TEST_F(Save, keepsTheOwner) {
    if (::geteuid() != 0) {
        GTEST_SKIP() << "SKIPPED: only root can own files of others";
    }
    put(file_, "old");
    constexpr uid_t somebody = 12345;
    ASSERT_EQ(::chown(file_.c_str(), somebody, somebody), 0);
    EXPECT_EQ(outcome(file_, "new"), "saved");
    struct stat status{};
    ::stat(file_.c_str(), &status);
    EXPECT_EQ(status.st_uid, somebody);
    EXPECT_EQ(status.st_gid, somebody);
}

TEST_F(Save, followsSymbolicLinksAndKeepsThem) {
    fs::create_directory(folder_ / "real");
    put(folder_ / "real/target.json", "old");
    fs::create_symlink("real/target.json", folder_ / "second");
    fs::create_symlink(folder_ / "second", file_);
    EXPECT_EQ(outcome(file_, "new"), "saved");
    EXPECT_TRUE(fs::is_symlink(file_));
    EXPECT_TRUE(fs::is_symlink(folder_ / "second"));
    EXPECT_FALSE(fs::is_symlink(folder_ / "real/target.json"));
    EXPECT_EQ(contents(folder_ / "real/target.json"), "new");
}

TEST_F(Save, makesTheTargetOfADanglingLink) {
    fs::create_symlink("later.json", file_);
    EXPECT_EQ(outcome(file_, "new"), "saved");
    EXPECT_TRUE(fs::is_symlink(file_));
    EXPECT_EQ(contents(folder_ / "later.json"), "new");
}

TEST_F(Save, refusesLinksThatLeadInACircle) {
    fs::create_symlink("b", folder_ / "a");
    fs::create_symlink("a", folder_ / "b");
    EXPECT_CONTAINS(outcome(folder_ / "a", "x"), "circle");
}

TEST_F(Save, refusesFolders) {
    EXPECT_CONTAINS(outcome(folder_, "x"), "is a folder");
    EXPECT_CONTAINS(outcome(folder_ / "missing/path.json", "x"), "folder does not exist");
    put(file_, "old");
    EXPECT_CONTAINS(outcome(file_ / "path.json", "x"), "no folder");
    EXPECT_EQ(contents(file_), "old");
}

TEST_F(Save, writesToDevicesInsteadOfReplacingThem) {
    EXPECT_EQ(outcome("/dev/null", "x"), "saved");
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
    EXPECT_CONTAINS(outcome("/dev/full", "x"), "the disk is full");
    EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST_F(Save, keepsTheOldFileWhereTheNewOneDoesNotFit) {
    put(file_, "old");
    const auto ending = inChild([] { return limitFiles(1000); },
                                [&] { return outcome(file_, std::string(5000, 'x')); });
    ASSERT_TRUE(ending.couldStart);
    EXPECT_CONTAINS(ending.said, "too large");
    EXPECT_CONTAINS(ending.said, file_.string());
    EXPECT_EQ(contents(file_), "old");
    EXPECT_EQ(names(), std::set<std::string>{"path.json"});
}

TEST_F(Save, keepsTheOldFileInAReadOnlyFolder) {
    put(file_, "old");
    ::chmod(file_.c_str(), 0666);
    ::chmod(folder_.c_str(), 0555);
    const auto ending = inChild(becomeNobody, [&] { return outcome(file_, "new"); });
    ASSERT_TRUE(ending.couldStart);
    EXPECT_CONTAINS(ending.said, "permission denied");
    EXPECT_EQ(contents(file_), "old");
    EXPECT_EQ(names(), std::set<std::string>{"path.json"});
}

TEST_F(Save, respectsWriteProtectedFiles) {
    put(file_, "old");
    ::chmod(file_.c_str(), 0444);
    ::chmod(folder_.c_str(), 0777);
    const auto ending = inChild(becomeNobody, [&] { return outcome(file_, "new"); });
    ASSERT_TRUE(ending.couldStart);
    EXPECT_CONTAINS(ending.said, "permission denied");
    EXPECT_EQ(contents(file_), "old");
}

#define NEED_MOUNT(ending)                                                                         \
    if (!(ending).couldStart) {                                                                    \
        GTEST_SKIP() << "SKIPPED: no file system can be mounted here";                             \
    }

TEST_F(Save, keepsTheOldFileOnAFullDisk) {
    const auto ending =
        inChild([&] { return mountSmall(folder_); },
                [&] {
                    put(file_, "old");
                    const auto said = outcome(file_, std::string(100'000, 'x'));
                    return said + " / " + contents(file_) + " / " + std::to_string(names().size());
                });
    NEED_MOUNT(ending);
    EXPECT_CONTAINS(ending.said, "the disk is full");
    EXPECT_CONTAINS(ending.said, "/ old / 1");
}

TEST_F(Save, saysThatAFileSystemIsReadOnly) {
    const auto readOnly = [&] {
        if (!mountSmall(folder_)) {
            return false;
        }
        put(file_, "old");
        return ::mount("none", folder_.c_str(), "tmpfs", MS_REMOUNT | MS_RDONLY, nullptr) == 0;
    };
    const auto ending = inChild(readOnly, [&] {
        return outcome(file_, "new") + " / " + outcome(folder_ / "other", "x") + " / " +
               contents(file_);
    });
    NEED_MOUNT(ending);
    EXPECT_CONTAINS(ending.said, "path.json: the file system is read-only");
    EXPECT_CONTAINS(ending.said, "other: the file system is read-only");
    EXPECT_CONTAINS(ending.said, "/ old");
}

TEST_F(Save, neverLeavesHalfAFileWhenKilled) {
    const std::string even(200'000, 'e');
    const std::string odd(150'000, 'o');
    ASSERT_EQ(outcome(file_, even), "saved");
    constexpr int kills = 25;
    for (int i = 0; i < kills; ++i) {
        const auto child = ::fork();
        if (child == 0) {
            for (int k = 0;; ++k) {
                [[maybe_unused]] const auto saved = saveFile(file_, k % 2 == 0 ? odd : even);
            }
        }
        ::usleep(static_cast<useconds_t>(2000 + 700 * i));
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        const auto text = contents(file_);
        ASSERT_TRUE(text == even || text == odd) << "half a file of " << text.size() << " bytes";
    }
    sweepStaleTemporaries(folder_);
    EXPECT_EQ(names(), std::set<std::string>{"path.json"});
}

TEST_F(Save, sweepsOnlyWhatDeadProcessesLeft) {
    const auto dead = ::fork();
    if (dead == 0) {
        ::_exit(0);
    }
    ::waitpid(dead, nullptr, 0);
    const auto temporary = [](long process, const std::string& run) {
        return ".splineloft-" + std::to_string(process) + "-" + run + "-0.tmp";
    };
    const std::set<std::string> stale = {temporary(dead, "1"), temporary(::getpid(), "1")};
    const std::set<std::string> others = {temporary(::getppid(), "1"),
                                          ".splineloft-x-1-0.tmp",
                                          ".splineloft-.tmp",
                                          ".splineloft-1.tmp",
                                          ".splineloft--5-1-0.tmp",
                                          "splineloft-1-1-0.tmp",
                                          "path.json",
                                          ".splineloft-99999999999999999999-1-0.tmp"};
    for (const auto& group : {stale, others}) {
        for (const auto& name : group) {
            put(folder_ / name, "x");
        }
    }
    fs::create_directory(folder_ / temporary(dead, "2"));
    EXPECT_EQ(sweepStaleTemporaries(folder_), stale.size());
    auto left = others;
    left.insert(temporary(dead, "2"));
    EXPECT_EQ(names(), left);
    EXPECT_EQ(sweepStaleTemporaries(folder_ / "missing"), 0u);
}

TEST_F(Save, isReadBack) {
    const std::string text("a\0\xff\r\n", 5);
    ASSERT_EQ(outcome(file_, text), "saved");
    const auto read = readFile(file_);
    ASSERT_TRUE(read) << read.refusal().message();
    EXPECT_EQ(*read, text);
}

TEST_F(Save, readFileSaysWhatIsWrong) {
    EXPECT_EQ(readFile(file_).refusal().message(),
              file_.string() + ": does not exist; right would be: the name of a file that does");
    EXPECT_CONTAINS(readFile(folder_).refusal().message(), "is a folder");
    put(file_, "x");
    EXPECT_CONTAINS(readFile(file_ / "x").refusal().message(), "no folder");
    ::chmod(file_.c_str(), 0);
    ::chmod(folder_.c_str(), 0777);
    const auto ending = inChild(becomeNobody, [&] { return readFile(file_).refusal().message(); });
    ASSERT_TRUE(ending.couldStart);
    EXPECT_CONTAINS(ending.said, "permission denied");
}

TEST_F(Save, readFileRefusesLargeFilesUnread) {
    put(file_, "");
    fs::resize_file(file_, std::uintmax_t{1} << 40); // a hole: takes no room
    EXPECT_CONTAINS(readFile(file_).refusal().message(), "64 MB");
    EXPECT_CONTAINS(readFile("/dev/zero").refusal().message(), "64 MB");
    fs::resize_file(file_, largestFile);
    const auto read = readFile(file_);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->size(), largestFile);
}

TEST_F(Save, readStreamTakesAllButNotTooMuch) {
    std::istringstream good(std::string(2'500'000, 'x'));
    const auto read = readStream(good, "standard input");
    ASSERT_TRUE(read);
    EXPECT_EQ(read->size(), 2'500'000u);
    std::istringstream large(std::string(largestFile + 1, 'x'));
    EXPECT_CONTAINS(readStream(large, "standard input").refusal().message(),
                    "standard input: is too large");
}

} // namespace
} // namespace splineloft
