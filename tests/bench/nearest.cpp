// The nearest spot of a long curve to places all around it: what a pointer asks.
#include "tests/bench/ours.h"
#include "tests/bench/reference.h"
#include "tests/bench/rows.h"
#include "tests/bench/works.h"

#include <cmath>
#include <numbers>

namespace splineloft::bench {
namespace {

constexpr std::size_t piecesOfCurve = 1000;
constexpr std::size_t placeCount = 500;
constexpr std::size_t numbersACubic = 8;

/// Control points around a wavy ring, each a little beside it.
Coordinates wavyRing(std::size_t count, Dice& dice) {
    Coordinates points;
    for (std::size_t i = 0; i < count; ++i) {
        const double turn =
            2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
        const double radius = 1 + 0.3 * std::sin(7 * turn) + dice.between(-0.001, 0.001);
        points.push_back(radius * std::cos(turn));
        points.push_back(radius * std::sin(turn));
    }
    return points;
}

/// Distance of a place from a cubic piece at u, squared, and half of its first two derivatives.
Taylor squaredDistance(const double* cubic, const double* place, long double u) {
    Taylor sum;
    for (std::size_t c = 0; c < 2; ++c) {
        const auto b = bezier(cubic + c, 2, 3, u);
        const auto away = b.value - static_cast<long double>(place[c]);
        sum.value += away * away;
        sum.first += away * b.first;
        sum.second += b.first * b.first + away * b.second;
    }
    return sum;
}

/// Least distance from one piece: a fine search, and Newton's method from its best spot.
long double distanceFrom(const double* cubic, const double* place) {
    constexpr int steps = 64;
    long double best = std::numeric_limits<long double>::infinity();
    long double bestU = 0;
    for (int i = 0; i <= steps; ++i) {
        const auto u = static_cast<long double>(i) / steps;
        const auto here = squaredDistance(cubic, place, u).value;
        if (here < best) {
            best = here;
            bestU = u;
        }
    }
    auto u = bestU;
    for (int i = 0; i < 20; ++i) {
        const auto here = squaredDistance(cubic, place, u);
        if (here.second <= 0) {
            break;
        }
        u = std::clamp<long double>(u - here.first / here.second, 0, 1);
        best = std::min(best, squaredDistance(cubic, place, u).value);
    }
    return std::sqrt(best);
}

/// No point of the piece is nearer than the box of its Bézier points.
double distanceFromHull(const double* cubic, const double* place) {
    double sum = 0;
    for (std::size_t c = 0; c < 2; ++c) {
        const auto [low, high] = std::minmax({cubic[c], cubic[2 + c], cubic[4 + c], cubic[6 + c]});
        const double away = std::max({low - place[c], place[c] - high, 0.0});
        sum += away * away;
    }
    return std::sqrt(sum);
}

long double leastDistance(const Coordinates& pieces, const double* place) {
    long double best = std::numeric_limits<long double>::infinity();
    for (std::size_t i = 0; i < pieces.size(); i += numbersACubic) {
        if (static_cast<long double>(distanceFromHull(&pieces[i], place)) < best) {
            best = std::min(best, distanceFrom(&pieces[i], place));
        }
    }
    return best;
}

Surroundings makeSurroundings() {
    Surroundings work;
    Dice dice(8);
    work.spline.pieces = piecesOfCurve;
    work.spline.points = wavyRing(piecesOfCurve + 3, dice);
    work.spline.knots = clampedKnots(piecesOfCurve, 3);
    work.bezier = bezierOfCubicBSpline(work.spline.points, work.spline.knots);
    for (std::size_t i = 0; i < placeCount; ++i) {
        work.places.push_back(dice.between(-1.5, 1.5));
        work.places.push_back(dice.between(-1.5, 1.5));
        work.distances.push_back(leastDistance(work.bezier, &work.places[2 * i]));
    }
    return work;
}

Trial ourNearest() {
    const auto& work = surroundings();
    const auto nearest = ours::nearest(ours::clampedBSpline(work.spline.points, 3));
    const auto found = std::make_shared<std::vector<double>>(placeCount);
    return {.pass =
                [nearest, found, &work] {
                    for (std::size_t i = 0; i < placeCount; ++i) {
                        (*found)[i] = nearest(work.places[2 * i], work.places[2 * i + 1]);
                    }
                    benchmark::ClobberMemory();
                },
            .error = [found] { return excessDistance(*found); }};
}

} // namespace

const Surroundings& surroundings() {
    static const auto work = makeSurroundings();
    return work;
}

double excessDistance(const std::vector<double>& parameters) {
    const auto& work = surroundings();
    long double worst = 0;
    for (std::size_t i = 0; i < placeCount; ++i) {
        const auto piece = std::min(static_cast<std::size_t>(parameters[i]), piecesOfCurve - 1);
        const auto u = static_cast<long double>(parameters[i]) - static_cast<long double>(piece);
        const auto* place = &work.places[2 * i];
        const auto here = squaredDistance(&work.bezier[piece * numbersACubic], place, u).value;
        worst = std::max(worst, std::sqrt(here) - work.distances[i]);
    }
    constexpr long double radiusOfRing = 1.3L;
    return static_cast<double>(worst / radiusOfRing);
}

void addNearest(Contest& contest) {
    contest.rows.push_back({.id = "nearest",
                            .work = "nearest spot of 1000 pieces (a query)",
                            .items = placeCount,
                            .peers = {"SISL", "SISL, all", "lib2geom"},
                            .goals = {TimesAsFastAs{"SISL", 25}, ErrorAtMost{1e-12}}});
    contest.entries.push_back({"nearest", ourName, ourNearest});
}

} // namespace splineloft::bench
