// Files, read whole and saved whole. A save never leaves half a file: whatever goes wrong, the old
// one is still there, untouched.
#pragma once

#include "core/formats/result.h"

#include <cstddef>
#include <filesystem>
#include <iosfwd>
#include <string>
#include <string_view>

namespace splineloft {

/// The bytes of a file of at most `largestFile` bytes (see json_tape.h); larger ones are refused
/// without being read.
Result<std::string> readFile(const std::filesystem::path& path);

/// All that comes from a stream, under the same limit. `name` stands for the file in a refusal.
Result<std::string> readStream(std::istream& stream, std::string_view name);

/// Replaces the file, or makes it: the text goes to a temporary file beside it, to the disk, and
/// only then under the file's name. Symbolic links are followed and stay, permissions are kept.
/// A hard link is left with the old text. Devices and pipes are simply written to.
Result<Done> saveFile(const std::filesystem::path& path, std::string_view text);

/// Removes the temporary files that saves of programs that have since died left in a folder, and
/// says how many they were. Whatever cannot be read or removed is passed over.
std::size_t sweepStaleTemporaries(const std::filesystem::path& folder);

} // namespace splineloft
