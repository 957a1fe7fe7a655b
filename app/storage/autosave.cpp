#include "app/storage/autosave.h"

#include <algorithm>
#include <cmath>

namespace splineloft::app {
namespace {

constexpr double longestPause = 600; // seconds between tries on a disk that refuses

} // namespace

void Autosave::look(const ui::Session& session, Moment now) {
    if (folder_.empty()) {
        return;
    }
    collect(now);
    if (writer_.busy()) {
        return; // the place is in use; `patience` will ask again soon
    }
    if (session.sitting != sitting_) {
        forget();
        sitting_ = session.sitting;
    }
    if (!(session.history.settled() == seen_)) {
        seen_ = session.history.settled();
        since_ = since_.value_or(now);
        ++changes_;
    }
    if (!session.unsaved()) {
        forget();
    } else if (since_ && now >= due()) {
        write(session);
    }
}

double Autosave::patience(Moment now) const {
    return writer_.busy() ? Writer::askAgain : since_ ? secondsUntil(due(), now) : never;
}

void Autosave::adopt(std::shared_ptr<RecoverySlot> slot, const ui::Session& session) {
    writer_.wait();
    collect(Clock::now());
    forget();
    slot_ = std::move(slot);
    sitting_ = session.sitting;
    seen_ = session.history.settled();
}

void Autosave::keepNow(const ui::Session& session) {
    writer_.wait();
    look(session, Clock::now());
    if (since_) { // not due yet, or refused before
        writer_.wait();
        write(session);
    }
    writer_.wait();
}

void Autosave::end() {
    writer_.wait();
    forget();
    folder_.clear();
}

void Autosave::collect(Moment now) {
    const auto outcome = writer_.outcome();
    if (!outcome) {
        return;
    }
    if (*outcome) {
        failures_ = 0;
        notBefore_.reset();
        return;
    }
    if (failures_++ == 0) {
        complaint_ = "Unsaved work cannot be kept safe: " + outcome->refusal().message();
    }
    since_ = since_.value_or(now);
    notBefore_ = after(now, std::min(pace_.seconds * std::exp2(failures_), longestPause));
}

Moment Autosave::due() const {
    const auto usual = changes_ >= pace_.changes ? *since_ : after(*since_, pace_.seconds);
    return std::max(usual, notBefore_.value_or(usual));
}

void Autosave::forget() {
    if (slot_) {
        slot_->remove();
        slot_.reset();
    }
    since_.reset();
    changes_ = 0;
}

void Autosave::write(const ui::Session& session) {
    if (!slot_) {
        slot_ = std::make_shared<RecoverySlot>(folder_, session.path);
    }
    since_.reset();
    changes_ = 0;
    writer_.begin(
        [slot = slot_, document = session.history.settled()] { return slot->keep(document); });
}

} // namespace splineloft::app
