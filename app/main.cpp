// Splineloft: reads the command line, then opens the editor or does the one thing that was asked.
#include "app/command_line/command_line.h"
#include "app/command_line/commands.h"
#include "app/end_signal.h"
#include "app/files.h"
#include "app/image.h"
#include "app/loop.h"
#include "app/offscreen.h"
#include "app/storage/keeper.h"
#include "app/window.h"
#include "app/window_error.h"

#include <algorithm>
#include <iostream>

namespace splineloft::app {
namespace {

constexpr int refused = 1;
constexpr int wronglyCalled = 2;

int complain(const std::string& words) {
    std::cerr << "splineloft: " << words << '\n';
    return refused;
}

int openEditor(const OpenEditor& asked) {
    auto session = beginSession(asked.files);
    if (!session) {
        return complain(session.refusal().message());
    }
    const EndSignal ending(wakeWindow);
    Keeper keeper(placesFromEnvironment(), {}, &ending);
    keeper.begin(*session, asked.files);
    runEditor(*session, keeper);
    return 0;
}

/// Shows these layers and no others; says which there are where one is unknown.
std::optional<std::string> showOnly(ui::Layers& layers, const std::vector<std::string>& names) {
    for (const auto& named : ui::namedLayers) {
        layers.*named.layer = false;
    }
    for (const auto& name : names) {
        const auto found = std::ranges::find(ui::namedLayers, name, &ui::NamedLayer::name);
        if (found == ui::namedLayers.end()) {
            std::string known;
            for (const auto& named : ui::namedLayers) {
                known += (known.empty() ? "" : ", ") + std::string(named.name);
            }
            return "--show: there is no layer " + inQuotes(name) + "; right would be: " + known;
        }
        layers.*found->layer = true;
    }
    return std::nullopt;
}

/// A plot by a name that is known.
ui::Plot plotNamed(const std::string& name) {
    return static_cast<ui::Plot>(std::ranges::find(ui::plotNames, name) - ui::plotNames.begin());
}

Result<ui::Session> sessionFor(const DrawScreenshot& asked) {
    if (!asked.file) {
        return ui::Session(exampleDocument());
    }
    auto document = openDocument(*asked.file, std::cin);
    if (!document) {
        return document.refusal();
    }
    return ui::Session(std::move(*document), *asked.file);
}

int drawScreenshot(const DrawScreenshot& asked) {
    auto session = sessionFor(asked);
    if (!session) {
        return complain(session.refusal().message());
    }
    session->view.theme = asked.theme == "light" ? ui::ThemeKind::light : ui::ThemeKind::dark;
    session->view.presenting = asked.present;
    session->view.plot = plotNamed(asked.plot);
    session->view.pace = asked.pace == "length" ? Even::length : Even::parameter;
    if (!asked.show.empty()) {
        if (const auto fault = showOnly(session->view.layers, asked.show)) {
            complain(*fault);
            return wronglyCalled;
        }
    }
    const auto image = screenshot(*session, {asked.width, asked.height, asked.scale});
    const auto fault = writePng(image, asked.output);
    return fault ? complain(*fault) : 0;
}

int run(const Command& command) {
    if (const auto* editor = std::get_if<OpenEditor>(&command)) {
        return openEditor(*editor);
    }
    if (const auto* picture = std::get_if<DrawScreenshot>(&command)) {
        return drawScreenshot(*picture);
    }
    return std::get<Finished>(command).exitCode;
}

} // namespace
} // namespace splineloft::app

int main(int argc, char** argv) {
    try {
        return splineloft::app::run(
            splineloft::runCommandLine(argc, argv, {std::cin, std::cout, std::cerr}));
    } catch (const splineloft::app::WindowError& fault) {
        return splineloft::app::complain(fault.what());
    }
}
