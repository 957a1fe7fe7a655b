#include "core/spline/shape/self_intersect.h"

#include "core/spline/shape/arcs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace splineloft {
namespace {

// Meetings found twice, by two pairs of arcs that end there, are as near as this: in the curve's
// size, and (where it runs slowly) in u.
constexpr double placeTolerance = 1e-9;
constexpr double spotTolerance = 1e-4;

bool overlap(const Arc& a, const Arc& b, std::size_t coordinate) {
    const double slack = std::max(a.rounding, b.rounding);
    return a.least[coordinate] <= b.greatest[coordinate] + slack &&
           b.least[coordinate] <= a.greatest[coordinate] + slack;
}

/// Whether x or y runs the same way along both of two arcs that follow each other; then they have
/// only their joint in common.
bool runsThrough(const Arc& a, const Arc& b) {
    return a.runs[0] + b.runs[0] != 0 || a.runs[1] + b.runs[1] != 0;
}

/// All self-intersections of one curve.
class CrossingSearch {
  public:
    CrossingSearch(const Pieces& pieces, std::size_t most)
        : pieces_(pieces), arcs_(arcsOf(pieces)), most_(most) {
        if (arcs_.size() > 1) {
            const auto& first = arcs_.front();
            const auto& last = arcs_.back();
            const Point start = pieces.position({first.segment, first.low});
            const Point end = pieces.position({last.segment, last.high});
            for (int c = 0; c < 2; ++c) {
                size_ = std::max({size_, std::abs(start[c]), std::abs(end[c])});
            }
            closed_ = distance(start, end) <= 64 * std::numeric_limits<double>::epsilon() * size_;
        }
    }

    SelfCrossings run() {
        // Sweep from left to right: of the arcs begun, those that have not ended yet.
        std::vector<std::size_t> order(arcs_.size());
        for (std::size_t i = 0; i < order.size(); ++i) {
            order[i] = i;
        }
        std::ranges::sort(order, {}, [&](std::size_t i) { return arcs_[i].least[0]; });
        std::vector<std::size_t> open;
        for (const std::size_t i : order) {
            std::erase_if(open, [&](std::size_t k) { return !overlap(arcs_[k], arcs_[i], 0); });
            for (const std::size_t k : open) {
                if (overlap(arcs_[k], arcs_[i], 1)) {
                    meet(std::min(i, k), std::max(i, k));
                }
                if (found_.crossings.size() >= most_) {
                    found_.complete = false;
                    return finished();
                }
            }
            open.push_back(i);
        }
        return finished();
    }

  private:
    void meet(std::size_t i, std::size_t k) {
        const Arc& a = arcs_[i];
        const Arc& b = arcs_[k];
        SharedEnds shared;
        shared.secondFollows = i + 1 == k;
        shared.firstFollows = closed_ && i == 0 && k + 1 == arcs_.size();
        if (shared.secondFollows != shared.firstFollows && runsThrough(a, b)) {
            return;
        }
        const Meetings meetings = meetingsOf(a, b, shared, pieces_[0]);
        found_.complete = found_.complete && !meetings.coincide;
        for (const auto& meeting : meetings.all) {
            add(spotAt(a.segment, meeting.a), spotAt(b.segment, meeting.b));
        }
    }

    /// The spot, as the start of the later piece where it is a joint.
    Spot spotAt(std::size_t segment, double u) const {
        if (u == 1 && segment + 1 < pieces_.size()) {
            return {segment + 1, 0};
        }
        return u == 1 && closed_ ? Spot{0, 0} : Spot{segment, u};
    }

    void add(Spot a, Spot b) {
        if (std::tie(b.segment, b.u) < std::tie(a.segment, a.u)) {
            std::swap(a, b);
        }
        found_.crossings.push_back({a, b, pieces_.position(a)});
    }

    bool near(Spot a, Spot b) const {
        double along =
            std::abs(static_cast<double>(a.segment) - static_cast<double>(b.segment) + a.u - b.u);
        const auto around = static_cast<double>(pieces_.size());
        along = closed_ ? std::min(along, std::abs(around - along)) : along;
        return along <= spotTolerance;
    }

    /// In order, without those found twice.
    SelfCrossings finished() {
        auto& all = found_.crossings;
        std::ranges::sort(all, [](const SelfCrossing& p, const SelfCrossing& q) {
            return std::tie(p.a.segment, p.a.u, p.b.segment, p.b.u) <
                   std::tie(q.a.segment, q.a.u, q.b.segment, q.b.u);
        });
        std::vector<SelfCrossing> kept;
        for (const auto& crossing : all) {
            bool again = crossing.a == crossing.b; // one spot is no crossing
            for (auto k = kept.size(); k > 0 && near(kept[k - 1].a, crossing.a) && !again; --k) {
                again = near(kept[k - 1].b, crossing.b) &&
                        distance(kept[k - 1].place, crossing.place) <=
                            placeTolerance * sizeAt(crossing);
            }
            if (!again) {
                kept.push_back(crossing);
            }
        }
        all = std::move(kept);
        return std::move(found_);
    }

    /// What lengths around a crossing are compared with.
    double sizeAt(const SelfCrossing& crossing) const {
        double size = 0;
        for (const Spot spot : {crossing.a, crossing.b}) {
            const Piece piece = pieces_[spot.segment];
            for (int k = 0; k <= piece.degree; ++k) {
                size = std::max(size, distance(piece.bezierPoint(k), crossing.place));
            }
        }
        return size;
    }

    const Pieces& pieces_;
    std::vector<Arc> arcs_;
    std::size_t most_;
    double size_ = 0;
    bool closed_ = false;
    SelfCrossings found_;
};

} // namespace

SelfCrossings selfIntersections(const Pieces& pieces, std::size_t most) {
    if (pieces.empty() || pieces.dimension() != 2) {
        return {};
    }
    return CrossingSearch(pieces, most).run();
}

} // namespace splineloft
