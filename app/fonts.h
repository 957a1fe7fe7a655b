// Finding the files of the typeface on this system.
#pragma once

#include "ui/frame.h"

namespace splineloft::app {

/// The files of DejaVu Sans, regular and bold, or of the sans-serif typeface nearest to it that has
/// Greek letters. Throws WindowError when the system has none.
ui::Fonts findFonts();

} // namespace splineloft::app
