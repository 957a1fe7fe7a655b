#include "ui/plane_study.h"

#include "ui/canvas/viewport.h"

#include <cmath>

namespace splineloft::ui {
namespace {

/// The blocks in which some members are.
Range blocksOf(const Range& members) {
    return {members.first / BoxTree::blockSize, (members.last - 1) / BoxTree::blockSize + 1};
}

PlanePoint bezierPlace(const Piece& piece, int index) {
    const auto* row = &piece.coordinates[static_cast<std::size_t>(index * piece.width())];
    const double weight = piece.weight(index);
    return {row[0] / weight, row[1] / weight};
}

PlaneBounds hullOf(const Piece& piece) {
    PlaneBounds box;
    for (int k = 0; k <= piece.degree; ++k) {
        box.include(bezierPlace(piece, k));
    }
    return box;
}

/// How long a way is. Coordinates are so small that their squares are numbers.
double lengthOf(double across, double up) {
    return std::sqrt(across * across + up * up);
}

double bendOf(const Piece& piece) {
    double bend = 0;
    for (int k = 0; k + 2 <= piece.degree; ++k) {
        const PlanePoint a = bezierPlace(piece, k);
        const PlanePoint b = bezierPlace(piece, k + 1);
        const PlanePoint c = bezierPlace(piece, k + 2);
        bend = std::max(bend, lengthOf(a.x - 2 * b.x + c.x, a.y - 2 * b.y + c.y));
    }
    return bend;
}

/// Whether a curve's pieces lie in the plane as they are.
bool isPlain(const Pieces& pieces, const Axes& axes) {
    return pieces.dimension() == 2 && axes == Axes{};
}

} // namespace

// --- points

PlacedPoints::PlacedPoints(std::vector<PlanePoint> places) : places_(std::move(places)) {
    boxes_.build(places_.size(), [this](const Range& range) { return boxOf(range); });
    legs_.resize(boxes_.blocks());
    revisions_ = Revisions(boxes_.blocks());
    lookAgain({0, places_.size()});
}

/// The box around some places, the next one, and the first one behind the last, where the leg leads
/// that closes a loop.
PlaneBounds PlacedPoints::boxOf(const Range& range) const {
    PlaneBounds box;
    for (auto i = range.first; i < range.last; ++i) {
        box.include(places_[i]);
    }
    box.include(places_[range.last % places_.size()]);
    return box;
}

Legs PlacedPoints::legsFrom(const Range& range) const {
    Legs legs;
    for (auto i = range.first; i < range.last && i + 1 < places_.size(); ++i) {
        const double leg =
            lengthOf(places_[i + 1].x - places_[i].x, places_[i + 1].y - places_[i].y);
        legs.length += leg;
        legs.longest = std::max(legs.longest, leg);
    }
    return legs;
}

void PlacedPoints::lookAgain(const Range& range) {
    if (range.size() == 0) {
        return;
    }
    revisions_.note(blocksOf(range));
    // The leg before the first of them has changed as well.
    const auto look = [&](const Range& members) {
        boxes_.update(members, [this](const Range& block) { return boxOf(block); });
        const Range blocks = blocksOf(members);
        for (auto block = blocks.first; block < blocks.last; ++block) {
            legs_[block] = legsFrom(boxes_.block(block));
        }
    };
    look({range.first > 0 ? range.first - 1 : 0, range.last});
    if (range.first == 0) {
        look({places_.size() - 1, places_.size()});
    }
}

double PlacedPoints::way(std::size_t end) const {
    const auto whole = std::min(end, places_.size()) / BoxTree::blockSize;
    double way = 0;
    for (std::size_t block = 0; block < whole; ++block) {
        way += legs_[block].length;
    }
    return way + legsFrom({whole * BoxTree::blockSize, std::min(end, places_.size())}).length;
}

// --- the plane

PlaneStudy::PlaneStudy(const Curve& curve, const Pieces& pieces, const Axes& axes)
    : axes_(axes), pieces_(&pieces) {
    if (!isPlain(pieces, axes)) {
        projected_ = flattened(pieces, axes);
    }
    placeAll(curve);
    boxes_.build(pieces.size(), [](const Range&) { return PlaneBounds(); });
    details_.resize(boxes_.blocks());
    revisions_ = Revisions(boxes_.blocks());
    measure({0, pieces.size()});
}

void PlaneStudy::placeAll(const Curve& curve) {
    points_ = PlacedPoints(controlPlaces(curve, axes_));
    const CurvePlaces places(curve, axes_);
    std::vector<PlanePoint> tips;
    for (std::size_t i = 0; i < curve.tangents.size(); ++i) {
        tips.push_back(places.tangentTip(i));
    }
    tips_ = PlacedPoints(std::move(tips));
}

void PlaneStudy::follow(const Curve& curve, const Moves& moves, std::span<const Range> changed) {
    const bool isGraph = curve.points.dimension() == 1;
    if (pieces_->size() != boxes_.count() || (isGraph && knotsFollowPoints(curve))) {
        *this = PlaneStudy(curve, *pieces_, axes_); // everything is elsewhere
        return;
    }
    const CurvePlaces places(curve, axes_);
    for (const auto& range : moves.points) {
        points_.move(range, [&](std::size_t i) { return places.point(i); });
    }
    auto moved = tips_.places().empty() ? std::vector<Range>() : moves.points;
    moved.insert(moved.end(), moves.tangents.begin(), moves.tangents.end());
    for (const auto& range : merged(std::move(moved))) {
        tips_.move(range, [&](std::size_t i) { return places.tangentTip(i); });
    }
    project(changed);
    for (const auto& range : changed) {
        measure(range);
    }
}

void PlaneStudy::project(std::span<const Range> changed) {
    if (!projected_) {
        return;
    }
    for (const auto& range : changed) {
        projected_->overwrite(range.first, flattened(pieces_->part(range), axes_).bezier());
    }
    projected_->moveKnots(0, pieces_->knots().knots());
}

void PlaneStudy::measure(const Range& changed) {
    if (changed.size() == 0) {
        return;
    }
    boxes_.update(changed, [&](const Range& block) {
        PlaneBounds box;
        Detail detail;
        for (auto i = block.first; i < block.last; ++i) {
            const Piece piece = pieces()[i];
            const PlaneBounds hull = hullOf(piece);
            box.include(hull);
            detail.largest = std::max(detail.largest, hull.size());
            detail.bend = std::max(detail.bend, bendOf(piece));
        }
        details_[block.first / BoxTree::blockSize] = detail;
        return box;
    });
    revisions_.note(blocksOf(changed));
}

std::optional<Nearest> nearestTo(const PlaneStudy& study, PlanePoint place, double within) {
    std::optional<Nearest> best;
    study.boxes().nearestFirst(place, within, [&](std::size_t block) {
        const Range members = study.boxes().block(block);
        const auto found = nearestTo(study.pieces().part(members), Point{place.x, place.y}, within);
        if (found) {
            best = Nearest{{members.first + found->spot.segment, found->spot.u}, found->distance};
            within = found->distance;
        }
        return within;
    });
    return best;
}

} // namespace splineloft::ui
