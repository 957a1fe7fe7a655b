#include "app/gl.h"

#include "app/window_error.h"

#include <glad/gl.h>

#include <algorithm>

namespace splineloft::app::gl {

namespace {

constexpr const char* versionLine = "#version 330 core\n";

unsigned make(void (*generate)(GLsizei, GLuint*)) {
    GLuint name = 0;
    generate(1, &name);
    return name;
}

std::string shaderLog(unsigned shader) {
    GLint size = 0;
    glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &size);
    std::string log(static_cast<std::size_t>(std::max(size, 1)), '\0');
    glGetShaderInfoLog(shader, size, nullptr, log.data());
    return log.c_str();
}

std::string programLog(unsigned program) {
    GLint size = 0;
    glGetProgramiv(program, GL_INFO_LOG_LENGTH, &size);
    std::string log(static_cast<std::size_t>(std::max(size, 1)), '\0');
    glGetProgramInfoLog(program, size, nullptr, log.data());
    return log.c_str();
}

// The shader is flagged for deletion once it is attached: it lives as long as its program.
void attachShader(unsigned program, unsigned kind, const char* body, const std::string& name) {
    const auto shader = glCreateShader(kind);
    const char* const texts[] = {versionLine, body};
    glShaderSource(shader, 2, texts, nullptr);
    glCompileShader(shader);
    glAttachShader(program, shader);
    glDeleteShader(shader);
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled != GL_TRUE) {
        throw WindowError("the graphics driver refuses the shader '" + name +
                          "' (a newer driver may help): " + shaderLog(shader));
    }
}

} // namespace

void loadFunctions(void (*(*find)(const char*))()) {
    const auto version = gladLoadGL(find);
    if (version == 0 || version < GLAD_MAKE_VERSION(3, 3)) {
        throw WindowError("OpenGL 3.3 is needed and the driver offers less: install or update the "
                          "graphics driver (Mesa's software driver will do: libgl1-mesa-dri)");
    }
}

void releaseProgram(unsigned name) {
    glDeleteProgram(name);
}

void releaseBuffer(unsigned name) {
    glDeleteBuffers(1, &name);
}

void releaseVertexArray(unsigned name) {
    glDeleteVertexArrays(1, &name);
}

void releaseFramebuffer(unsigned name) {
    glDeleteFramebuffers(1, &name);
}

void releaseRenderbuffer(unsigned name) {
    glDeleteRenderbuffers(1, &name);
}

void releaseTexture(unsigned name) {
    glDeleteTextures(1, &name);
}

Program::Program(const std::string& name, const char* vertexBody, const char* fragmentBody)
    : name_(glCreateProgram()) {
    attachShader(name_.value(), GL_VERTEX_SHADER, vertexBody, name);
    attachShader(name_.value(), GL_FRAGMENT_SHADER, fragmentBody, name);
    glLinkProgram(name_.value());
    GLint linked = GL_FALSE;
    glGetProgramiv(name_.value(), GL_LINK_STATUS, &linked);
    if (linked != GL_TRUE) {
        throw WindowError("the graphics driver cannot link the shader '" + name +
                          "' (a newer driver may help): " + programLog(name_.value()));
    }
}

void Program::use() const {
    glUseProgram(name_.value());
}

void Program::set(const char* uniform, float x, float y) const {
    glUniform2f(glGetUniformLocation(name_.value(), uniform), x, y);
}

void Program::set(const char* uniform, const std::array<float, 4>& numbers) const {
    glUniform4fv(glGetUniformLocation(name_.value(), uniform), 1, numbers.data());
}

void Program::set(const char* uniform, const std::array<int, 4>& numbers) const {
    glUniform4iv(glGetUniformLocation(name_.value(), uniform), 1, numbers.data());
}

StreamBuffer::StreamBuffer() : name_(make(glGenBuffers)) {}

void StreamBuffer::bind() const {
    glBindBuffer(GL_ARRAY_BUFFER, name_.value());
}

void StreamBuffer::upload(std::span<const std::byte> bytes) {
    bind();
    if (bytes.size() > capacity_) { // half as much again, so that growing strokes settle soon
        capacity_ = bytes.size() + bytes.size() / 2;
    }
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(capacity_), nullptr, GL_STREAM_DRAW);
    glBufferSubData(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(bytes.size()), bytes.data());
}

TexelRow::TexelRow(std::size_t texels) : name_(make(glGenTextures)) {
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    const auto lines = std::max<std::size_t>((texels + width - 1) / width, 1);
    if (lines > static_cast<std::size_t>(most)) {
        throw WindowError("the graphics driver has no room for a curve of so many points: it takes "
                          "textures of at most " +
                          std::to_string(most) + " lines, and " + std::to_string(lines) +
                          " are needed");
    }
    bind();
    for (const auto parameter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
        glTexParameteri(GL_TEXTURE_2D, parameter, GL_NEAREST); // four floats are not filtered
    }
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, static_cast<GLsizei>(width),
                 static_cast<GLsizei>(lines), 0, GL_RGBA, GL_FLOAT, nullptr);
    glBindTexture(GL_TEXTURE_2D, 0);
}

void TexelRow::upload(std::size_t first, std::span<const float> numbers) {
    bind();
    const auto last = first + numbers.size() / 4;
    for (auto at = first; at < last;) {
        // The rest of a line that has begun, or as many whole lines as there are, or a last part.
        const auto column = at % width;
        const auto lines = column == 0 ? (last - at) / width : 0;
        const auto columns = lines > 0 ? width : std::min(width - column, last - at);
        glTexSubImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(column),
                        static_cast<GLint>(at / width), static_cast<GLsizei>(columns),
                        static_cast<GLsizei>(std::max<std::size_t>(lines, 1)), GL_RGBA, GL_FLOAT,
                        numbers.data() + (at - first) * 4);
        at += columns * std::max<std::size_t>(lines, 1);
    }
    glBindTexture(GL_TEXTURE_2D, 0);
}

void TexelRow::bind() const {
    glBindTexture(GL_TEXTURE_2D, name_.value());
}

VertexArray::VertexArray() : name_(make(glGenVertexArrays)) {}

VertexArray::VertexArray(const StreamBuffer& buffer, std::size_t stride,
                         std::span<const InstanceAttribute> attributes)
    : name_(make(glGenVertexArrays)) {
    glBindVertexArray(name_.value());
    buffer.bind();
    for (const auto& attribute : attributes) {
        const auto isFloat = attribute.kind == AttributeKind::number;
        const auto normalized = attribute.kind == AttributeKind::colour;
        glEnableVertexAttribArray(attribute.location);
        glVertexAttribPointer(attribute.location, attribute.parts,
                              isFloat ? GL_FLOAT : GL_UNSIGNED_BYTE,
                              normalized ? GL_TRUE : GL_FALSE, static_cast<GLsizei>(stride),
                              reinterpret_cast<const void*>(attribute.offset));
        glVertexAttribDivisor(attribute.location, 1);
    }
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void VertexArray::bind() const {
    glBindVertexArray(name_.value());
}

Framebuffer::Framebuffer(int width, int height)
    : name_(make(glGenFramebuffers)), colour_(make(glGenRenderbuffers)) {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
    if (width < 1 || height < 1 || width > largest || height > largest) {
        throw WindowError("a picture of " + std::to_string(width) + "x" + std::to_string(height) +
                          " pixels cannot be drawn: each side must be 1 to " +
                          std::to_string(largest));
    }
    glBindRenderbuffer(GL_RENDERBUFFER, colour_.value());
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
    glBindRenderbuffer(GL_RENDERBUFFER, 0);
    bind();
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                              colour_.value());
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        throw WindowError("the graphics driver has no room for a picture of " +
                          std::to_string(width) + "x" + std::to_string(height) +
                          " pixels: ask for a smaller one");
    }
}

void Framebuffer::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, name_.value());
}

} // namespace splineloft::app::gl
