#include "core/spline/live_pieces.h"

#include <algorithm>

namespace splineloft {
namespace {

/// The value of one coordinate at an arranged place. In place of a weight, the coordinate after the
/// last, stands one.
double coordinateAt(const Place& place, const PointsView& table, int coordinate) {
    if (coordinate >= table.dimension()) {
        return 1;
    }
    const double own = table(place.control, coordinate);
    return place.mirroredAt ? 2.0 * table(*place.mirroredAt, coordinate) - own : own;
}

/// Fills in some places of the columns.
void fillColumns(std::vector<std::vector<double>>& columns, const std::vector<Place>& places,
                 const PointsView& table, const Range& range) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
        for (auto i = range.first; i < range.last; ++i) {
            columns[c][i] = coordinateAt(places[i], table, static_cast<int>(c));
        }
    }
}

} // namespace

std::optional<Moves> movesBetween(const Curve& before, const Curve& after) {
    if (!differInPlacesAlone(before, after)) {
        return std::nullopt;
    }
    const auto width = static_cast<std::size_t>(after.points.dimension());
    return Moves{changedRows(before.points.values(), after.points.values(), width),
                 changedRows(before.tangents.values(), after.tangents.values(), width)};
}

LivePieces::LivePieces(const Spline& spline, const PointsView& points, const PointsView& tangents)
    : family_(&familyOf(spline)), closed_(spline.closed),
      arrangement_(arrangementOf(spline, points)) {
    const auto& layout = arrangement_.layout;
    const int dimension = points.dimension();
    if (arrangement_.pieces() == 0) {
        pieces_ = {layout.degree, dimension, {}, {}, layout.form};
        return;
    }
    settings_ = settingsOf(spline, arrangement_);
    const auto width = static_cast<std::size_t>(dimension) + (layout.form == Form::rational);
    const auto places = arrangement_.places.size();
    columns_.assign(width, std::vector<double>(places));
    tangentColumns_.assign(family_->usesTangents ? width : 0, std::vector<double>(places));
    fill(points, tangents, {0, places});
    const auto count = arrangement_.pieces() * bezierPointsOf(layout);
    pieces_ = {layout.degree, dimension, arrangement_.joints, std::vector<double>(count * width),
               layout.form};
    blend({0, arrangement_.pieces()});
}

/// Writes the points at some places into the columns, times their weights where there are any.
void LivePieces::fill(const PointsView& points, const PointsView& tangents, const Range& places) {
    fillColumns(columns_, arrangement_.places, points, places);
    fillColumns(tangentColumns_, arrangement_.places, tangents, places);
    for (auto& column : columns_) {
        for (auto i = places.first; i < places.last && !settings_.weights.empty(); ++i) {
            column[i] *= settings_.weights[i];
        }
    }
}

/// Blends some pieces, one coordinate after the other.
void LivePieces::blend(const Range& range) {
    const auto width = columns_.size();
    const auto count = range.size() * bezierPointsOf(arrangement_.layout);
    std::vector<double> one(count);
    std::vector<double> bezier(count * width);
    for (std::size_t c = 0; c < width; ++c) {
        const auto tangents = tangentColumns_.empty() ? std::span<const double>()
                                                      : std::span<const double>(tangentColumns_[c]);
        family_->blendCoordinates(
            inputFor<double>(closed_, arrangement_, settings_, columns_[c], tangents), range, one);
        for (std::size_t i = 0; i < count; ++i) {
            bezier[i * width + c] = one[i];
        }
    }
    pieces_.overwrite(range.first, bezier);
}

std::vector<Range> LivePieces::piecesReading(std::span<const Range> places) const {
    const auto& windows = arrangement_.windows;
    const auto window = static_cast<std::size_t>(arrangement_.layout.window);
    const auto indexOf = [&](auto found) {
        return static_cast<std::size_t>(found - windows.begin());
    };
    std::vector<Range> reading;
    for (const auto& range : places) {
        const auto least = range.first + 1 > window ? range.first + 1 - window : 0;
        reading.push_back({indexOf(std::ranges::lower_bound(windows, least)),
                           indexOf(std::ranges::lower_bound(windows, range.last))});
    }
    return merged(std::move(reading));
}

/// Takes the knots behind the first interval that has changed.
void LivePieces::moveKnots(std::span<const Range> intervals) {
    const auto lead = static_cast<std::size_t>(arrangement_.layout.lead);
    const auto all = std::span(arrangement_.knots).subspan(lead, pieces_.size() + 1);
    if (!intervals.empty()) {
        const auto first = intervals.front().first;
        const auto kept = std::min(first > lead ? first - lead : 0, all.size());
        pieces_.moveKnots(kept, all.subspan(kept));
    }
}

std::vector<Range> LivePieces::follow(const Curve& curve, const Moves& moves) {
    const bool respaced = knotsFollowPoints(curve) && !moves.points.empty();
    if (arrangement_.pieces() == 0 || !family_->isLocal ||
        (respaced && family_->spacing == Spacing::knotVector)) {
        *this = LivePieces(curve, curve.points, curve.tangents);
        return merged({{0, pieces_.size()}});
    }
    auto controls = moves.points;
    controls.insert(controls.end(), moves.tangents.begin(), moves.tangents.end());
    auto places = placesOf(arrangement_, merged(std::move(controls)));
    for (const auto& range : places) {
        fill(curve.points, curve.tangents, range);
    }
    if (respaced) {
        const auto intervals = respace(arrangement_, curve, curve.points, places);
        for (const auto& range : intervals) {
            places.push_back({range.first, range.last + 1});
        }
        moveKnots(intervals);
    }
    const auto changed = piecesReading(merged(std::move(places)));
    for (const auto& range : changed) {
        blend(range);
    }
    return changed;
}

} // namespace splineloft
