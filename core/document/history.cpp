#include "core/document/history.h"

#include <algorithm>

namespace splineloft {
namespace {

std::size_t bytesOf(const Curve& curve) {
    std::size_t numbers = curve.points.values().size() + curve.tangents.values().size() +
                          curve.knots.size() + curve.weights.size();
    for (const auto& [key, values] : curve.local) {
        numbers += values.size();
    }
    return sizeof(Curve) + numbers * sizeof(double);
}

/// Bytes of the curves that a document does not share with the one before it.
std::size_t newBytes(const Document& document, const Document& before) {
    std::size_t bytes = 0;
    for (const auto& entry : document.curves) {
        if (std::ranges::find(before.curves, entry.curve, &CurveEntry::curve) ==
            before.curves.end()) {
            bytes += bytesOf(*entry);
        }
    }
    return bytes;
}

} // namespace

History::History(Document document, std::size_t mostBytes) : mostBytes_(mostBytes) {
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
    while (states_.size() > now_ + 1) {
        bytes_ -= states_.back().bytes;
        states_.pop_back();
    }
    const auto bytes = newBytes(next, settled());
    states_.push_back({std::move(next), std::move(label), bytes});
    bytes_ += bytes;
    forgetOldest();
    now_ = states_.size() - 1;
    return true;
}

void History::forgetOldest() {
    while (states_.size() > mostSteps + 1 || (bytes_ > mostBytes_ && states_.size() > 2)) {
        states_.pop_front();
        bytes_ -= states_.front().bytes; // it has become the one that has nothing before it
        states_.front().bytes = 0;
    }
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
