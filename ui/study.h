// What can be known about a curve, worked out once and kept until the curve changes.
#pragma once

#include "core/spline/curve.h"
#include "core/spline/measure/frames.h"
#include "core/spline/measure/length.h"
#include "core/spline/traits.h"
#include "ui/motion_graph.h"
#include "ui/plane_study.h"

#include <memory>
#include <optional>
#include <vector>

namespace splineloft::ui {

/// One value of a basis function.
struct BasisValue {
    Spot spot;
    double weight = 0;
};

/// One control's basis function over neighbouring pieces on which it does not vanish. At a joint
/// both pieces have a value.
struct BasisRun {
    std::size_t control = 0;
    std::vector<BasisValue> values;
};

/// All basis functions, sampled finely enough to be drawn.
struct BasisGraph {
    std::vector<BasisRun> runs;
    double low = 0, high = 0; ///< least and greatest value
};

/// Everything worked out from one curve; each part when it is first asked for.
class Study {
  public:
    explicit Study(std::shared_ptr<const Curve> curve) : curve_(std::move(curve)) {}
    /// Takes over from an earlier study what still holds, and works out anew what does not: where
    /// only a few points have moved, little.
    Study(std::shared_ptr<const Curve> curve, Study&& earlier);

    const Curve& curve() const { return *curve_; }
    const Family& family() const { return familyOf(*curve_); }
    const Pieces& pieces() const;
    const ArcLength& lengths() const;
    /// The frames that go along with it.
    const Frames& frames() const;
    /// The curve as it is played in so many seconds.
    Motion motion(Even pace, double duration) const;
    /// Its course, in a plot of so many columns of pixels. The last one is kept.
    const MotionGraph& motionGraph(Even pace, double duration, std::size_t columns) const;
    /// The curve in the plane of the canvas.
    const PlaneStudy& inPlane(const Axes& axes) const;
    /// Its pieces there.
    const Pieces& plane(const Axes& axes) const { return inPlane(axes).pieces(); }
    /// The basis functions; null where the curve has too many points to show them.
    const BlendPieces* blends() const;
    /// Their graphs, where `blends` is not null.
    const BasisGraph& basisGraph() const;
    const Traits& traits() const;
    /// Whether the traits were measured on all points, or on the first few of very many.
    bool measuredWhole() const;
    /// Whether the curve passes through a control point.
    bool isOnCurve(std::size_t control) const;

  private:
    struct PlayedGraph {
        Even pace;
        double duration;
        std::size_t columns;
        MotionGraph graph;
    };

    void follow(Study& earlier, const Moves& moves);
    void followTraits(Study& earlier, const Moves& moves, std::span<const Range> changed);

    std::shared_ptr<const Curve> curve_;
    mutable std::unique_ptr<LivePieces> pieces_; // the others refer to them
    mutable std::optional<ArcLength> lengths_;
    mutable std::optional<Frames> frames_;
    mutable std::optional<PlayedGraph> motionGraph_;
    mutable std::unique_ptr<PlaneStudy> plane_;
    mutable std::shared_ptr<const BlendPieces> blends_;
    mutable std::shared_ptr<const BasisGraph> basisGraph_;
    mutable std::optional<Traits> traits_;
};

/// The studies of a document's curves. Unchanged curves keep theirs from frame to frame.
class Studies {
  public:
    /// Brings the studies up to date with a document: one for each curve, in its order.
    void follow(const Document& document);
    const Study& operator[](std::size_t curve) const { return *studies_[curve]; }
    std::size_t size() const { return studies_.size(); }

  private:
    std::vector<std::shared_ptr<const Curve>> curves_;
    std::vector<std::unique_ptr<Study>> studies_;
};

/// Where a control point or the tip of its tangent lies in the plane of the canvas; the origin
/// where there is none of that number.
PlanePoint placeOf(const Studies& studies, const Axes& axes, const PointId& id);

} // namespace splineloft::ui
