#include "app/storage/file_lock.h"

#include <array>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace splineloft::app {

std::optional<FileLock> FileLock::of(const std::filesystem::path& path) {
    const int descriptor =
        ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, S_IRUSR | S_IWUSR);
    if (descriptor < 0) {
        return std::nullopt;
    }
    FileLock lock(descriptor);
    struct stat status{};
    // Whoever held it until now may have removed the file: then the lock stands for nothing.
    const bool held = ::flock(descriptor, LOCK_EX | LOCK_NB) == 0 &&
                      ::fstat(descriptor, &status) == 0 && status.st_nlink > 0;
    return held ? std::optional(std::move(lock)) : std::nullopt;
}

FileLock::~FileLock() {
    if (descriptor_ >= 0) {
        ::close(descriptor_);
    }
}

std::string FileLock::text() const {
    std::array<char, 8192> text{}; // a path and a little around it
    const auto count = ::pread(descriptor_, text.data(), text.size(), 0);
    return count > 0 ? std::string(text.data(), static_cast<std::size_t>(count)) : "";
}

bool FileLock::write(std::string_view text) {
    return ::pwrite(descriptor_, text.data(), text.size(), 0) == static_cast<ssize_t>(text.size());
}

} // namespace splineloft::app
