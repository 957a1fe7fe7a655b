// The Bézier points of curves on the graphics card: kept from frame to frame, and brought up to
// date block by block.
#pragma once

#include "app/gl.h"
#include "ui/drawing.h"

#include <cstdint>
#include <map>

namespace splineloft::app {

class PieceTables {
  public:
    /// The card's copy of a table, as it is now.
    const gl::TexelRow& upToDate(const ui::PieceTable& table);
    /// Gives up the copies that nobody has asked for since the last call.
    void forgetUnused();

  private:
    struct Copy {
        gl::TexelRow texels;
        std::uint64_t revision = 0;
        bool isUsed = false;
    };

    std::map<std::uint64_t, Copy> copies_; // by identity
};

} // namespace splineloft::app
