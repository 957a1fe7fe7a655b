#include "core/document/history.h"

namespace splineloft {

History::History(Document document) {
    states_.push_back({std::move(document), ""});
}

void History::preview(Document next) {
    preview_ = std::move(next);
    previewing_ = true;
}

void History::cancel() {
    preview_ = {};
    previewing_ = false;
}

bool History::commit(Document next, std::string label) {
    cancel();
    if (next == settled()) {
        return false;
    }
    states_.erase(states_.begin() + static_cast<std::ptrdiff_t>(now_) + 1, states_.end());
    states_.push_back({std::move(next), std::move(label)});
    if (states_.size() > mostSteps + 1) {
        states_.pop_front();
    }
    now_ = states_.size() - 1;
    return true;
}

std::string_view History::undoLabel() const {
    return canUndo() ? std::string_view(states_[now_].label) : std::string_view();
}

std::string_view History::redoLabel() const {
    return canRedo() ? std::string_view(states_[now_ + 1].label) : std::string_view();
}

void History::undo() {
    cancel();
    if (canUndo()) {
        --now_;
    }
}

void History::redo() {
    cancel();
    if (canRedo()) {
        ++now_;
    }
}

} // namespace splineloft
