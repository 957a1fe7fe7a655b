#include "ui/study.h"

#include "core/document/lists.h"
#include "core/spline/algebra/bernstein.h"
#include "core/spline/problem.h"
#include "ui/canvas/viewport.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

namespace splineloft::ui {
namespace {

// More basis functions than these can neither be told apart nor drawn at once.
constexpr std::size_t mostForBlends = 256;
// A curve of more points is measured on so many of its first ones.
constexpr std::size_t fewPoints = 24;
// The joints of a longer curve are not looked at one by one.
constexpr std::size_t mostForJoints = 5000;

/// Whether two curves have the same blends: they differ at most in where their points are, and the
/// knots do not follow the points.
bool sameBlends(const Curve& a, const Curve& b) {
    return static_cast<const Spline&>(a) == b && a.points.size() == b.points.size() &&
           !knotsFollowPoints(a);
}

/// The controls that take part in a piece, in order.
std::set<std::size_t> controlsIn(std::span<const Blend> bezier) {
    std::set<std::size_t> controls;
    for (const auto& blend : bezier) {
        for (const auto& share : blend.shares()) {
            controls.insert(share.control);
        }
    }
    return controls;
}

BasisGraph graphOf(const BlendPieces& blends) {
    BasisGraph graph;
    std::map<std::size_t, BasisRun> open; // runs that reach up to the present piece
    const auto samples =
        std::clamp<std::size_t>(720 / std::max<std::size_t>(blends.size(), 1), 6, 64);
    for (std::size_t i = 0; i < blends.size(); ++i) {
        const auto bezier = blends[i];
        const auto weights = blends.weights(i);
        const auto present = controlsIn(bezier);
        for (auto run = open.begin(); run != open.end();) {
            if (present.contains(run->first)) {
                ++run;
            } else {
                graph.runs.push_back(std::move(run->second));
                run = open.erase(run);
            }
        }
        for (const auto control : present) {
            std::vector<double> coefficients;
            for (std::size_t k = 0; k < bezier.size(); ++k) {
                coefficients.push_back(bezier[k].weight(control) *
                                       (weights.empty() ? 1 : weights[k]));
            }
            auto& run = open[control];
            run.control = control;
            for (std::size_t k = 0; k <= samples; ++k) {
                const double u = static_cast<double>(k) / static_cast<double>(samples);
                const double weight = splineloft::valueAt(coefficients, u) /
                                      (weights.empty() ? 1 : splineloft::valueAt(weights, u));
                run.values.push_back({{i, u}, weight});
                graph.low = std::min(graph.low, weight);
                graph.high = std::max(graph.high, weight);
            }
        }
    }
    for (auto& [control, run] : open) {
        graph.runs.push_back(std::move(run));
    }
    return graph;
}

/// The lists that go with the first points of a curve.
void keepFirst(Curve& curve, std::size_t count) {
    curve.weights.resize(std::min(curve.weights.size(), count));
    for (auto& [key, values] : curve.local) {
        values.resize(std::min(values.size(), count));
    }
    if (!curve.knots.empty()) {
        const auto degree = static_cast<std::size_t>(layoutOf(curve).degree);
        curve.knots.resize(count + (curve.closed ? 1 : degree + 1));
        if (problemOf(curve)) { // they may leave no interval
            dropKnots(curve);
        }
    }
}

Curve firstPointsOf(const Curve& curve, std::size_t count) {
    Curve few;
    static_cast<Spline&>(few) = curve;
    few.coordinates = curve.coordinates;
    few.points = Points(curve.points.dimension());
    few.tangents = few.points;
    for (std::size_t i = 0; i < count; ++i) {
        few.points.append(curve.points.at(i));
        if (!curve.tangents.empty()) {
            few.tangents.append(curve.tangents.at(i));
        }
    }
    keepFirst(few, count);
    return few;
}

/// Sets the continuity of the whole to the least of any joint.
void takeLeastContinuity(Traits& traits) {
    traits.c = traits.g = 2;
    for (const auto& joint : traits.joints) {
        traits.c = std::min(traits.c, joint.c);
        traits.g = std::min(traits.g, joint.g);
    }
}

} // namespace

Study::Study(std::shared_ptr<const Curve> curve, Study&& earlier) : curve_(std::move(curve)) {
    if (earlier.blends_ && sameBlends(*curve_, *earlier.curve_)) {
        blends_ = earlier.blends_;
        basisGraph_ = earlier.basisGraph_;
    }
    if (earlier.pieces_) {
        if (const auto moves = movesBetween(*earlier.curve_, *curve_)) {
            follow(earlier, *moves);
        }
    }
}

void Study::follow(Study& earlier, const Moves& moves) {
    const auto before = earlier.pieces_->pieces().size();
    pieces_ = std::move(earlier.pieces_);
    const auto changed = pieces_->follow(*curve_, moves);
    if (earlier.plane_) {
        plane_ = std::move(earlier.plane_);
        plane_->follow(*curve_, moves, changed);
    }
    if (pieces_->pieces().size() == before) {
        followTraits(earlier, moves, changed);
    }
}

void Study::followTraits(Study& earlier, const Moves& moves, std::span<const Range> changed) {
    const bool blendsMoved = knotsFollowPoints(*curve_) && !moves.points.empty() &&
                             (measuredWhole() || moves.points.front().first < fewPoints);
    if (!earlier.traits_ || blendsMoved) {
        return;
    }
    traits_ = std::move(earlier.traits_);
    auto& joints = traits_->joints;
    const auto& all = pieces_->pieces();
    for (const auto& range : changed) {
        // Each piece meets others at both its ends.
        for (auto i = range.first > 0 ? range.first - 1 : 0; i < range.last; ++i) {
            if (i < joints.size()) {
                joints[i] = jointAfter(all, i);
            }
        }
        if (range.first == 0 && curve_->closed && !joints.empty()) {
            joints.back() = jointAfter(all, joints.size() - 1);
        }
    }
    if (knotsFollowPoints(*curve_)) {
        for (std::size_t i = 0; i < joints.size(); ++i) {
            joints[i].t = all.knots().knots()[i + 1];
        }
    }
    takeLeastContinuity(*traits_);
}

const Pieces& Study::pieces() const {
    if (!pieces_) {
        pieces_ = std::make_unique<LivePieces>(*curve_, curve_->points, curve_->tangents);
    }
    return pieces_->pieces();
}

const ArcLength& Study::lengths() const {
    if (!lengths_) {
        lengths_.emplace(pieces());
    }
    return *lengths_;
}

const Frames& Study::frames() const {
    if (!frames_) {
        // Measured, not declared: also where the ends of an open curve meet there is a seam.
        const bool comesBack =
            !pieces().empty() && jointAfter(pieces(), pieces().size() - 1).c >= 0;
        frames_.emplace(pieces(), lengths(), comesBack);
    }
    return *frames_;
}

Motion Study::motion(Even pace, double duration) const {
    return pace == Even::length ? Motion::evenInLength(pieces(), lengths(), duration)
                                : Motion::evenInParameter(pieces(), duration);
}

const MotionGraph& Study::motionGraph(Even pace, double duration, std::size_t columns) const {
    auto& known = motionGraph_;
    if (!known || known->pace != pace || known->duration != duration || known->columns != columns) {
        known.emplace(PlayedGraph{pace, duration, columns,
                                  MotionGraph(pieces(), motion(pace, duration), columns)});
    }
    return known->graph;
}

const PlaneStudy& Study::inPlane(const Axes& axes) const {
    if (!plane_ || !(plane_->axes() == axes)) {
        plane_ = std::make_unique<PlaneStudy>(*curve_, pieces(), axes);
    }
    return *plane_;
}

bool Study::measuredWhole() const {
    return curve_->points.size() <= mostForBlends;
}

const BlendPieces* Study::blends() const {
    if (!measuredWhole()) {
        return nullptr;
    }
    if (!blends_) {
        blends_ = std::make_shared<BlendPieces>(blendsOf(*curve_));
    }
    return blends_.get();
}

const BasisGraph& Study::basisGraph() const {
    if (!basisGraph_) {
        basisGraph_ = std::make_shared<BasisGraph>(graphOf(*blends()));
    }
    return *basisGraph_;
}

const Traits& Study::traits() const {
    if (traits_) {
        return *traits_;
    }
    if (const auto* recipes = blends()) {
        traits_ = traitsOf(*curve_, pieces(), *recipes);
        return *traits_;
    }
    const Curve few = firstPointsOf(*curve_, fewPoints);
    traits_ = traitsOf(few, piecesOf(few), blendsOf(few));
    traits_->joints.clear();
    if (curve_->points.size() <= mostForJoints) {
        traits_->joints = jointsOf(pieces(), curve_->closed);
    }
    takeLeastContinuity(*traits_);
    return *traits_;
}

bool Study::isOnCurve(std::size_t control) const {
    const auto& on = traits().onCurve;
    return control < on.size() ? on[control] : traits().throughAll;
}

void Studies::follow(const Document& document) {
    // Curves that stay keep their studies. Only then may others be made from those left over.
    std::vector<std::unique_ptr<Study>> next(document.curves.size());
    for (std::size_t i = 0; i < next.size(); ++i) {
        const auto known = std::ranges::find(curves_, document.curves[i].curve);
        if (known != curves_.end()) { // unless the document holds the same curve twice
            next[i] = std::move(studies_[static_cast<std::size_t>(known - curves_.begin())]);
        }
    }
    for (std::size_t i = 0; i < next.size(); ++i) {
        if (!next[i]) {
            const bool hasEarlier = i < studies_.size() && studies_[i];
            const auto& curve = document.curves[i].curve;
            next[i] = hasEarlier ? std::make_unique<Study>(curve, std::move(*studies_[i]))
                                 : std::make_unique<Study>(curve);
        }
    }
    curves_.clear();
    std::ranges::transform(document.curves, std::back_inserter(curves_), &CurveEntry::curve);
    studies_ = std::move(next);
}

PlanePoint placeOf(const Studies& studies, const Axes& axes, const PointId& id) {
    const PlaneStudy& plane = studies[id.curve].inPlane(axes);
    const auto places = (id.part == Part::tangent ? plane.tips() : plane.points()).places();
    return id.index < places.size() ? places[id.index] : PlanePoint{};
}

} // namespace splineloft::ui
