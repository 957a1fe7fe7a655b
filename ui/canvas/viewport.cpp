#include "ui/canvas/viewport.h"

#include "core/document/edits.h"
#include "core/spline/algebra/bernstein.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace splineloft::ui {
namespace {

// Beyond these a double could not tell neighbouring pixels apart.
constexpr double leastPixelsPerUnit = 1e-8;
constexpr double mostPixelsPerUnit = 1e12;

/// The coordinate shown along one axis; the last one where the curve has fewer.
int shown(int axis, int dimension) {
    return std::min(axis, dimension - 1);
}

/// A curve of one coordinate over its parameter. t times the weight has one degree more than the
/// weight, so that all of it is raised by one on rational pieces.
Pieces graph(const Pieces& pieces) {
    const bool rational = pieces.form() == Form::rational;
    const int degree = std::max(pieces.degree(), 1) + (rational ? 1 : 0);
    const auto knots = pieces.knots().knots();
    std::vector<double> plane;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const Bernstein up = elevated(pieces[i].column(0), degree);
        const Bernstein weight = rational ? pieces[i].column(1) : Bernstein{1};
        const Bernstein over =
            elevated(product(weight, std::array{knots[i], knots[i + 1]}), degree);
        const Bernstein last = elevated(weight, degree);
        for (std::size_t k = 0; k < up.size(); ++k) {
            plane.insert(plane.end(), {over[k], up[k]});
            if (rational) {
                plane.push_back(last[k]);
            }
        }
    }
    return {degree, 2, pieces.knots(), std::move(plane), pieces.form()};
}

/// Two of several coordinates.
Pieces projection(const Pieces& pieces, const Axes& axes) {
    const int dimension = pieces.dimension();
    std::vector<double> plane;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const Piece piece = pieces[i];
        for (int k = 0; k <= piece.degree; ++k) {
            const auto row = piece.coordinates.subspan(static_cast<std::size_t>(k * piece.width()));
            plane.push_back(row[static_cast<std::size_t>(shown(axes.across, dimension))]);
            plane.push_back(row[static_cast<std::size_t>(shown(axes.up, dimension))]);
            if (piece.form == Form::rational) {
                plane.push_back(row[static_cast<std::size_t>(dimension)]);
            }
        }
    }
    return {pieces.degree(), 2, pieces.knots(), std::move(plane), pieces.form()};
}

} // namespace

ScreenPoint Viewport::toScreen(PlanePoint p) const {
    return {frame.left + frame.width / 2 + (p.x - camera.centre.x) * camera.pixelsPerUnit,
            frame.top + frame.height / 2 - (p.y - camera.centre.y) * camera.pixelsPerUnit};
}

PlanePoint Viewport::toPlane(ScreenPoint p) const {
    return {camera.centre.x + (p.x - frame.left - frame.width / 2) / camera.pixelsPerUnit,
            camera.centre.y - (p.y - frame.top - frame.height / 2) / camera.pixelsPerUnit};
}

PlaneBounds Viewport::boxUnder(const ScreenRect& rect) const {
    PlaneBounds box;
    box.include(toPlane(ScreenPoint{rect.left - 1, rect.top - 1}));
    box.include(toPlane(ScreenPoint{rect.right() + 1, rect.bottom() + 1}));
    return box;
}

PlaneBounds Viewport::visible(double overhang) const {
    return boxUnder({frame.left - overhang, frame.top - overhang, frame.width + 2 * overhang,
                     frame.height + 2 * overhang});
}

Camera zoomed(const Viewport& viewport, ScreenPoint at, double factor) {
    Viewport next = viewport;
    next.camera.pixelsPerUnit =
        std::clamp(viewport.camera.pixelsPerUnit * factor, leastPixelsPerUnit, mostPixelsPerUnit);
    const PlanePoint before = viewport.toPlane(at);
    const PlanePoint after = next.toPlane(at);
    next.camera.centre.x += before.x - after.x;
    next.camera.centre.y += before.y - after.y;
    return next.camera;
}

Camera panned(const Camera& camera, double dx, double dy) {
    Camera next = camera;
    next.centre.x -= dx / camera.pixelsPerUnit;
    next.centre.y += dy / camera.pixelsPerUnit;
    return next;
}

Camera fitted(PlanePoint low, PlanePoint high, const ScreenRect& frame, double margin) {
    Camera camera;
    camera.centre = {0.5 * (low.x + high.x), 0.5 * (low.y + high.y)};
    const double across = std::max(frame.width - 2 * margin, 1.0) / (high.x - low.x);
    const double up = std::max(frame.height - 2 * margin, 1.0) / (high.y - low.y);
    const double scale = std::min(across, up); // one of them is infinite for a straight line
    camera.pixelsPerUnit =
        std::isfinite(scale) ? std::clamp(scale, leastPixelsPerUnit, mostPixelsPerUnit) : 80.0;
    return camera;
}

double gridStep(const Camera& camera, double pixels) {
    const double least = pixels / camera.pixelsPerUnit;
    const double decade = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * decade >= least) {
            return factor * decade;
        }
    }
    return 10 * decade;
}

double roundedTo(double value, double step) {
    // Dividing by a whole number keeps 0.3 from becoming 3 * 0.1.
    return step < 1 ? std::round(value / step) / std::round(1 / step)
                    : std::round(value / step) * step;
}

Pieces flattened(const Pieces& pieces, const Axes& axes) {
    const int dimension = pieces.dimension();
    if (dimension == 2 && axes == Axes{}) {
        return pieces;
    }
    return dimension == 1 ? graph(pieces) : projection(pieces, axes);
}

std::vector<PlanePoint> controlPlaces(const Curve& curve, const Axes& axes) {
    const CurvePlaces all(curve, axes);
    std::vector<PlanePoint> places(curve.points.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        places[i] = all.point(i);
    }
    return places;
}

CurvePlaces::CurvePlaces(const Curve& curve, const Axes& axes)
    : curve_(curve), axes_(axes),
      across_(curve.points.dimension() == 1 ? abscissae(curve) : std::vector<double>()) {}

PlanePoint CurvePlaces::point(std::size_t index) const {
    const auto row = curve_.points[index];
    const auto at = [&](int axis) {
        return row[static_cast<std::size_t>(shown(axis, curve_.points.dimension()))];
    };
    return {across_.empty() ? at(axes_.across) : across_[index], at(axes_.up)};
}

PlanePoint CurvePlaces::tangentTip(std::size_t index) const {
    constexpr double part = 1.0 / 3;
    const auto row = curve_.tangents[index];
    const auto at = [&](int axis) {
        return row[static_cast<std::size_t>(shown(axis, curve_.points.dimension()))];
    };
    const PlanePoint from = point(index);
    // Of a graph the parameter goes on by a third of an interval.
    return {from.x + part * (across_.empty() ? at(axes_.across) : 1), from.y + part * at(axes_.up)};
}

PlanePoint PointPlaces::operator[](const PointId& id) {
    if (!places_ || curve_ != id.curve) {
        places_.emplace(*document_.curves[id.curve], axes_);
        curve_ = id.curve;
    }
    return id.part == Part::tangent ? places_->tangentTip(id.index) : places_->point(id.index);
}

Point liftedDelta(const Curve& curve, const Axes& axes, double dx, double dy) {
    const int dimension = curve.points.dimension();
    Point delta(dimension);
    if (dimension > 1) {
        delta[shown(axes.across, dimension)] += dx;
    }
    delta[shown(axes.up, dimension)] += dy;
    return delta;
}

Document movedInPlane(const Document& document, const std::vector<PointId>& ids, const Axes& axes,
                      double dx, double dy) {
    Document next = document;
    for (std::size_t i = 0; i < document.curves.size(); ++i) {
        std::vector<PointId> own;
        std::ranges::copy_if(ids, std::back_inserter(own),
                             [i](const PointId& id) { return id.curve == i; });
        next = movePoints(next, own, liftedDelta(*document.curves[i], axes, dx, dy));
    }
    return next;
}

Point lifted(const Curve& curve, const Axes& axes, Point place, PlanePoint at) {
    const int dimension = curve.points.dimension();
    if (dimension > 1) {
        place[shown(axes.across, dimension)] = at.x;
    }
    place[shown(axes.up, dimension)] = at.y;
    return place;
}

} // namespace splineloft::ui
