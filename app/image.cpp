#include "app/image.h"

#include <glad/gl.h>
#include <stb_image_write.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

namespace splineloft::app {

namespace {

// OpenGL's rows run upwards from the bottom.
void turnUpsideDown(Image& image) {
    const auto row = static_cast<std::ptrdiff_t>(image.width) * 4;
    auto top = image.rgba.begin();
    auto bottom = image.rgba.end() - row;
    for (; top < bottom; top += row, bottom -= row) {
        std::swap_ranges(top, top + row, bottom);
    }
}

std::vector<char> encodePng(const Image& image) {
    std::vector<char> bytes;
    const auto append = [](void* to, void* data, int size) {
        const auto* const first = static_cast<const char*>(data);
        static_cast<std::vector<char>*>(to)->insert(static_cast<std::vector<char>*>(to)->end(),
                                                    first, first + size);
    };
    const auto encoded = stbi_write_png_to_func(append, &bytes, image.width, image.height, 4,
                                                image.rgba.data(), image.width * 4);
    return encoded != 0 ? bytes : std::vector<char>{};
}

} // namespace

Image readPixels(int width, int height) {
    Image image{width, height, {}};
    image.rgba.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    turnUpsideDown(image);
    return image;
}

std::optional<std::string> writePng(const Image& image, const std::filesystem::path& path) {
    const auto bytes = encodePng(image);
    if (bytes.empty()) {
        return path.string() + ": the picture cannot be encoded as PNG (is it empty?)";
    }
    auto unfinished = path;
    unfinished += ".part";
    errno = 0;
    std::ofstream file(unfinished, std::ios::binary);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();
    std::error_code fault;
    if (file.fail()) {
        fault = std::error_code(errno != 0 ? errno : EIO, std::generic_category());
    } else {
        std::filesystem::rename(unfinished, path, fault);
    }
    if (!fault) {
        return std::nullopt;
    }
    std::error_code ignored;
    std::filesystem::remove(unfinished, ignored);
    return path.string() + ": cannot be written: " + fault.message();
}

} // namespace splineloft::app
