#include "app/renderer.h"

#include "app/imgui_versions.h"
#include "ui/packing.h"

#include "shaders.h"

#include <backends/imgui_impl_opengl3.h>
#include <glad/gl.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <type_traits>
#include <vector>

namespace splineloft::app {

namespace {

using gl::AttributeKind;
using gl::InstanceAttribute;

// What one instance of the area program reads.
struct AreaInstance {
    float left, top, right, bottom;
    ui::Colour fill;
};

constexpr std::array areaAttributes{
    InstanceAttribute{0, 4, AttributeKind::number, offsetof(AreaInstance, left)},
    InstanceAttribute{1, 4, AttributeKind::colour, offsetof(AreaInstance, fill)}};

constexpr std::array signAttributes{
    InstanceAttribute{0, 4, AttributeKind::number, offsetof(ui::Sign, x)},
    InstanceAttribute{1, 1, AttributeKind::number, offsetof(ui::Sign, angle)},
    InstanceAttribute{2, 1, AttributeKind::code, offsetof(ui::Sign, shape)},
    InstanceAttribute{3, 4, AttributeKind::colour, offsetof(ui::Sign, fill)},
    InstanceAttribute{4, 4, AttributeKind::colour, offsetof(ui::Sign, outline)}};

// The four parts that the sign program reads as one: they lie side by side.
static_assert(offsetof(ui::Sign, radius) == offsetof(ui::Sign, x) + 2 * sizeof(float));
static_assert(offsetof(ui::Sign, outlineWidth) == offsetof(ui::Sign, x) + 3 * sizeof(float));
// Likewise x, y, along, halfWidth, then dash and gap, of a ribbon.
static_assert(offsetof(ui::RibbonVertex, halfWidth) == 3 * sizeof(float));
static_assert(offsetof(ui::RibbonVertex, gap) == 5 * sizeof(float));
static_assert(sizeof(ui::Colour) == 4 && std::is_standard_layout_v<ui::Colour>);

// One buffer seen four times, each view a vertex further on: instance i reads vertices i .. i+3.
constexpr std::size_t ribbonVertex(std::size_t ahead) {
    return ahead * sizeof(ui::RibbonVertex);
}

constexpr std::array ribbonAttributes{
    InstanceAttribute{0, 2, AttributeKind::number, ribbonVertex(0)},
    InstanceAttribute{1, 4, AttributeKind::number, ribbonVertex(1)},
    InstanceAttribute{2, 2, AttributeKind::number,
                      ribbonVertex(1) + offsetof(ui::RibbonVertex, dash)},
    InstanceAttribute{3, 4, AttributeKind::colour,
                      ribbonVertex(1) + offsetof(ui::RibbonVertex, colour)},
    InstanceAttribute{4, 4, AttributeKind::number, ribbonVertex(2)},
    InstanceAttribute{5, 4, AttributeKind::colour,
                      ribbonVertex(2) + offsetof(ui::RibbonVertex, colour)},
    InstanceAttribute{6, 2, AttributeKind::number, ribbonVertex(3)}};

/// Red, green, blue and alpha from 0 to 1.
std::array<float, 4> numbersOf(ui::Colour colour) {
    const auto part = [](std::uint8_t byte) { return static_cast<float>(byte) / 255.0f; };
    return {part(colour.red), part(colour.green), part(colour.blue), part(colour.alpha)};
}

void clear(ui::Colour colour) {
    const auto [red, green, blue, alpha] = numbersOf(colour);
    glClearColor(red * alpha, green * alpha, blue * alpha, alpha);
    glClear(GL_COLOR_BUFFER_BIT);
}

// Keeps drawing inside a rectangle for as long as it lives.
class Clip {
  public:
    Clip(const ui::ScreenRect& rect, const ui::Screen& screen) {
        const auto edge = [](double place, int limit) {
            return static_cast<int>(std::lround(std::clamp(place, 0.0, double(limit))));
        };
        const auto left = edge(rect.left, screen.width);
        const auto bottom = edge(rect.bottom(), screen.height);
        const auto width = edge(rect.right(), screen.width) - left;
        const auto height = bottom - edge(rect.top, screen.height);
        glEnable(GL_SCISSOR_TEST);
        glScissor(left, screen.height - bottom, std::max(width, 0), std::max(height, 0));
    }
    ~Clip() { glDisable(GL_SCISSOR_TEST); }
    Clip(const Clip&) = delete;
    Clip& operator=(const Clip&) = delete;
};

/// A rectangle with a margin of a pixel.
ui::ScreenRect grown(const ui::ScreenRect& rect) {
    return {rect.left - 1, rect.top - 1, rect.width + 2, rect.height + 2};
}

/// A vertex shader with what it takes to lay out the segments of strokes before it.
std::string withSegments(const char* body) {
    return std::string(shaders::segmentVertex) + body;
}

/// Straight segments that a run is drawn with.
std::size_t segmentsOf(const ui::PieceRun& run) {
    const auto pieces = run.last - run.first;
    return run.step > 1 ? (pieces + run.step - 1) / run.step : pieces * run.segments;
}

} // namespace

Renderer::Batch::Batch(const char* name, const char* vertexBody, const char* fragmentBody,
                       std::size_t stride, std::span<const gl::InstanceAttribute> attributes)
    : program(name, vertexBody, fragmentBody), vertices(buffer, stride, attributes) {}

void Renderer::Batch::draw(std::span<const std::byte> instances, std::size_t count,
                           const ui::Screen& screen) {
    buffer.upload(instances);
    program.use();
    program.set("screen", static_cast<float>(screen.width), static_cast<float>(screen.height));
    vertices.bind();
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA); // the shaders multiply by alpha themselves
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(count));
    glDisable(GL_BLEND);
    glBindVertexArray(0);
    glUseProgram(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

Renderer::Tools::Tools()
    : areas("area", shaders::areaVertex, shaders::areaFragment, sizeof(AreaInstance),
            areaAttributes),
      ribbons("ribbon", withSegments(shaders::ribbonVertex).c_str(), shaders::ribbonFragment,
              sizeof(ui::RibbonVertex), ribbonAttributes),
      signs("sign", shaders::signVertex, shaders::signFragment, sizeof(ui::Sign), signAttributes),
      pieces("piece", withSegments(shaders::pieceVertex).c_str(), shaders::ribbonFragment) {}

Renderer::Renderer() {
    if (ImGui::GetCurrentContext() != nullptr) {
        panels_ = ImGui_ImplOpenGL3_Init("#version 330 core");
    }
}

Renderer::~Renderer() {
    if (panels_) {
        ImGui_ImplOpenGL3_Shutdown();
    }
}

void Renderer::uploadFonts() {
    if (panels_) {
        renewFontTexture();
    }
}

void Renderer::draw(const ui::FrameResult& frame, const ui::Screen& screen) {
    begin(frame, screen);
    if (!tools_) {
        tools_.emplace();
    }
    for (const auto& picture : frame.pictures) {
        drawPicture(picture, frame.background, screen);
    }
    tables_.forgetUnused();
    drawData();
}

void Renderer::drawPanels(const ui::FrameResult& frame, const ui::Screen& screen) {
    begin(frame, screen);
    drawData();
}

void Renderer::begin(const ui::FrameResult& frame, const ui::Screen& screen) {
    glViewport(0, 0, screen.width, screen.height);
    clear(frame.background);
}

void Renderer::drawData() {
    auto* const panels = panels_ ? ImGui::GetDrawData() : nullptr;
    if (panels != nullptr) {
        ImGui_ImplOpenGL3_RenderDrawData(panels);
    }
}

void Renderer::drawPicture(const ui::Picture& picture, ui::Colour behind,
                           const ui::Screen& screen) {
    const Clip clip(picture.frame, screen);
    if (picture.background != behind) {
        // To beyond the edges, which the clip cuts sharp. (Clearing a part costs a shader, too.)
        drawAreas(std::array{ui::Area{grown(picture.frame), picture.background}}, screen);
    }
    drawAreas(picture.areas, screen);
    const auto ribbons = std::span(picture.ribbons);
    std::size_t drawn = 0;
    for (const auto& stroke : picture.pieces) {
        drawRibbons(ribbons.subspan(drawn, stroke.ribbonsBefore - drawn), screen);
        drawn = stroke.ribbonsBefore;
        drawPieces(stroke, screen);
    }
    drawRibbons(ribbons.subspan(drawn), screen);
    drawSigns(picture.signs, screen);
}

void Renderer::drawAreas(std::span<const ui::Area> areas, const ui::Screen& screen) {
    if (areas.empty()) {
        return;
    }
    std::vector<AreaInstance> instances;
    instances.reserve(areas.size());
    for (const auto& [rect, fill] : areas) {
        instances.push_back({static_cast<float>(rect.left), static_cast<float>(rect.top),
                             static_cast<float>(rect.right()), static_cast<float>(rect.bottom()),
                             fill});
    }
    tools_->areas.draw(std::as_bytes(std::span(instances)), instances.size(), screen);
}

void Renderer::drawRibbons(std::span<const ui::RibbonVertex> ribbons, const ui::Screen& screen) {
    constexpr std::size_t readAhead = 3;
    if (ribbons.size() > readAhead) {
        tools_->ribbons.draw(std::as_bytes(ribbons), ribbons.size() - readAhead, screen);
    }
}

void Renderer::drawPieces(const ui::PieceStroke& stroke, const ui::Screen& screen) {
    const auto& table = stroke.table;
    tables_.upToDate(table).bind();
    const auto number = [](auto value) { return static_cast<int>(value); };
    const auto centreX = ui::split(stroke.centre.x);
    const auto centreY = ui::split(stroke.centre.y);
    tools_->pieces.use();
    tools_->pieces.set("screen", static_cast<float>(screen.width),
                       static_cast<float>(screen.height));
    tools_->pieces.set("table_shape",
                       std::array{table.degree, number(table.stride), number(table.points.size()),
                                  number(stroke.closed)});
    tools_->pieces.set("centre", std::array{centreX[0], centreY[0], centreX[1], centreY[1]});
    tools_->pieces.set("placing", std::array{static_cast<float>(stroke.origin.x),
                                             static_cast<float>(stroke.origin.y),
                                             static_cast<float>(stroke.pixelsPerUnit),
                                             static_cast<float>(stroke.line)});
    tools_->pieces.set(
        "style", std::array{stroke.style.width / 2, stroke.style.dash, stroke.style.gap, 0.0F});
    tools_->pieces.set("paint", numbersOf(stroke.style.colour));
    tools_->noVertices.bind();
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    for (const auto& run : stroke.runs) {
        tools_->pieces.set("run", std::array{number(run.first), number(run.last),
                                             number(run.segments), number(run.step)});
        glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(segmentsOf(run)));
    }
    glDisable(GL_BLEND);
    glBindVertexArray(0);
    glUseProgram(0);
    glBindTexture(GL_TEXTURE_2D, 0);
}

void Renderer::drawSigns(std::span<const ui::Sign> signs, const ui::Screen& screen) {
    if (!signs.empty()) {
        tools_->signs.draw(std::as_bytes(signs), signs.size(), screen);
    }
}

} // namespace splineloft::app
