// Pictures as pixels: read back from OpenGL, written as PNG.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace splineloft::app {

/// Red, green, blue and alpha of each pixel, row by row from the top left.
struct Image {
    int width = 0, height = 0; ///< pixels
    std::vector<std::uint8_t> rgba;

    /// The four bytes of the pixel in column x, row y; both must lie inside.
    const std::uint8_t* pixel(int x, int y) const {
        return &rgba[(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)) *
                     4];
    }
};

/// The pixels of the bound framebuffer, from its corner; of a window before it swaps its buffers.
Image readPixels(int width, int height);

/// Writes a PNG file, all of it or nothing. Returns the fault in one line, or nothing when done.
std::optional<std::string> writePng(const Image& image, const std::filesystem::path& path);

} // namespace splineloft::app
