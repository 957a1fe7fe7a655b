#include "ui/session.h"

#include "ui/refusal.h"
#include "ui/returned.h"
#include "ui/settings.h"

#include <algorithm>
#include <map>
#include <utility>

namespace splineloft::ui {
Session::Session(Document document, std::string file)
    : history(document), path(std::move(file)), saved_(std::move(document)) {
    tidy();
    restCursor();
}

const Study* Session::active() const {
    return view.activeCurve < studies.size() ? &studies[view.activeCurve] : nullptr;
}

/// A locked curve that an edit would change or take away, if there is one.
static const Curve* lockedVictim(const Document& before, const Document& after) {
    for (const auto& entry : before.curves) {
        const auto survives = [&entry](const CurveEntry& other) {
            return other.curve == entry.curve || *other == *entry;
        };
        if (entry.look.locked && std::ranges::none_of(after.curves, survives)) {
            return entry.curve.get();
        }
    }
    return nullptr;
}

/// Where curves have gone, by number, between documents that differ in their order alone.
static std::map<std::size_t, std::size_t> reordered(const Document& before, const Document& after) {
    std::map<std::size_t, std::size_t> moves;
    if (before.curves.size() != after.curves.size()) {
        return moves;
    }
    const auto stays = [&](std::size_t i) {
        return before.curves[i].curve == after.curves[i].curve;
    };
    std::map<const Curve*, std::size_t> places;
    for (std::size_t i = 0; i < after.curves.size(); ++i) {
        if (!stays(i)) {
            places[after.curves[i].curve.get()] = i;
        }
    }
    for (std::size_t i = 0; i < before.curves.size(); ++i) {
        const auto found = places.find(before.curves[i].curve.get());
        if (!stays(i) && found == places.end()) {
            return {}; // it was changed, or is gone
        }
        if (!stays(i)) {
            moves[i] = found->second;
        }
    }
    return moves;
}

void Session::apply(Edit edit) {
    if (edit.phase == Phase::cancel) {
        history.cancel();
        return tidy();
    }
    if (const Curve* victim = lockedVictim(history.settled(), edit.next)) {
        history.cancel();
        complain(victim->name + " is locked: open its lock in the list of curves first");
        return tidy();
    }
    if (const auto problem = problemOf(edit.next, history.live())) {
        history.cancel();
        complain(refusalOf(edit.label, *problem, edit.next));
        return tidy();
    }
    if (edit.phase == Phase::preview) {
        history.preview(std::move(edit.next));
    } else {
        const Document before = history.settled();
        history.commit(std::move(edit.next), std::move(edit.label));
        gesture = Idle{}; // the points in its hand may be gone
        followOrder(before);
    }
    tidy();
}

void Session::giveUpGesture() {
    const Situation situation{history.settled(), history.live(), studies, {view.camera, canvas}, 1};
    const PointerEvent cancel{PointerEvent::Kind::cancel, pointer, Button::left, {}};
    Reaction reaction = react(gesture, view, cancel, situation);
    gesture = Idle{};
    view = std::move(reaction.view);
    history.cancel();
    tidy();
}

void Session::undo() {
    if (history.previewing()) { // what a hand has only begun is taken back first
        return giveUpGesture();
    }
    gesture = Idle{};
    if (history.canUndo()) {
        say("Undone: " + std::string(history.undoLabel()));
    }
    const Document before = history.settled();
    history.undo();
    followStep(before);
    tidy();
}

void Session::redo() {
    gesture = Idle{};
    if (history.canRedo()) {
        say("Done again: " + std::string(history.redoLabel()));
    }
    const Document before = history.settled();
    history.redo();
    followStep(before);
    tidy();
}

void Session::leave(Departure departure) {
    if (unsaved()) {
        dialog = UnsavedQuestion{std::move(departure)};
    } else {
        leaveAnyway(departure);
    }
}

void Session::leaveAnyway(const Departure& departure) {
    dialog.reset();
    if (std::holds_alternative<StartNew>(departure)) {
        opened({}, "");
        view.tool = Tool::pen;
    } else if (const auto* files = std::get_if<GoToFiles>(&departure)) {
        if (files->paths.empty()) {
            browse(FilePurpose::open);
        } else {
            requests.emplace_back(OpenFiles{files->paths, {}});
        }
    } else if (const auto* work = std::get_if<RestoreWork>(&departure)) {
        requests.emplace_back(*work);
    } else {
        requests.emplace_back(Quit{});
    }
}

void Session::save(std::optional<Departure> then) {
    if (path.empty()) {
        browse(FilePurpose::save);
    } else {
        dialog.reset();
        requests.emplace_back(SaveFile{path, {}});
    }
    afterSave_ = std::move(then);
}

void Session::browse(FilePurpose purpose) {
    afterSave_.reset(); // of a browser that was cancelled
    FileBrowser browser;
    browser.purpose = purpose;
    std::error_code failed;
    const auto here = std::filesystem::current_path(failed);
    browser.folder = path.empty() ? here : std::filesystem::absolute(path, failed).parent_path();
    const auto stem = path.empty() ? "untitled" : std::filesystem::path(path).stem().string();
    browser.name = purpose == FilePurpose::open            ? ""
                   : purpose == FilePurpose::exportSamples ? stem + "-samples.csv"
                                                           : stem + ".json";
    browser.even = view.pace;
    // Samples need more than a name, which no system's dialog asks for.
    if (habits.systemDialogs && systemDialogsFound && purpose != FilePurpose::exportSamples) {
        dialog.reset();
        requests.emplace_back(AskForFile{std::move(browser)});
    } else {
        dialog = std::move(browser);
    }
}

void Session::present(bool on) {
    if (on == view.presenting) {
        return;
    }
    view.presenting = on;
    giveUpGesture();
    if (on) {
        view.cameraAfterwards = view.camera;
        view.cameraAfterwards->pixelsPerUnit /= scale;
    } else if (const auto before = std::exchange(view.cameraAfterwards, std::nullopt)) {
        view.camera = *before;
        view.camera.pixelsPerUnit *= scale;
    } else {
        view.fitPending = true;
    }
}

void Session::dismiss() {
    dialog.reset();
    afterSave_.reset();
}

void Session::opened(Document document, std::string file) {
    const auto kept = view;
    history = History(document);
    saved_ = std::move(document);
    path = std::move(file);
    gesture = Idle{};
    view = View{};
    keepRemembered(kept, view);
    view.presenting = kept.presenting;
    ++sitting;
    tidy();
    restCursor();
}

void Session::restored(Document work, std::string file, Document inFile) {
    opened(std::move(inFile), std::move(file));
    apply({std::move(work), Phase::commit, "Restore unsaved work"});
    view.activeCurve = 0;
    restCursor();
    say("Restored " + fileName() + ": not saved yet");
}

void Session::wasSaved(std::string file) {
    saved_ = history.settled();
    path = std::move(file);
    say("Saved " + path);
    if (const auto then = std::exchange(afterSave_, std::nullopt)) {
        leaveAnyway(*then);
    }
}

void Session::failed(std::string why, std::optional<FileBrowser> chosenIn) {
    if (chosenIn && !dialog) {
        chosenIn->problem = why;
        chosenIn->overwriteAsked = false;
        chosenIn->takesKeyboard = true;
        dialog = std::move(*chosenIn);
    } else {
        afterSave_.reset();
    }
    complain(std::move(why));
}

void Session::say(std::string text) {
    log.add(text, false);
    notice = Notice{std::move(text), false};
}

void Session::complain(std::string text) {
    log.add(text, true);
    notice = Notice{std::move(text), true};
}

std::string Session::fileName() const {
    return path.empty() ? "untitled" : std::filesystem::path(path).filename().string();
}

void Session::restCursor() {
    if (const Study* study = active(); study != nullptr && !study->pieces().empty()) {
        view.cursor = {study->pieces().size() / 2, 0.6};
    }
}

void Session::followOrder(const Document& before) {
    const auto moves = reordered(before, document());
    const auto nowAt = [&moves](std::size_t curve) {
        const auto found = moves.find(curve);
        return found == moves.end() ? curve : found->second;
    };
    if (moves.empty()) {
        return;
    }
    view.activeCurve = nowAt(view.activeCurve);
    auto ids = view.selection.ids();
    for (PointId& id : ids) {
        id.curve = nowAt(id.curve);
    }
    view.selection = Selection(std::move(ids));
}

void Session::followStep(const Document& before) {
    followOrder(before);
    const auto& was = before.curves;
    const auto& is = document().curves;
    view.selection.eraseIf([&](const PointId& id) {
        return was.size() != is.size() ||
               was[id.curve]->points.size() != is[id.curve]->points.size();
    });
    const Returned back = returned(before, document());
    if (!back.points.empty()) {
        view.selection = Selection(back.points);
        view.activeCurve = back.curve.value_or(back.points.front().curve);
    }
}

void Session::tidy() {
    const Document& shown = document();
    studies.follow(shown);
    view.activeCurve =
        std::min(view.activeCurve, shown.curves.empty() ? 0 : shown.curves.size() - 1);
    const auto gone = [&](const PointId& id) {
        if (id.curve >= shown.curves.size()) {
            return true;
        }
        const auto& entry = shown.curves[id.curve];
        const auto& list = id.part == Part::tangent ? entry->tangents : entry->points;
        return id.index >= list.size() || !entry.look.isTouchable();
    };
    view.selection.eraseIf(gone);
    if (view.hovered && gone(*view.hovered)) {
        view.hovered.reset();
    }
    if (view.exactEntry && gone(*view.exactEntry)) {
        view.exactEntry.reset();
    }
    if (view.renaming && view.renaming->curve >= shown.curves.size()) {
        view.renaming.reset();
    }
    view.ghost.reset();
    const Study* study = active();
    const auto pieces = study != nullptr ? study->pieces().size() : 0;
    if (view.cursor.segment >= pieces) {
        view.cursor = pieces > 0 ? Spot{pieces - 1, 1} : Spot{};
    }
}

} // namespace splineloft::ui
