#include "core/spline/shape/self_intersect.h"

#include "core/spline/algebra/scale.h"
#include "core/spline/shape/arc_pairs.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace splineloft {
namespace {

// Meetings found twice, by two pairs of arcs that end there, are as near as this: in the curve's
// size, and (where it runs slowly) in u.
constexpr double placeTolerance = 1e-9;
constexpr double spotTolerance = 1e-4;
// Spots as near to a joint as this, in the curve's size, are the joint.
constexpr double jointTolerance = 1e-12;
// So many are found before those found twice are sorted out.
constexpr std::size_t leastRoom = 1024;
// Work, counted in boxes compared, by the time that it takes: for a pair of arcs; for one look at
// two stretches of theirs, times the square of the number of their Bézier points; and how much
// there may be altogether, a few seconds.
constexpr std::int64_t workOfAPair = 20;
constexpr std::int64_t workOfALook = 15;
constexpr std::int64_t mostWork = 600'000'000;

/// One of the two passings of a place, while they are looked for: `segment` counts only pieces that
/// get anywhere, so that spots are as far apart as their numbers.
using Passing = Spot;

double along(Passing passing) {
    return static_cast<double>(passing.segment) + passing.u;
}

/// A place passed twice, the earlier time first.
struct Found {
    Passing a, b;
    Point place;
    double from = 0, to = 0; ///< along the curve; around its seam one of them is below 0
    ArcPair arcs{};          ///< that meet there

    int jointsNamed() const { return (a.u == 0 ? 1 : 0) + (b.u == 0 ? 1 : 0); }
};

/// What lengths around a place of a piece are compared with.
double sizeAround(const Piece& piece, const Point& place) {
    double size = 0;
    for (int k = 0; k <= piece.degree; ++k) {
        size = std::max(size, distance(piece.bezierPoint(k), place));
    }
    return size;
}

/// Whether x or y runs the same way along both of two arcs that follow each other; then they have
/// only their joint in common.
bool runsThrough(const Arc& a, const Arc& b) {
    return a.runs[0] + b.runs[0] != 0 || a.runs[1] + b.runs[1] != 0;
}

/// Where one of two arcs ends that lies beside the start of the other, so that they have no more
/// than that place in common; if they do.
std::optional<Meeting> passingOn(const Arc& a, const Arc& b) {
    const double rounding = std::max(a.rounding, b.rounding);
    for (std::size_t c = 0; c < 2; ++c) {
        const bool rises = a.least[c] < b.least[c];
        const auto& lower = rises ? a : b;
        const auto& upper = rises ? b : a;
        if (a.runs[c] == 0 || b.runs[c] == 0 || lower.greatest[c] > upper.least[c] + rounding) {
            continue;
        }
        const std::size_t other = 1 - c;
        const auto acrossAt = [other](const Arc& arc, bool atEnd) {
            const bool atGreatest = arc.runs[other] == 0 || (arc.runs[other] > 0) == atEnd;
            return atGreatest ? arc.greatest[other] : arc.least[other];
        };
        const bool endA = (a.runs[c] > 0) == rises; // the end of a lies beside b
        const bool endB = (b.runs[c] > 0) != rises;
        if (std::abs(acrossAt(a, endA) - acrossAt(b, endB)) <= rounding) {
            return Meeting{endA ? a.high : a.low, endB ? b.high : b.low};
        }
    }
    return std::nullopt;
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
            closed_ = distance(start, end) <= 64 * epsilon * size_;
        }
        number_.resize(pieces.size());
        for (const auto& arc : arcs_) {
            if (moving_.empty() || moving_.back() != arc.segment) {
                number_[arc.segment] = moving_.size();
                moving_.push_back(arc.segment);
            }
        }
    }

    SelfCrossings run() {
        ArcPairs pairs(arcs_);
        while (const auto pair = pairs.next(work_)) {
            meet(pair->first, pair->second);
            if (found_.size() > room_ && !makeRoom()) {
                break;
            }
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
        work_ -= workOfAPair;
        if (overlapOf(a, b, pieces_[0])) {
            work_ -= workOfLooks(1);
            coincide_ = true;
            return;
        }
        if (const auto meeting = passingOn(a, b)) {
            add(passing(a.segment, meeting->a), passing(b.segment, meeting->b), {i, k});
            return;
        }
        const Meetings meetings = meetingsOf(a, b, shared, pieces_[0]);
        work_ -= workOfLooks(meetings.looks);
        undecided_ = undecided_ || meetings.coincide;
        for (const auto& meeting : meetings.all) {
            add(passing(a.segment, meeting.a), passing(b.segment, meeting.b), {i, k});
        }
    }

    std::int64_t workOfLooks(int looks) const {
        const std::int64_t points = pieces_.degree() + 1;
        return workOfALook * points * points * looks;
    }

    /// The start of a piece, counted among those that get anywhere. The end of a closed curve is
    /// its start.
    Passing jointAt(std::size_t number) const {
        if (number < moving_.size()) {
            return {number, 0};
        }
        return closed_ ? Passing{0, 0} : Passing{number - 1, 1};
    }

    /// The spot, as the start of the later piece where it is a joint within rounding.
    Passing passing(std::size_t segment, double u) const {
        const Piece piece = pieces_[segment];
        const std::size_t number = number_[segment];
        const Point place = piece.position(u);
        const auto isHere = [&](int end) {
            const Point joint = piece.bezierPoint(end);
            const double slack =
                jointTolerance * sizeAround(piece, joint) + 64 * epsilon * norm(joint);
            return distance(place, joint) <= slack;
        };
        if (u < spotTolerance && isHere(0)) {
            return jointAt(number);
        }
        return u > 1 - spotTolerance && isHere(piece.degree) ? jointAt(number + 1)
                                                             : Passing{number, u};
    }

    /// The spot of the curve.
    Spot spotOf(Passing passing) const {
        const bool isSeam = closed_ && passing == Passing{0, 0};
        return isSeam ? Spot{0, 0} : Spot{moving_[passing.segment], passing.u};
    }

    void add(Passing a, Passing b, ArcPair arcs) {
        if (a == b) {
            return; // one spot is no crossing
        }
        if (std::tie(b.segment, b.u) < std::tie(a.segment, a.u)) {
            std::swap(a, b);
        }
        const auto around = static_cast<double>(moving_.size());
        const bool beforeSeam = closed_ && along(b) > around - spotTolerance;
        found_.push_back({a, b, pieces_.position(spotOf(a)),
                          beforeSeam ? along(b) - around : along(a),
                          beforeSeam ? along(a) : along(b), arcs});
    }

    /// Whether two meetings of arcs are one: as exactly as each is known.
    bool same(const Found& p, const Found& q) const {
        return std::abs(p.from - q.from) <= spotTolerance &&
               std::abs(p.to - q.to) <= spotTolerance &&
               (distance(p.place, q.place) <= placeTolerance * sizeAt(q) || touchBetween(p, q));
    }

    /// Whether the branches do not come apart, beyond rounding, halfway between.
    bool touchBetween(const Found& p, const Found& q) const {
        const Jet a = pieces_.jet(spotAlong(std::midpoint(p.from, q.from)));
        const Point gap = pieces_.position(spotAlong(std::midpoint(p.to, q.to))) - a.position;
        const Point way = unitVector(a.first);
        const double rounding = 64 * epsilon * (norm(a.position) + sizeAt(q));
        return std::abs(way[0] * gap[1] - way[1] * gap[0]) <= rounding;
    }

    Spot spotAlong(double way) const {
        const auto count = static_cast<double>(moving_.size());
        way = way < 0 ? way + count : way;
        const double number = std::min(std::floor(way), count - 1);
        return {moving_[static_cast<std::size_t>(number)], way - number};
    }

    /// What lengths around a crossing are compared with.
    double sizeAt(const Found& found) const {
        return std::max(sizeAround(pieces_[spotOf(found.a).segment], found.place),
                        sizeAround(pieces_[spotOf(found.b).segment], found.place));
    }

    /// Keeps one of those found twice: the one that names a joint, where one does.
    void keepEachOnce() {
        std::ranges::sort(found_, {}, &Found::from);
        std::vector<Found> kept;
        for (auto first = found_.begin(); first != found_.end();) {
            auto last = first + 1; // of a run of neighbours along the curve
            while (last != found_.end() && last->from - (last - 1)->from <= spotTolerance) {
                ++last;
            }
            std::sort(first, last, [](const Found& p, const Found& q) { return p.to < q.to; });
            const auto ofRun = static_cast<std::ptrdiff_t>(kept.size());
            for (; first != last; ++first) {
                auto twin = kept.end();
                for (auto k = kept.end(); k != kept.begin() + ofRun && twin == kept.end();) {
                    --k;
                    if (first->to - k->to > spotTolerance) {
                        break;
                    }
                    twin = same(*k, *first) ? k : twin;
                }
                if (twin == kept.end()) {
                    kept.push_back(std::move(*first));
                } else if (first->jointsNamed() > twin->jointsNamed()) {
                    *twin = std::move(*first);
                }
            }
        }
        found_ = std::move(kept);
    }

    /// The arc itself and those before and after it, around the seam of a closed curve too.
    std::vector<std::size_t> around(std::size_t arc) const {
        const std::size_t count = arcs_.size();
        std::vector<std::size_t> result = {arc};
        if (arc + 1 < count || closed_) {
            result.push_back((arc + 1) % count);
        }
        if (arc > 0 || closed_) {
            result.push_back((arc + count - 1) % count);
        }
        return result;
    }

    /// Whether the place lies on a stretch of two arcs that coincide, where arcs that follow these
    /// meet their neighbours.
    bool amongCoinciding(const Found& found) const {
        for (const std::size_t i : around(found.arcs.first)) {
            for (const std::size_t k : around(found.arcs.second)) {
                if (i != k && overlapHolds(arcs_[i], arcs_[k], found.place)) {
                    return true;
                }
            }
        }
        return false;
    }

    bool overlapHolds(const Arc& a, const Arc& b, const Point& place) const {
        const auto overlap = overlapOf(a, b, pieces_[0]);
        if (!overlap) {
            return false;
        }
        // Neither x nor y turns back: the ends are corners of the stretch's box.
        const Point start = pieces_.position({a.segment, std::lerp(a.low, a.high, overlap->a[0])});
        const Point end = pieces_.position({a.segment, std::lerp(a.low, a.high, overlap->a[1])});
        const double slack = placeTolerance * distance(start, end) + 64 * epsilon * norm(place);
        const auto between = [&](int c) {
            return place[c] >= std::min(start[c], end[c]) - slack &&
                   place[c] <= std::max(start[c], end[c]) + slack;
        };
        return between(0) && between(1);
    }

    /// Keeps each once, and none where stretches coincide.
    void settle() {
        keepEachOnce();
        if (coincide_) {
            std::erase_if(found_, [this](const Found& found) { return amongCoinciding(found); });
        }
    }

    /// Makes room for more to be found, unless there are too many already.
    bool makeRoom() {
        settle();
        room_ = 2 * found_.size() + leastRoom;
        return found_.size() <= most_;
    }

    SelfCrossings finished() {
        settle();
        SelfCrossings result;
        for (const auto& found : found_) {
            result.crossings.push_back({spotOf(found.a), spotOf(found.b), found.place});
        }
        std::ranges::sort(result.crossings, [](const SelfCrossing& p, const SelfCrossing& q) {
            return std::tie(p.a.segment, p.a.u, p.b.segment, p.b.u) <
                   std::tie(q.a.segment, q.a.u, q.b.segment, q.b.u);
        });
        result.complete = !coincide_ && !undecided_ && work_ > 0 && found_.size() <= most_;
        result.crossings.resize(std::min(result.crossings.size(), most_));
        return result;
    }

    const Pieces& pieces_;
    std::vector<Arc> arcs_;
    std::size_t most_;
    std::size_t room_ = leastRoom; ///< for so many found, some of them twice
    double size_ = 0;
    bool closed_ = false;
    std::vector<std::size_t> moving_; ///< the pieces that get anywhere
    std::vector<std::size_t> number_; ///< of each piece among those
    std::vector<Found> found_;
    std::int64_t work_ = mostWork;
    bool coincide_ = false, undecided_ = false; ///< some arcs, and whether some do
};

} // namespace

SelfCrossings selfIntersections(const Pieces& pieces, std::size_t most) {
    if (pieces.empty() || pieces.dimension() != 2) {
        return {};
    }
    return CrossingSearch(pieces, most).run();
}

} // namespace splineloft
