#include "app/files.h"

#include "app/command_line/commands.h"
#include "core/document/edits.h"
#include "core/formats/document_json.h"
#include "core/formats/file.h"
#include "core/formats/samples.h"

#include "example.h"

#include <filesystem>
#include <iostream>
#include <utility>

namespace splineloft::app {
namespace {

namespace fs = std::filesystem;

/// Removes what saves that were killed left in the folder of a file.
void sweepBeside(const std::string& path) {
    std::error_code failed;
    sweepStaleTemporaries(fs::absolute(path, failed).parent_path());
}

/// Adds the curves of another file's document.
void add(ui::Session& session, const Document& more, const std::string& path) {
    Document next = session.history.settled();
    next.curves.insert(next.curves.end(), more.curves.begin(), more.curves.end());
    session.apply({std::move(next), ui::Phase::commit,
                   "Add the curves of " + fs::path(path).filename().string()});
}

/// "a", or "a and 2 more".
std::string listed(const std::vector<std::string>& paths) {
    return paths.front() +
           (paths.size() > 1 ? " and " + std::to_string(paths.size() - 1) + " more" : "");
}

} // namespace

Document exampleDocument() {
    auto document = readDocument(exampleText);
    return std::move(*document);
}

Result<ui::Session> beginSession(const std::vector<std::string>& files) {
    if (files.empty()) {
        return ui::Session(exampleDocument());
    }
    std::error_code failed;
    if (!fs::exists(files.front(), failed)) {
        ui::Session session({}, files.front());
        session.view.tool = ui::Tool::pen;
        session.say(files.front() +
                    " does not exist yet: lay down points, and save it with Ctrl+S");
        return session;
    }
    auto first = openDocument(files.front(), std::cin);
    if (!first) {
        return first.refusal();
    }
    sweepBeside(files.front());
    ui::Session session(std::move(*first), files.front());
    for (std::size_t i = 1; i < files.size(); ++i) {
        const auto more = openDocument(files[i], std::cin);
        if (!more) {
            return more.refusal();
        }
        add(session, *more, files[i]);
    }
    return session;
}

std::vector<std::string> openTogether(ui::Session& session, const ui::OpenFiles& request) {
    std::vector<std::string> opened;
    std::string refused;
    for (const auto& path : request.paths) {
        auto document = openDocument(path, std::cin);
        if (!document) {
            refused += (refused.empty() ? "" : "; ") + document.refusal().message();
        } else if (opened.empty()) {
            sweepBeside(path);
            session.opened(std::move(*document), path);
            opened.push_back(path);
        } else {
            add(session, *document, path);
            opened.push_back(path);
        }
    }
    if (!opened.empty()) {
        session.say("Opened " + listed(opened));
    }
    if (!refused.empty()) {
        session.failed(refused, opened.empty() ? request.chosenIn : std::nullopt);
    }
    return opened;
}

bool saveTo(ui::Session& session, const ui::SaveFile& request) {
    const auto done = saveFile(request.path, writeDocument(session.history.settled()));
    if (done) {
        session.wasSaved(request.path);
    } else {
        session.failed(done.refusal().message(), request.chosenIn);
    }
    return static_cast<bool>(done);
}

void exportSamples(ui::Session& session, const ui::ExportSamples& request) {
    const ui::Study* study = session.active();
    if (study == nullptr) {
        return session.complain("There is no curve to take samples of.");
    }
    const EvenSamples even{static_cast<std::size_t>(request.count),
                           request.even == Even::length ? EvenSamples::In::length
                                                        : EvenSamples::In::parameter};
    const auto path = sampledPath(study->curve(), even);
    if (!path) {
        return session.failed(path.refusal().message(), request.chosenIn);
    }
    const bool json = fs::path(request.path).extension() == ".json";
    const auto done = saveFile(request.path, json ? samplesAsJson(*path) : samplesAsCsv(*path));
    if (done) {
        session.say("Exported " + std::to_string(request.count) + " samples to " + request.path);
    } else {
        session.failed(done.refusal().message(), request.chosenIn);
    }
}

} // namespace splineloft::app
