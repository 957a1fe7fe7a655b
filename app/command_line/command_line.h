// The command line: one program that opens the editor, or does one thing without any window.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace splineloft {

/// The editor is to be opened, on these files.
struct OpenEditor {
    std::vector<std::string> files;
};

/// A picture of the editor is to be drawn into a PNG file.
struct DrawScreenshot {
    std::optional<std::string> file; ///< document to be shown; none: an example
    std::string output;
    int width = 1280; ///< of the picture, in pixels
    int height = 800;
    double scale = 1;              ///< of the interface
    std::string theme = "dark";    ///< or "light"
    std::vector<std::string> show; ///< names of layers, as they were given
    std::string plot = "basis";    ///< the name of a plot, as it was given
    std::string pace = "length";   ///< what playing is even in, or "parameter"
    bool present = false;          ///< as before an audience
};

/// All was done; the program ends with this code: 0 done, 1 input refused, 2 wrongly called.
struct Finished {
    int exitCode = 0;
};

/// What is left to do.
using Command = std::variant<OpenEditor, DrawScreenshot, Finished>;

/// Where commands read and write.
struct Streams {
    std::istream& in;
    std::ostream& out;
    std::ostream& err;
};

/// Reads the command line and carries out what needs no window. Never throws for what the user
/// wrote.
Command runCommandLine(int argc, const char* const* argv, const Streams& streams);

} // namespace splineloft
