// OpenGL objects as values with an owner: made in the constructor, freed in the destructor, moved
// but never copied. All need a current OpenGL 3.3 context, and die before it.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <utility>

namespace splineloft::app::gl {

/// Loads the functions of OpenGL for the current context through `find` (such as
/// glfwGetProcAddress). Throws WindowError if they are older than 3.3.
void loadFunctions(void (*(*find)(const char*))());

/// The name that OpenGL gave an object; freed once, by the function `release`.
template <void (*release)(unsigned)> class Name {
  public:
    explicit Name(unsigned value) : value_(value) {}
    Name(Name&& other) noexcept : value_(std::exchange(other.value_, 0)) {}
    Name& operator=(Name&& other) noexcept {
        std::swap(value_, other.value_);
        return *this;
    }
    Name(const Name&) = delete;
    Name& operator=(const Name&) = delete;
    ~Name() {
        if (value_ != 0) {
            release(value_);
        }
    }
    unsigned value() const { return value_; }

  private:
    unsigned value_;
};

void releaseProgram(unsigned name);
void releaseBuffer(unsigned name);
void releaseVertexArray(unsigned name);
void releaseFramebuffer(unsigned name);
void releaseRenderbuffer(unsigned name);
void releaseTexture(unsigned name);

/// A pair of shaders, linked.
class Program {
  public:
    /// Compiles two shader bodies, which must have no version line. Throws WindowError with the
    /// driver's log when it refuses them; `name` says which program that was.
    Program(const std::string& name, const char* vertexBody, const char* fragmentBody);
    void use() const;
    // Set a uniform; the program must be in use.
    void set(const char* uniform, float x, float y) const;
    void set(const char* uniform, const std::array<float, 4>& numbers) const;
    void set(const char* uniform, const std::array<int, 4>& numbers) const;

  private:
    Name<releaseProgram> name_;
};

/// Bytes on the graphics card that are replaced every frame.
class StreamBuffer {
  public:
    StreamBuffer();
    void bind() const;
    /// Replaces the contents and leaves the buffer bound. The old storage is given up rather than
    /// overwritten, so the card may still be reading it.
    void upload(std::span<const std::byte> bytes);

  private:
    Name<releaseBuffer> name_;
    std::size_t capacity_ = 0;
};

/// A long row of texels, four floats each, that a shader reads by their index: folded into lines of
/// `width`, for a texture has few texels in one direction.
class TexelRow {
  public:
    static constexpr std::size_t width = 2048;

    /// With room for so many texels. Throws WindowError where the driver has not that much.
    explicit TexelRow(std::size_t texels);
    /// Replaces texels from `first` on; four numbers each.
    void upload(std::size_t first, std::span<const float> numbers);
    void bind() const;

  private:
    Name<releaseTexture> name_;
};

/// How the bytes of an attribute are read.
enum class AttributeKind {
    number, ///< floats
    colour, ///< bytes 0 .. 255, read as 0 .. 1
    code,   ///< bytes, read as they are
};

/// One attribute of an instance: where it lies in the buffer.
struct InstanceAttribute {
    unsigned location = 0;
    int parts = 1; ///< 1 .. 4
    AttributeKind kind = AttributeKind::number;
    std::size_t offset = 0; ///< bytes from the start of the buffer
};

/// How instances are read from a buffer.
class VertexArray {
  public:
    /// Instances lie `stride` bytes apart in `buffer`.
    VertexArray(const StreamBuffer& buffer, std::size_t stride,
                std::span<const InstanceAttribute> attributes);
    /// Nothing is read from any buffer.
    VertexArray();
    void bind() const;

  private:
    Name<releaseVertexArray> name_;
};

/// A picture to draw into that no window shows: 8 bits each of red, green, blue and alpha.
class Framebuffer {
  public:
    /// Throws WindowError when the driver cannot hold width x height pixels.
    Framebuffer(int width, int height);
    void bind() const;

  private:
    Name<releaseFramebuffer> name_;
    Name<releaseRenderbuffer> colour_;
};

} // namespace splineloft::app::gl
