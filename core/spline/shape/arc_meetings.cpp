// Two arcs are halved together, level by level. A pair of stretches is done with when a line parts
// them, when they cross at an angle, or when they are too small to be told apart.
#include "core/spline/shape/arcs.h"
#include "core/spline/shape/subdivide.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <optional>

namespace splineloft {
namespace {

// Size, relative to the arcs, below which stretches that still run along each other touch: the
// distance of curves that touch there is about its square, which is rounding. Of a short arc beside
// a long one it is that of the long one, as long as a touch is found so near.
constexpr double smallest = 0x1p-26;
constexpr double nearby = 1e-2;
// Pairs alive at once: stretches that coincide double them with every level.
constexpr std::size_t mostAlive = 160;
// Pairs looked at altogether; a crossing takes about a hundred, a touch some hundreds.
constexpr int mostLooks = 2000;

struct Vec {
    double x = 0, y = 0;
};
Vec operator-(Vec a, Vec b) {
    return {a.x - b.x, a.y - b.y};
}
double cross(Vec a, Vec b) {
    return a.x * b.y - a.y * b.x;
}
double dot(Vec a, Vec b) {
    return a.x * b.x + a.y * b.y;
}
Vec vecOf(const Point& p) {
    return {p[0], p[1]};
}

/// A part of an arc, with what is asked of it again and again.
struct Stretch {
    std::vector<double> bezier;
    double low = 0, high = 1; // of the arc
    std::vector<Vec> places;  // of the Bézier points
    double size = 0;
    // All directions lie between these two, less than half a turn apart, if there are such.
    bool hasCone = false;
    Vec right, left;
    int halves = -1; // index of the first half
};

Stretch stretchFrom(std::vector<double> bezier, double low, double high, const Piece& shape) {
    Stretch s;
    s.bezier = std::move(bezier);
    s.low = low;
    s.high = high;
    s.places.reserve(static_cast<std::size_t>(shape.degree) + 1);
    const auto width = static_cast<std::size_t>(shape.width());
    for (std::size_t i = 0; i < s.bezier.size(); i += width) {
        const double weight = shape.form == Form::rational ? s.bezier[i + 2] : 1;
        s.places.push_back({s.bezier[i] / weight, s.bezier[i + 1] / weight});
    }
    const auto [west, east] = std::ranges::minmax(s.places, {}, &Vec::x);
    const auto [south, north] = std::ranges::minmax(s.places, {}, &Vec::y);
    s.size = std::max(east.x - west.x, north.y - south.y);
    // The legs span all directions of the curve, of a rational one too (Floater 1992).
    const Vec chord = s.places.back() - s.places.front();
    s.right = s.left = chord;
    s.hasCone = dot(chord, chord) > 0;
    for (std::size_t i = 0; i + 1 < s.places.size() && s.hasCone; ++i) {
        const Vec leg = s.places[i + 1] - s.places[i];
        if (leg.x == 0 && leg.y == 0) {
            continue;
        }
        s.hasCone = dot(leg, chord) > 0;
        s.right = cross(s.right, leg) < 0 ? leg : s.right;
        s.left = cross(s.left, leg) > 0 ? leg : s.left;
    }
    return s;
}

/// Whether the hulls lie apart along an axis.
bool apartAlong(Vec axis, const Stretch& a, const Stretch& b, double rounding) {
    const auto along = [axis](Vec p) { return dot(axis, p); };
    const auto [lowA, highA] = std::ranges::minmax(a.places, {}, along);
    const auto [lowB, highB] = std::ranges::minmax(b.places, {}, along);
    const double slack = rounding * (std::abs(axis.x) + std::abs(axis.y));
    return along(lowA) > along(highB) + slack || along(lowB) > along(highA) + slack;
}

bool apart(const Stretch& a, const Stretch& b, double rounding) {
    if (apartAlong({1, 0}, a, b, rounding) || apartAlong({0, 1}, a, b, rounding)) {
        return true;
    }
    const Vec alongA = a.places.back() - a.places.front();
    const Vec alongB = b.places.back() - b.places.front();
    return apartAlong({-alongA.y, alongA.x}, a, b, rounding) ||
           apartAlong({-alongB.y, alongB.x}, a, b, rounding);
}

/// Whether no direction of one is a direction of the other, forward or backward: then the line
/// through two common places, which has both, is impossible.
bool runApart(const Stretch& a, const Stretch& b) {
    if (!a.hasCone || !b.hasCone) {
        return false;
    }
    const double corners[] = {cross(a.right, b.right), cross(a.right, b.left),
                              cross(a.left, b.right), cross(a.left, b.left)};
    return std::ranges::all_of(corners, [](double c) { return c > 0; }) ||
           std::ranges::all_of(corners, [](double c) { return c < 0; });
}

/// One search for the meetings of two arcs.
class MeetingSearch {
  public:
    MeetingSearch(const Arc& a, const Arc& b, SharedEnds shared, const Piece& shape)
        : shape_(shape), shared_(shared), rounding_(std::max(a.rounding, b.rounding)) {
        pool_.push_back(stretchFrom(a.bezier, 0, 1, shape));
        pool_.push_back(stretchFrom(b.bezier, 0, 1, shape));
        const auto [small, large] = std::minmax(pool_[0].size, pool_[1].size);
        const double close = std::sqrt(rounding_ * large);
        tiny_ = std::max({smallest * small, 4 * rounding_, std::min(close, nearby * small)});
    }

    Meetings run() {
        std::vector<Pair> alive = {{0, 1}};
        while (!alive.empty()) {
            if (alive.size() > mostAlive || meetings_.looks > mostLooks) {
                return {{}, true, meetings_.looks};
            }
            meetings_.looks += static_cast<int>(alive.size());
            std::vector<Pair> next;
            for (const Pair pair : alive) {
                look(pair, next);
            }
            alive = std::move(next);
        }
        return meetings_;
    }

  private:
    struct Pair {
        int a, b;
    };

    Stretch& at(int index) { return pool_[static_cast<std::size_t>(index)]; }

    void look(Pair pair, std::vector<Pair>& next) {
        const Stretch& a = at(pair.a);
        const Stretch& b = at(pair.b);
        if (apart(a, b, rounding_)) {
            return;
        }
        const bool sharing = (shared_.secondFollows && a.high == 1 && b.low == 0) ||
                             (shared_.firstFollows && a.low == 0 && b.high == 1);
        if (runApart(a, b)) {
            if (sharing) {
                return; // they meet there, and nowhere else
            }
            if (const auto found = crossing(a, b)) {
                meetings_.all.push_back(*found);
                return;
            }
        }
        const double size = std::max(a.size, b.size);
        if (size <= tiny_) {
            if (sharing || besideSharedEnd(a, b)) {
                return;
            }
            const Meeting about{0.5 * (a.low + a.high), 0.5 * (b.low + b.high)};
            if (const auto touch = parallelPlace(about)) {
                addTouch(*touch);
                return;
            }
            if (size <= 4 * rounding_) { // where an arc starts at rest, no step leads anywhere
                addTouch(about);
                return;
            }
        }
        if (a.size >= b.size) {
            const int half = halvesOf(pair.a);
            next.push_back({half, pair.b});
            next.push_back({half + 1, pair.b});
        } else {
            const int half = halvesOf(pair.b);
            next.push_back({pair.a, half});
            next.push_back({pair.a, half + 1});
        }
    }

    /// Around an end that they share, arcs of the same direction are closer than rounding.
    bool besideSharedEnd(const Stretch& a, const Stretch& b) {
        const auto near = [&](Vec end) {
            const Vec way = a.places.front() - end;
            const Vec other = b.places.front() - end;
            constexpr double beside = 1e-5; // of the arcs; closeness of degree 3 still shows
            const double reach = beside * std::max(pool_[0].size, pool_[1].size);
            return std::hypot(way.x, way.y) <= reach && std::hypot(other.x, other.y) <= reach;
        };
        return (shared_.secondFollows && near(pool_[0].places.back())) ||
               (shared_.firstFollows && near(pool_[0].places.front()));
    }

    int halvesOf(int index) {
        if (at(index).halves < 0) {
            const Stretch& whole = at(index);
            Piece piece = shape_;
            piece.coordinates = whole.bezier;
            Halves halves = halved(piece, 0.5);
            const double middle = 0.5 * (whole.low + whole.high);
            Stretch before = stretchFrom(std::move(halves.before), whole.low, middle, shape_);
            Stretch after = stretchFrom(std::move(halves.after), middle, whole.high, shape_);
            at(index).halves = static_cast<int>(pool_.size());
            pool_.push_back(std::move(before));
            pool_.push_back(std::move(after));
        }
        return at(index).halves;
    }

    /// The one crossing of two stretches by Newton's steps, if these arrive inside of both and the
    /// angle between them is large enough, among rounding, to say where.
    std::optional<Meeting> crossing(const Stretch& a, const Stretch& b) const {
        constexpr double outside = 1e-9; // of a stretch: ends are met by both neighbours
        constexpr double unsure = 1e-3;  // of a stretch
        Piece first = shape_, second = shape_;
        first.coordinates = a.bezier;
        second.coordinates = b.bezier;
        double u = 0.5, v = 0.5;
        for (int steps = 0; steps < 14; ++steps) {
            const Jet jetA = first.jet(u);
            const Jet jetB = second.jet(v);
            const Vec gap = vecOf(jetB.position) - vecOf(jetA.position);
            const Vec alongA = vecOf(jetA.first);
            const Vec alongB = vecOf(jetB.first);
            const double turn = cross(alongA, alongB);
            const double speed =
                std::max(std::hypot(alongA.x, alongA.y), std::hypot(alongB.x, alongB.y));
            if (!(rounding_ * speed < unsure * std::abs(turn))) {
                return std::nullopt;
            }
            if (std::hypot(gap.x, gap.y) <= 0.25 * rounding_) {
                break;
            }
            u = std::clamp(u + cross(gap, alongB) / turn, -0.5, 1.5);
            v = std::clamp(v + cross(gap, alongA) / turn, -0.5, 1.5);
        }
        const auto inside = [](double x) { return x >= -outside && x <= 1 + outside; };
        if (!inside(u) || !inside(v)) {
            return std::nullopt;
        }
        u = std::clamp(u, 0.0, 1.0);
        v = std::clamp(v, 0.0, 1.0);
        if (distance(first.position(u), second.position(v)) > rounding_) {
            return std::nullopt;
        }
        return Meeting{std::lerp(a.low, a.high, u), std::lerp(b.low, b.high, v)};
    }

    /// Many pairs of tiny stretches lie around one touch.
    void addTouch(const Meeting& touch) {
        constexpr double same = 1e-6; // of the arcs
        const bool known = std::ranges::any_of(meetings_.all, [&](const Meeting& m) {
            return std::abs(m.a - touch.a) <= same && std::abs(m.b - touch.b) <= same;
        });
        if (!known) {
            meetings_.all.push_back(touch);
        }
    }

    /// Where the tangents are parallel and the way between square to them, by Newton's steps; if
    /// the arcs meet there.
    std::optional<Meeting> parallelPlace(const Meeting& about) const {
        Piece first = shape_, second = shape_;
        first.coordinates = pool_[0].bezier;
        second.coordinates = pool_[1].bezier;
        Meeting at = about;
        for (int steps = 0;; ++steps) {
            const Jet a = first.jet(at.a);
            const Jet b = second.jet(at.b);
            const Vec gap = vecOf(b.position) - vecOf(a.position);
            if (steps == 6) {
                return isNear(at, about) ? touchOnArcs(at, first, second) : std::nullopt;
            }
            const Vec a1 = vecOf(a.first), a2 = vecOf(a.second);
            const Vec b1 = vecOf(b.first), b2 = vecOf(b.second);
            // Both cross(a1, b1) and dot(gap, a1) shall be zero.
            const double turn = cross(a1, b1), turnByA = cross(a2, b1), turnByB = cross(a1, b2);
            const double slip = dot(gap, a1);
            const double slipByA = dot(gap, a2) - dot(a1, a1), slipByB = dot(b1, a1);
            const double determinant = turnByA * slipByB - turnByB * slipByA;
            at.a -= (turn * slipByB - turnByB * slip) / determinant;
            at.b -= (turnByA * slip - turn * slipByA) / determinant;
        }
    }

    /// The touch that is on the arcs: where one ends within rounding before the parallel place,
    /// they touch in that end.
    std::optional<Meeting> touchOnArcs(Meeting at, const Piece& first, const Piece& second) const {
        const double a = std::clamp(at.a, 0.0, 1.0), b = std::clamp(at.b, 0.0, 1.0);
        if (a != at.a) {
            at = {a, b == at.b ? beside(first.position(a), second, b) : b};
        } else if (b != at.b) {
            at = {beside(second.position(b), first, a), b};
        }
        at.a = std::clamp(at.a, 0.0, 1.0);
        at.b = std::clamp(at.b, 0.0, 1.0);
        const bool meets = distance(first.position(at.a), second.position(at.b)) <= 4 * rounding_;
        return meets ? std::optional(at) : std::nullopt;
    }

    /// Where a piece passes beside a place, near u.
    static double beside(const Point& place, const Piece& piece, double u) {
        for (int steps = 0; steps < 2; ++steps) {
            const Jet jet = piece.jet(u);
            u += dot(place - jet.position, jet.first) / dot(jet.first, jet.first);
        }
        return u;
    }

    /// Whether a search went no farther than it should.
    static bool isNear(const Meeting& found, const Meeting& about) {
        constexpr double far = 10 * nearby;
        return std::abs(found.a - about.a) <= far && std::abs(found.b - about.b) <= far;
    }

    const Piece& shape_;
    SharedEnds shared_;
    double rounding_;
    double tiny_ = 0;
    std::deque<Stretch> pool_;
    Meetings meetings_;
};

} // namespace

Meetings meetingsOf(const Arc& a, const Arc& b, SharedEnds shared, const Piece& shape) {
    Meetings meetings = MeetingSearch(a, b, shared, shape).run();
    for (auto& meeting : meetings.all) {
        meeting = {std::lerp(a.low, a.high, meeting.a), std::lerp(b.low, b.high, meeting.b)};
    }
    return meetings;
}

} // namespace splineloft
