#include "core/spline/continuity.h"

#include "core/spline/digits.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace splineloft {
namespace {

// What counts as no jump, relative to the size of the two pieces. Rounding leaves about 1e-15; a
// jump that a person could ever see or hear is far above.
constexpr double positionTolerance = 1e-10;
constexpr double derivativeTolerance = 1e-9;
constexpr double directionTolerance = 1e-8; // radians
constexpr double curvatureTolerance = 1e-7; // relative to the larger curvature

/// One side of a joint.
struct Side {
    Point position, first, second; // derivatives by u, which do not depend on the unit of t
    Point direction;               // unit tangent; its limit where the speed is zero
    Point curvature;               // curvature vector
    double speed = 0;
    double interval = 1;
    double size = 0;                          // extent of the piece
    double farthest = 0;                      // largest coordinate, which sets the rounding
    bool moving = false;                      // the speed is not zero
    double turnNoise = 0, curvatureNoise = 0; // what rounding of the Bézier points leaves of a jump
};

/// Rounding of a Bézier point whose coordinates are as large as `farthest`.
double roundingAt(double farthest) {
    return 64 * std::numeric_limits<double>::epsilon() * farthest;
}

/// The direction in which a piece leaves its start or reaches its end: toward the first Bézier
/// point that differs from the end itself by more than rounding.
Point limitDirection(const Piece& piece, bool atEnd, double rounding) {
    const Point end = piece.bezierPoint(atEnd ? piece.degree : 0);
    for (int k = 1; k <= piece.degree; ++k) {
        const Point toward = piece.bezierPoint(atEnd ? piece.degree - k : k) - end;
        if (norm(toward) > rounding) {
            return unitVector(atEnd ? -1.0 * toward : toward);
        }
    }
    return Point(piece.dimension);
}

Side sideOf(const Pieces& pieces, std::size_t segment, bool atEnd) {
    const Piece piece = pieces[segment];
    const Jet jet = pieces.jet({segment, atEnd ? 1.0 : 0.0});
    Side side{jet.position, jet.first, jet.second, {}, Point(piece.dimension)};
    const double interval = pieces.knots().interval(segment);
    side.interval = interval > 0 ? interval : 1;
    for (int i = 0; i <= piece.degree; ++i) {
        const Point p = piece.bezierPoint(i);
        side.size = std::max(side.size, distance(p, jet.position));
        side.farthest = std::max(side.farthest, norm(p));
    }
    side.speed = norm(jet.first);
    const double rounding = roundingAt(side.farthest);
    side.moving = side.speed > derivativeTolerance * side.size + piece.degree * rounding;
    side.direction = side.moving ? unitVector(jet.first) : limitDirection(piece, atEnd, rounding);
    if (side.moving) {
        const Point across = jet.second - dot(jet.second, side.direction) * side.direction;
        side.curvature = (1 / side.speed) * ((1 / side.speed) * across);
        if (!std::isfinite(norm(side.curvature))) { // too slow for a curvature that is a number
            side.curvature = Point(piece.dimension);
            side.moving = false;
            return side;
        }
        // The derivatives are differences of Bézier points, times the degree each time.
        const double perSpeed = piece.degree / side.speed;
        side.turnNoise = rounding * perSpeed;
        side.curvatureNoise = rounding * perSpeed * (perSpeed + 2 * norm(side.curvature));
    }
    return side;
}

/// Angle between two unit vectors, exact for small ones too.
double angleBetween(const Point& a, const Point& b) {
    return 2 * std::atan2(norm(a - b), norm(a + b));
}

/// Numbers beyond the largest double are that.
double atMostLargest(double value) {
    return std::min(value, std::numeric_limits<double>::max());
}

Joint compare(const Side& before, const Side& after, int degree) {
    Joint joint;
    joint.gap = distance(before.position, after.position);
    // Derivatives by the shorter interval are within those by u, whatever the unit of t is.
    const double h = std::min(before.interval, after.interval);
    const double stepBefore = h / before.interval, stepAfter = h / after.interval;
    const double firstJump = distance(stepBefore * before.first, stepAfter * after.first);
    const double secondJump =
        distance(stepBefore * (stepBefore * before.second), stepAfter * (stepAfter * after.second));
    joint.firstJump = atMostLargest(firstJump / h);
    joint.secondJump = atMostLargest(secondJump / h / h);
    joint.turn = angleBetween(before.direction, after.direction);
    joint.curvatureJump = distance(before.curvature, after.curvature);
    const bool bothMove = before.moving && after.moving;
    joint.atRest = !(before.moving && after.moving);
    joint.mayBeMore = degree > 3;
    joint.speedRatio =
        bothMove ? atMostLargest(stepAfter * after.speed / (stepBefore * before.speed)) : 1;

    const double size = std::max(before.size, after.size);
    const double rounding = roundingAt(std::max(before.farthest, after.farthest));
    const bool meets = joint.gap <= positionTolerance * size + rounding;
    const double slack = derivativeTolerance * size + rounding;
    const bool sameFirst = firstJump / degree <= slack;
    const bool sameSecond = secondJump / degree / degree <= slack;
    joint.c = !meets ? -1 : !sameFirst ? 0 : !sameSecond ? 1 : 2;

    const double angle = size > 0 ? rounding / size : 0;
    const bool sameWay =
        joint.turn <= directionTolerance + angle + before.turnNoise + after.turnNoise;
    const double bend = std::max(norm(before.curvature), norm(after.curvature));
    const bool sameBend = joint.curvatureJump <= curvatureTolerance * bend +
                                                     (size > 0 ? derivativeTolerance / size : 0) +
                                                     before.curvatureNoise + after.curvatureNoise;
    joint.g = !meets ? -1 : !sameWay ? 0 : !bothMove || !sameBend ? 1 : 2;
    return joint;
}

/// By t a jump may be too small or too large for a number, though it is one by u.
std::string jumps(double by) {
    return by > 0 && by < std::numeric_limits<double>::max()
               ? "jumps by " + threeDigits(by)
               : "jumps by " + std::string(by > 0 ? "more" : "less") + " than any number";
}

/// How the speed changes: as a factor, or in percent where the factor would read as 1.
std::string speedWords(const Joint& joint) {
    const double percent = 100 * (joint.speedRatio - 1);
    if (std::abs(percent) >= 1) {
        return "the speed changes by the factor " + threeDigits(joint.speedRatio);
    }
    return percent == 0 || joint.atRest
               ? "the first derivative " + jumps(joint.firstJump)
               : "the speed " + std::string(percent > 0 ? "grows" : "falls") + " by " +
                     threeDigits(std::abs(percent)) + " %";
}

} // namespace

Joint jointAfter(const Pieces& pieces, std::size_t before) {
    const auto after = (before + 1) % pieces.size();
    Joint joint =
        compare(sideOf(pieces, before, true), sideOf(pieces, after, false), pieces.degree());
    joint.t = pieces.knots().knots()[before + 1];
    joint.before = before;
    joint.after = after;
    return joint;
}

std::vector<Joint> jointsOf(const Pieces& pieces, bool closed) {
    std::vector<Joint> joints;
    for (std::size_t i = 0; i + (closed ? 0 : 1) < pieces.size(); ++i) {
        joints.push_back(jointAfter(pieces, i));
    }
    return joints;
}

std::string describe(const Joint& joint) {
    const std::string degrees = threeDigits(joint.turn * 180 / std::numbers::pi) + "°";
    const std::string speed = speedWords(joint);
    const std::string second = "the second derivative " + jumps(joint.secondJump);
    if (joint.c < 0) {
        return "broken: a gap of " + threeDigits(joint.gap);
    }
    if (joint.g == 0) {
        const bool back = std::numbers::pi - joint.turn < directionTolerance;
        const std::string way = back ? "turns back" : "turns by " + degrees;
        const std::string rest = joint.c == 2 ? "C², at rest: " : "C¹, at rest: ";
        return joint.c == 0 ? "C⁰, a corner: the direction " + way : rest + "then the curve " + way;
    }
    if (joint.c == 2) {
        return joint.g == 2 || !joint.atRest
                   ? joint.mayBeMore ? "at least C²" : "C²"
                   : "C², at rest: the curve stops here and goes on the same way";
    }
    if (joint.g == 2) {
        return joint.c == 1 ? "G², not C²: " + second : "G², not C¹: " + speed;
    }
    return joint.c == 1 ? "C¹: " + second
                        : "G¹, not C¹: " + speed + ", the curvature jumps by " +
                              threeDigits(joint.curvatureJump);
}

bool readAlike(const Joint& a, const Joint& b) {
    const auto isSmooth = [](const Joint& joint) {
        return joint.c == 2 && joint.g == 2 && !joint.atRest;
    };
    if (isSmooth(a) && isSmooth(b)) {
        return a.mayBeMore == b.mayBeMore;
    }
    return a.c == b.c && a.g == b.g && describe(a) == describe(b);
}

} // namespace splineloft
