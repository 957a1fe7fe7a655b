// A curve as it lies in the plane of the canvas: its pieces and control points there, with what it
// takes to find and draw a few of very many. While points move, only what they change is looked at.
#pragma once

#include "core/spline/live_pieces.h"
#include "core/spline/measure/nearest.h"
#include "ui/canvas/box_tree.h"
#include "ui/revisions.h"

#include <optional>
#include <span>
#include <vector>

namespace splineloft::ui {

/// Legs from one place to the next.
struct Legs {
    double length = 0; ///< of all of them
    double longest = 0;
};

/// Many places in the plane, in order, and boxes around blocks of them and of the legs that begin
/// there.
class PlacedPoints {
  public:
    PlacedPoints() = default;
    explicit PlacedPoints(std::vector<PlanePoint> places);

    std::span<const PlanePoint> places() const { return places_; }
    const BoxTree& boxes() const { return boxes_; }
    const Revisions& revisions() const { return revisions_; }
    /// The legs that begin at the places of a block.
    const Legs& legs(std::size_t block) const { return legs_[block]; }
    /// The length of all legs that begin before place number `end`.
    double way(std::size_t end) const;

    /// Puts some places elsewhere; `placeOf(i)` says where.
    template <class PlaceOf> void move(const Range& range, PlaceOf placeOf) {
        for (auto i = range.first; i < range.last; ++i) {
            places_[i] = placeOf(i);
        }
        lookAgain(range);
    }

    /// Calls `take(index, place)` for all places in some box, in order.
    template <class Take> void forEachNear(const PlaneBounds& box, Take take) const {
        boxes_.touching(box, [&](std::size_t block) {
            const Range members = boxes_.block(block);
            for (auto i = members.first; i < members.last; ++i) {
                const PlanePoint p = places_[i];
                if (p.x >= box.left && p.x <= box.right && p.y >= box.bottom && p.y <= box.top) {
                    take(i, p);
                }
            }
        });
    }

  private:
    PlaneBounds boxOf(const Range& range) const;
    Legs legsFrom(const Range& range) const;
    void lookAgain(const Range& range);

    std::vector<PlanePoint> places_;
    BoxTree boxes_;
    std::vector<Legs> legs_; // one a block
    Revisions revisions_;
};

/// How finely the pieces of a block must be drawn.
struct Detail {
    double largest = 0; ///< width or height of the largest piece's hull
    double bend = 0;    ///< the largest second difference of Bézier points
};

class PlaneStudy {
  public:
    /// Keeps a reference to `pieces`, which must stay where they are.
    PlaneStudy(const Curve& curve, const Pieces& pieces, const Axes& axes);

    /// Follows the curve, whose pieces, the same as before, now are other ones in some ranges.
    void follow(const Curve& curve, const Moves& moves, std::span<const Range> changed);

    const Axes& axes() const { return axes_; }
    const Pieces& pieces() const { return projected_ ? *projected_ : *pieces_; }
    /// Boxes around the Bézier points of pieces.
    const BoxTree& boxes() const { return boxes_; }
    const Revisions& revisions() const { return revisions_; }
    const Detail& detail(std::size_t block) const { return details_[block]; }
    /// The control points.
    const PlacedPoints& points() const { return points_; }
    /// The tips of their tangents.
    const PlacedPoints& tips() const { return tips_; }

  private:
    void placeAll(const Curve& curve);
    void project(std::span<const Range> changed);
    void measure(const Range& changed);

    Axes axes_;
    const Pieces* pieces_;
    std::optional<Pieces> projected_; // where the plane is not simply that of the curve
    BoxTree boxes_;
    std::vector<Detail> details_; // one a block
    Revisions revisions_;
    PlacedPoints points_, tips_;
};

/// As the function of the same name on pieces, by way of the boxes.
std::optional<Nearest> nearestTo(const PlaneStudy& study, PlanePoint place,
                                 double within = std::numeric_limits<double>::infinity());

} // namespace splineloft::ui
