// A file that one process at a time holds, so that others leave alone what it stands for. The
// system lets it go when the process ends, however that ends.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace splineloft::app {

class FileLock {
  public:
    /// Makes the file if need be. Nothing where another holds it, or where it cannot be made.
    static std::optional<FileLock> of(const std::filesystem::path& path);

    FileLock(FileLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
    FileLock& operator=(FileLock&& other) noexcept {
        std::swap(descriptor_, other.descriptor_);
        return *this;
    }
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;
    ~FileLock();

    /// What stands in the file, as far as a few kilobytes go.
    std::string text() const;
    /// Writes into the empty file. Whether that went well.
    bool write(std::string_view text);

  private:
    explicit FileLock(int descriptor) : descriptor_(descriptor) {}

    int descriptor_;
};

} // namespace splineloft::app
