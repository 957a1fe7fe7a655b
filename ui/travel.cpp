#include "ui/travel.h"

namespace splineloft::ui {
namespace {

/// `at` moved by `way`; past an end, at the other end.
double wrapped(double at, double way, double start, double end) {
    const double moved = at + way;
    return moved >= end ? start : moved < start ? end : moved;
}

} // namespace

void travel(Session& session, double part) {
    auto& view = session.view;
    const Study& study = *session.active();
    if (view.pace == Even::length) {
        const auto& lengths = study.lengths();
        const double total = lengths.total();
        view.cursor = lengths.spotAt(wrapped(lengths.upTo(view.cursor), part * total, 0, total));
    } else {
        const auto& knots = study.pieces().knots();
        const double range = knots.end() - knots.start();
        view.cursor = knots.locate(
            wrapped(knots.parameter(view.cursor), part * range, knots.start(), knots.end()));
    }
}

} // namespace splineloft::ui
