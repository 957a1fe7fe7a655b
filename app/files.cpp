#include "app/files.h"

#include "app/commands.h"
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

void carryOut(ui::Session& session, const ui::OpenFile& request) {
    auto document = openDocument(request.path, std::cin);
    if (!document) {
        return session.complain(document.refusal().message());
    }
    sweepBeside(request.path);
    session.opened(std::move(*document), request.path);
    session.say("Opened " + request.path);
}

void carryOut(ui::Session& session, const ui::SaveFile& request) {
    const auto done = saveFile(request.path, writeDocument(session.history.settled()));
    if (done) {
        session.wasSaved(request.path);
    } else {
        session.complain(done.refusal().message());
    }
}

void carryOut(ui::Session& session, const ui::ExportSamples& request) {
    const ui::Study* study = session.active();
    if (study == nullptr) {
        return session.complain("There is no curve to take samples of.");
    }
    const EvenSamples even{static_cast<std::size_t>(request.count),
                           request.even == Even::length ? EvenSamples::In::length
                                                        : EvenSamples::In::parameter};
    const auto path = sampledPath(study->curve(), even);
    if (!path) {
        return session.complain(path.refusal().message());
    }
    const bool json = fs::path(request.path).extension() == ".json";
    const auto done = saveFile(request.path, json ? samplesAsJson(*path) : samplesAsCsv(*path));
    if (done) {
        session.say("Exported " + std::to_string(request.count) + " samples to " + request.path);
    } else {
        session.complain(done.refusal().message());
    }
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
        Document next = session.history.settled();
        next.curves.insert(next.curves.end(), more->curves.begin(), more->curves.end());
        session.apply({std::move(next), ui::Phase::commit,
                       "Add the curves of " + fs::path(files[i]).filename().string()});
    }
    return session;
}

bool carryOutRequests(ui::Session& session) {
    for (const auto& request : std::exchange(session.requests, {})) {
        if (std::holds_alternative<ui::Quit>(request)) {
            return false;
        }
        if (const auto* open = std::get_if<ui::OpenFile>(&request)) {
            carryOut(session, *open);
        } else if (const auto* save = std::get_if<ui::SaveFile>(&request)) {
            carryOut(session, *save);
        } else if (const auto* samples = std::get_if<ui::ExportSamples>(&request)) {
            carryOut(session, *samples);
        }
    }
    // A save may lead on to what it was for.
    return session.requests.empty() || carryOutRequests(session);
}

} // namespace splineloft::app
