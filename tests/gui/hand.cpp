#include "hand.h"

#include "core/document/edits.h"
#include "core/spline/catalog.h"
#include "ui/commands.h"

#include <cmath>
#include <limits>
#include <memory>

namespace splineloft::ui {
namespace {

// Not at the window's corner, so that a mix-up of the two would show.
constexpr ScreenRect canvas{47, 31, 901, 703};

} // namespace

Points sevenPoints() {
    return {{-3.25, -1}, {-2, 1.5},     {0.25, -0.5}, {1.5, 1.125},
            {3, -1.25},  {3.625, 1.75}, {2, 2.5}};
}

Curve curveOf(std::string_view family, bool closed) {
    Curve curve;
    curve.family = family;
    completeParameters(curve);
    curve.ends = familyOf(curve).ends.front();
    curve.points = sevenPoints();
    curve.closed = closed;
    if (closed && familyOf(curve).hasHandles) {
        curve.points.erase(6);
    }
    if (familyOf(curve).usesTangents) {
        for (std::size_t i = 0; i < curve.points.size(); ++i) {
            const double turn = 1.3 * static_cast<double>(i);
            curve.tangents.append(Point{2.5 * std::cos(turn), 2 * std::sin(turn)});
        }
    }
    return curve;
}

Curve curveOf(std::string_view family, int dimension) {
    Curve curve = curveOf(family);
    const Points plane = curve.points;
    curve.points = Points(dimension);
    curve.tangents = Points(dimension);
    curve.coordinates.clear();
    for (int c = 0; c < dimension; ++c) {
        curve.coordinates.push_back("c" + std::to_string(c));
    }
    for (std::size_t i = 0; i < plane.size(); ++i) {
        Point row(dimension);
        Point tangent(dimension);
        for (int c = 0; c < dimension; ++c) {
            row[c] = c < 2 ? plane.at(i)[c] : static_cast<double>(i) - 2.5 * c;
            tangent[c] = 1 + 0.25 * c;
        }
        curve.points.append(row);
        if (familyOf(curve).usesTangents) {
            curve.tangents.append(tangent);
        }
    }
    return curve;
}

Document plain() {
    return documentOf({curveOf("cardinal")});
}

Document documentOf(std::initializer_list<Curve> curves) {
    Document document;
    for (const auto& curve : curves) {
        document = addCurve(document, curve);
    }
    return document;
}

double farthest(const Points& a, const Points& b) {
    if (a.size() != b.size()) {
        return std::numeric_limits<double>::infinity();
    }
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        most = std::max(most, distance(a.at(i), b.at(i)));
    }
    return most;
}

Hand::Hand(Document document) : session(std::move(document)) {
    session.canvas = canvas;
    session.view.camera = {{0.125, 0.25}, 100};
}

void Hand::move(PlanePoint to, Modifiers held) {
    send({PointerEvent::Kind::move, viewport().toScreen(to), Button::left, held});
}

void Hand::press(PlanePoint at, Modifiers held, int clicks) {
    send({PointerEvent::Kind::press, viewport().toScreen(at), Button::left, held, clicks});
}

void Hand::release(PlanePoint at, Modifiers held) {
    send({PointerEvent::Kind::release, viewport().toScreen(at), Button::left, held});
}

void Hand::pressOther(Button button, PlanePoint at) {
    send({PointerEvent::Kind::press, viewport().toScreen(at), button, {}});
}

void Hand::releaseOther(Button button, PlanePoint at) {
    send({PointerEvent::Kind::release, viewport().toScreen(at), button, {}});
}

void Hand::cancel() {
    send({PointerEvent::Kind::cancel, last_, Button::left, {}});
}

void Hand::click(PlanePoint at, Modifiers held) {
    move(at, held);
    press(at, held);
    release(at, held);
}

void Hand::doubleClick(PlanePoint at) {
    click(at);
    press(at, {}, 2);
    release(at);
}

void Hand::drag(PlanePoint from, PlanePoint to, Modifiers held) {
    move(from, held);
    press(from, held);
    move({from.x + 0.37, from.y - 0.61}, held);
    move({0.5 * (from.x + to.x), 0.5 * (from.y + to.y)}, held);
    move(to, held);
    release(to, held);
}

void Hand::key(Key key, Modifiers held) {
    runShortcut(session, {key, held});
    runShortcut(session, {key, held}, Strike::tap);
}

PlanePoint Hand::place(std::size_t index, std::size_t curveIndex) const {
    return controlPlaces(curve(curveIndex), session.view.axes)[index];
}

PlanePoint Hand::placeAt(Spot spot, std::size_t curveIndex) const {
    const Point p = session.studies[curveIndex].plane(session.view.axes).position(spot);
    return {p[0], p[1]};
}

int Hand::steps() const {
    History past = session.history;
    int count = 0;
    for (; past.canUndo(); past.undo()) {
        ++count;
    }
    return count;
}

void Hand::send(const PointerEvent& event) {
    last_ = event.at;
    const Situation situation{session.history.settled(), session.history.live(), session.studies,
                              viewport(), 1};
    Reaction reaction = react(session.gesture, session.view, event, situation);
    session.gesture = std::move(reaction.gesture);
    session.view = std::move(reaction.view);
    if (reaction.edit) {
        session.apply(std::move(*reaction.edit));
    }
}

} // namespace splineloft::ui
