// Draws a frame: the pictures, then the panels on top of them. Everything that calls OpenGL to draw
// is in renderer.cpp. Colours are blended as they are stored (sRGB bytes), as the panels' are.
#pragma once

#include "app/gl.h"
#include "app/piece_tables.h"
#include "ui/drawing.h"
#include "ui/frame.h"

#include <optional>
#include <span>

namespace splineloft::app {

/// Draws into whichever framebuffer is bound. Needs a current OpenGL 3.3 context; draws the panels
/// too if Dear ImGui was started before it, and must then end before Dear ImGui does.
class Renderer {
  public:
    Renderer();
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Hands the font atlas to OpenGL: before the first frame of the interface, and again whenever
    /// the fonts were loaded anew.
    void uploadFonts();

    /// Draws `frame`, then Dear ImGui's draw data if there is any, over all of the screen.
    void draw(const ui::FrameResult& frame, const ui::Screen& screen);

    /// The same without the pictures: the panels round an empty canvas. Drivers take a while to
    /// make the programs of the pictures ready, and need not before the window shows something.
    void drawPanels(const ui::FrameResult& frame, const ui::Screen& screen);

  private:
    // One kind of thing to draw: instances of it, four corners each.
    struct Batch {
        Batch(const char* name, const char* vertexBody, const char* fragmentBody,
              std::size_t stride, std::span<const gl::InstanceAttribute> attributes);
        void draw(std::span<const std::byte> instances, std::size_t count,
                  const ui::Screen& screen);

        gl::Program program;
        gl::StreamBuffer buffer;
        gl::VertexArray vertices;
    };

    // What pictures are drawn with.
    struct Tools {
        Tools();

        Batch areas, ribbons, signs;
        gl::Program pieces;
        gl::VertexArray noVertices; // all that is drawn of pieces comes from their table
    };

    void begin(const ui::FrameResult& frame, const ui::Screen& screen);
    void drawData(); // Dear ImGui's
    void drawPicture(const ui::Picture& picture, ui::Colour behind, const ui::Screen& screen);
    void drawAreas(std::span<const ui::Area> areas, const ui::Screen& screen);
    void drawRibbons(std::span<const ui::RibbonVertex> ribbons, const ui::Screen& screen);
    void drawPieces(const ui::PieceStroke& stroke, const ui::Screen& screen);
    void drawSigns(std::span<const ui::Sign> signs, const ui::Screen& screen);

    std::optional<Tools> tools_; // once there are pictures to draw
    PieceTables tables_;
    bool panels_ = false; // Dear ImGui is drawn too
};

} // namespace splineloft::app
