// The command line, called as main calls it, for tests.
#pragma once

#include "app/command_line/command_line.h"

#include <sstream>
#include <string>
#include <vector>

namespace splineloft {

/// What one call of the program did.
struct Ran {
    Command command;
    std::string out, err;

    int exitCode() const {
        const auto* finished = std::get_if<Finished>(&command);
        return finished != nullptr ? finished->exitCode : -1;
    }
};

/// Calls the program, with `input` on its standard input.
inline Ran run(std::vector<std::string> arguments, const std::string& input = "") {
    arguments.insert(arguments.begin(), "splineloft");
    std::vector<const char*> argv;
    for (const auto& argument : arguments) {
        argv.push_back(argument.c_str());
    }
    std::istringstream in(input);
    std::ostringstream out, err;
    auto command = runCommandLine(static_cast<int>(argv.size()), argv.data(), {in, out, err});
    return {std::move(command), out.str(), err.str()};
}

/// A document of these curves.
inline std::string curves(const std::string& list) {
    return R"({"format": "splineloft", "version": 1, "curves": [)" + list + "]}";
}

} // namespace splineloft
