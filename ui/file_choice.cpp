#include "ui/file_choice.h"

namespace splineloft::ui {
namespace {

namespace fs = std::filesystem;

Request requestFor(const FileBrowser& browser, const fs::path& path) {
    switch (browser.purpose) {
    case FilePurpose::open: return OpenFiles{{path.string()}, browser};
    case FilePurpose::save: return SaveFile{path.string(), browser};
    case FilePurpose::exportSamples: break;
    }
    return ExportSamples{path.string(), browser.even, browser.count, browser};
}

} // namespace

fs::path chosenPath(const FileBrowser& browser) {
    fs::path path = browser.folder / browser.name;
    if (!path.has_extension() && browser.purpose != FilePurpose::open) {
        path += browser.purpose == FilePurpose::save ? ".json" : ".csv";
    }
    return path;
}

std::optional<Request> accept(FileBrowser& browser) {
    if (browser.name.empty()) {
        return std::nullopt;
    }
    const auto path = chosenPath(browser);
    std::error_code failed;
    if (fs::is_directory(path, failed)) {
        browser.folder = fs::canonical(path, failed);
        browser.name.clear();
        return std::nullopt;
    }
    if (browser.purpose != FilePurpose::open && fs::exists(path, failed) &&
        !browser.overwriteAsked) {
        browser.overwriteAsked = true;
        return std::nullopt;
    }
    return requestFor(browser, path);
}

void acceptFromSystem(Session& session, FileBrowser browser, const fs::path& path) {
    browser.folder = path.parent_path();
    browser.name = path.filename().string();
    // The dialog asks by itself, but only about the very name that was typed.
    browser.overwriteAsked = chosenPath(browser) == path;
    if (auto request = accept(browser)) {
        session.requests.push_back(std::move(*request));
    } else {
        session.dialog = std::move(browser);
    }
}

std::string nameWithFolder(const std::string& path) {
    const fs::path whole(path);
    return whole.filename().string() + "  —  " + whole.parent_path().string();
}

} // namespace splineloft::ui
