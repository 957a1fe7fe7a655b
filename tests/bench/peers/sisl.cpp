// SISL: evaluation of B-splines (s1227), and the closest point, sought locally (s1957) or with all
// that are equally close (s1953).
#include "tests/bench/peers/peers.h"
#include "tests/bench/works.h"

#include <cstdlib>
#include <sisl.h>

namespace splineloft::bench {
namespace {

constexpr double geometricResolution = 1e-12;
constexpr double computerResolution = 1e-15;

struct Free {
    void operator()(SISLCurve* curve) const { freeCurve(curve); }
};
using CurveOfSisl = std::shared_ptr<SISLCurve>;

CurveOfSisl curveOf(const ClampedBSpline& work) {
    constexpr int polynomial = 1, plane = 2, copied = 1;
    auto knots = work.knots;
    auto points = work.points;
    return {newCurve(static_cast<int>(points.size() / 2), work.degree + 1, knots.data(),
                     points.data(), polynomial, plane, copied),
            Free{}};
}

Trial clamped(int degree) {
    const auto& work = clampedBSpline(degree);
    std::vector<double> parameters;
    for (std::size_t i = 0; i < work.pieces * work.perPiece; ++i) {
        parameters.push_back(static_cast<double>(i) / static_cast<double>(work.perPiece));
    }
    return filling<double>(work.positions,
                           [curve = curveOf(work), parameters](std::span<double> out) {
                               int interval = 0, status = 0;
                               auto* next = out.data();
                               for (const double t : parameters) {
                                   s1227(curve.get(), 0, t, &interval, next, &status);
                                   next += 2;
                               }
                           });
}

/// A local search.
double closest(SISLCurve* curve, double* place) {
    double parameter = 0, distance = 0;
    int status = 0;
    s1957(curve, place, 2, computerResolution, geometricResolution, &parameter, &distance, &status);
    return parameter;
}

/// All closest points, of which the first is taken.
double closestOfAll(SISLCurve* curve, double* place) {
    int points = 0, curves = 0, status = 0;
    double* parameters = nullptr;
    SISLIntcurve** intervals = nullptr;
    s1953(curve, place, 2, computerResolution, geometricResolution, &points, &parameters, &curves,
          &intervals, &status);
    const double parameter = points > 0 ? parameters[0] : 0;
    std::free(parameters);
    if (intervals != nullptr) {
        freeIntcrvlist(intervals, curves);
    }
    return parameter;
}

Trial nearest(double (*search)(SISLCurve*, double*)) {
    const auto& work = surroundings();
    const auto found = std::make_shared<std::vector<double>>(work.distances.size());
    return {.pass =
                [curve = curveOf(work.spline), found, places = work.places, search]() mutable {
                    for (std::size_t i = 0; i < found->size(); ++i) {
                        (*found)[i] = search(curve.get(), &places[2 * i]);
                    }
                    benchmark::ClobberMemory();
                },
            .error = [found] { return excessDistance(*found); }};
}

} // namespace

void addSisl(Contest& contest) {
    contest.entries.insert(contest.entries.end(),
                           {{"b-spline-3", "SISL", [] { return clamped(3); }},
                            {"b-spline-5", "SISL", [] { return clamped(5); }},
                            {"nearest", "SISL", [] { return nearest(closest); }},
                            {"nearest", "SISL, all", [] { return nearest(closestOfAll); }}});
}

} // namespace splineloft::bench
