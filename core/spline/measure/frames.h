// Frames that go along with a curve: for whatever is carried along it, a camera, a car or a beam.
//
// Those of Frenet spin wildly where a curve is nearly straight and flip at inflections. These turn
// no more than the tangent makes them.
#pragma once

#include "core/spline/measure/length.h"
#include "core/spline/piece.h"

#include <optional>
#include <vector>

namespace splineloft {

/// Unit vectors square to each other that go along with a curve. In the plane there is one normal,
/// the tangent turned left by 90 degrees; in space there are two, and tangent, first and second
/// normal are right-handed. Curves of other dimensions have none.
struct Frame {
    Point position;
    Point tangent;
    std::vector<Point> normals;
};

/// The frames of a curve, worked out once. In space they are rotation-minimizing, by the double
/// reflection method (Wang, Jüttler, Zheng and Liu 2008), in steps that follow the bends. Around a
/// closed curve such a frame comes back twisted by some angle; that is taken back evenly along the
/// length, so that the last frame is the first. At a corner the frame is turned with the tangent by
/// the shortest way, and not at all where the tangent is reversed. Where the curve rests the
/// tangent is that of one side; a piece that does not move keeps the frame before it, those at the
/// start the one after. Keeps references to pieces and lengths. Never not-a-number.
class Frames {
  public:
    Frames(const Pieces& pieces, const ArcLength& lengths, bool closed);

    /// The frame at a spot of the curve, which has a piece.
    Frame at(Spot spot) const;
    /// The angle in radians, -pi to pi about the tangent, by which the frame of a closed curve in
    /// space would come back twisted. Zero for others.
    double twist() const { return twist_; }

  private:
    /// A frame of a piece, without its second normal.
    struct Node {
        double u;
        Point tangent, normal;
    };

    void keep(const Node& node);
    Node kept(std::size_t index) const;
    void walk(std::size_t segment, Node& at, double end, int depth);
    Node stepped(const Node& from, std::size_t segment, double u) const;
    Point tangentOn(std::size_t segment, double u, const Point& otherwise) const;
    Point startTangent() const;
    static double twistAround(const Node& start, const Node& last);

    const Pieces* pieces_;
    const ArcLength* lengths_;
    std::vector<std::size_t> moving_; ///< for each piece the last one up to it that moves
    std::vector<std::size_t> first_;  ///< of the nodes of each piece, in space; and their number
    std::vector<double> u_;           ///< of each node
    Points tangents_{3}, normals_{3};
    double twist_ = 0;
};

} // namespace splineloft
