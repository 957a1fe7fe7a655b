#include "ui/travel.h"

namespace splineloft::ui {
namespace {

/// `at`, between 0 and `end`, moved by `way`; past an end, at the other end.
double wrapped(double at, double way, double end) {
    const double moved = at + way;
    return moved >= end ? 0 : moved < 0 ? end : moved;
}

} // namespace

void travel(Session& session, double part) {
    auto& view = session.view;
    const Motion motion = session.active()->motion(view.pace, view.duration);
    const double end = motion.duration();
    view.cursor = motion.spotAt(wrapped(motion.timeAt(view.cursor), part * end, end));
}

} // namespace splineloft::ui
