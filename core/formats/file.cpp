#include "core/formats/file.h"

#include "core/formats/json_tape.h"
#include "core/formats/numbers.h"

#include <atomic>
#include <cerrno>
#include <chrono>
#include <istream>
#include <optional>
#include <system_error>

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

namespace splineloft {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view temporaryPrefix = ".splineloft-";
constexpr std::string_view temporarySuffix = ".tmp";
constexpr int mostLinks = 40; // as the kernel has it

/// A file descriptor that is closed when it goes out of scope.
class Descriptor {
  public:
    explicit Descriptor(int number) : number_(number) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (number_ >= 0) {
            ::close(number_);
        }
    }
    explicit operator bool() const { return number_ >= 0; }
    int number() const { return number_; }
    /// Some file systems report only here that the text did not fit.
    bool close() { return ::close(std::exchange(number_, -1)) == 0; }

  private:
    int number_;
};

struct Words {
    std::string what, remedy;
};

Words wordsFor(int error) {
    switch (error) {
    case ENOENT: return {"does not exist", "the name of a file that does"};
    case ENOTDIR: return {"lies in something that is no folder", "a path through folders"};
    case EISDIR: return {"is a folder", "a file"};
    case EACCES:
    case EPERM: return {"permission denied", "a file that you may use, or other permissions"};
    case EROFS: return {"the file system is read-only", "a place that can be written to"};
    case ENOSPC: return {"the disk is full", "more free space, or another disk"};
    case EDQUOT: return {"your disk quota is used up", "more free space, or another disk"};
    case EFBIG: return {"the file would be too large here", "a higher limit, or another disk"};
    case ENAMETOOLONG: return {"the name is too long", "a shorter name"};
    case ELOOP: return {"its symbolic links lead in a circle", "a link that leads to a file"};
    default: return {std::system_category().message(error), "a file that can be used"};
    }
}

Refusal refusal(const fs::path& path, int error) {
    auto words = wordsFor(error);
    return {path.string(), "", std::move(words.what), std::move(words.remedy)};
}

Refusal tooLarge(std::string file) {
    return {std::move(file), "", "is too large",
            "at most 64 MB: " + std::to_string(largestFile) + " bytes"};
}

/// Where a path leads through symbolic links, also if there is no file yet; nothing for a circle.
std::optional<fs::path> withoutLinks(fs::path path) {
    std::error_code error;
    for (int i = 0; i < mostLinks; ++i) {
        if (!fs::is_symlink(path, error)) {
            return path;
        }
        path =
            path.parent_path() / fs::read_symlink(path, error); // an absolute target replaces all
    }
    return std::nullopt;
}

/// Tells this run of the program from an earlier one that had the same process id.
std::string runName() {
    static const auto name = std::to_string(std::chrono::system_clock::now().time_since_epoch() /
                                            std::chrono::nanoseconds(1));
    return name;
}

fs::path newTemporaryName(const fs::path& folder) {
    static std::atomic<unsigned> saves = 0;
    return folder / (std::string(temporaryPrefix) + std::to_string(::getpid()) + "-" + runName() +
                     "-" + std::to_string(saves++) + std::string(temporarySuffix));
}

/// 0, or the error.
int writeAll(int descriptor, std::string_view text) {
    while (!text.empty()) {
        const auto written = ::write(descriptor, text.data(), text.size());
        if (written >= 0) {
            text.remove_prefix(static_cast<std::size_t>(written));
        } else if (errno != EINTR) {
            return errno;
        }
    }
    return 0;
}

/// So that the new name, too, survives a loss of power. Not every file system can; then so be it.
void synchronizeFolder(const fs::path& folder) {
    const Descriptor descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (descriptor) {
        ::fsync(descriptor.number());
    }
}

/// Fills the temporary file. 0, or the error.
int fillTemporary(const fs::path& temporary, std::string_view text,
                  const std::optional<struct stat>& old) {
    constexpr mode_t asTheUserLikes = 0666; // less the umask
    constexpr mode_t onlyMine = 0600;       // until it gets the old file's permissions
    Descriptor file(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW,
                           old ? onlyMine : asTheUserLikes));
    if (!file) {
        return errno;
    }
    if (const int error = writeAll(file.number(), text)) {
        return error;
    }
    if (old) {
        // Only root may give a file away; another's file that we may write becomes ours.
        [[maybe_unused]] const int kept = ::fchown(file.number(), old->st_uid, old->st_gid);
        constexpr mode_t permissions = 07777;
        if (::fchmod(file.number(), old->st_mode & permissions) != 0) {
            return errno;
        }
    }
    if (::fsync(file.number()) != 0) {
        return errno;
    }
    return file.close() ? 0 : errno;
}

/// 0, or the error; the temporary file is gone either way.
int replace(const fs::path& target, std::string_view text, const std::optional<struct stat>& old) {
    const auto folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    const auto temporary = newTemporaryName(folder);
    int error = fillTemporary(temporary, text, old);
    if (error == 0 && ::rename(temporary.c_str(), target.c_str()) != 0) {
        error = errno;
    }
    if (error != 0) {
        ::unlink(temporary.c_str());
        return error;
    }
    synchronizeFolder(folder);
    return 0;
}

int writeToDevice(const fs::path& device, std::string_view text) {
    Descriptor file(::open(device.c_str(), O_WRONLY | O_CLOEXEC));
    if (!file) {
        return errno;
    }
    const int error = writeAll(file.number(), text);
    return error != 0 || file.close() ? error : errno;
}

/// The process that made a temporary file and the name of its run; nothing for other files' names.
struct Maker {
    long long process;
    std::string_view run;
};

std::optional<Maker> makerOf(std::string_view name) {
    if (!name.starts_with(temporaryPrefix) || !name.ends_with(temporarySuffix)) {
        return std::nullopt;
    }
    name.remove_prefix(temporaryPrefix.size());
    name.remove_suffix(temporarySuffix.size());
    const auto first = name.find('-');
    const auto second = name.find('-', first + 1);
    if (first == name.npos || second == name.npos) {
        return std::nullopt;
    }
    const auto process = wholeNumberFrom(name.substr(0, first));
    if (!process || *process <= 0) {
        return std::nullopt;
    }
    return Maker{*process, name.substr(first + 1, second - first - 1)};
}

bool isAlive(const Maker& maker) {
    if (maker.process == ::getpid()) {
        return maker.run == runName();
    }
    return ::kill(static_cast<pid_t>(maker.process), 0) == 0 || errno != ESRCH;
}

} // namespace

Result<std::string> readFile(const fs::path& path) {
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    struct stat status{};
    if (!file || ::fstat(file.number(), &status) != 0) {
        return refusal(path, errno);
    }
    if (S_ISDIR(status.st_mode)) {
        return refusal(path, EISDIR);
    }
    if (S_ISREG(status.st_mode) && static_cast<std::uintmax_t>(status.st_size) > largestFile) {
        return tooLarge(path.string());
    }
    // What is no plain file does not tell its size beforehand, and a plain one may still grow.
    std::string text;
    constexpr std::size_t block = std::size_t{1} << 20;
    while (text.size() <= largestFile) {
        const auto before = text.size();
        text.resize(before + block);
        const auto count = ::read(file.number(), text.data() + before, block);
        text.resize(before + (count > 0 ? static_cast<std::size_t>(count) : 0));
        if (count == 0) {
            return text;
        }
        if (count < 0 && errno != EINTR) {
            return refusal(path, errno);
        }
    }
    return tooLarge(path.string());
}

Result<std::string> readStream(std::istream& stream, std::string_view name) {
    std::string text;
    constexpr std::size_t block = std::size_t{1} << 20;
    while (stream && text.size() <= largestFile) {
        const auto before = text.size();
        text.resize(before + block);
        stream.read(text.data() + before, static_cast<std::streamsize>(block));
        text.resize(before + static_cast<std::size_t>(stream.gcount()));
    }
    if (text.size() > largestFile) {
        return tooLarge(std::string(name));
    }
    return text;
}

Result<Done> saveFile(const fs::path& path, std::string_view text) {
    const auto target = withoutLinks(path);
    if (!target) {
        return refusal(path, ELOOP);
    }
    std::optional<struct stat> old(std::in_place);
    if (::stat(target->c_str(), &*old) != 0) {
        old.reset();
    }
    int error = 0;
    if (old && S_ISDIR(old->st_mode)) {
        error = EISDIR;
    } else if (old && !S_ISREG(old->st_mode)) {
        error = writeToDevice(*target, text);
    } else if (old && ::faccessat(AT_FDCWD, target->c_str(), W_OK, AT_EACCESS) != 0) {
        error = errno; // renaming would get around the write protection of the file itself
    } else {
        error = replace(*target, text, old);
    }
    if (error == 0) {
        return Done{};
    }
    if (error == ENOENT) {
        const std::string folder =
            *target == path ? "its folder" : "the folder that its link leads to";
        return Refusal{path.string(), "", folder + " does not exist", "a folder that does"};
    }
    return refusal(path, error);
}

std::size_t sweepStaleTemporaries(const fs::path& folder) {
    std::size_t count = 0;
    std::error_code error;
    fs::directory_iterator entry(folder.empty() ? fs::path(".") : folder, error);
    for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
        const auto name = entry->path().filename().string();
        const auto maker = makerOf(name);
        std::error_code ignored;
        if (maker && !isAlive(*maker) && fs::is_regular_file(entry->symlink_status(ignored)) &&
            fs::remove(entry->path(), ignored)) {
            ++count;
        }
    }
    return count;
}

} // namespace splineloft
