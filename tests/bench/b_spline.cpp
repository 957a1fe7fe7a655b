// Many samples of clamped B-splines.
#include "tests/bench/ours.h"
#include "tests/bench/reference.h"
#include "tests/bench/rows.h"
#include "tests/bench/works.h"

namespace splineloft::bench {
namespace {

constexpr std::size_t piecesOfCurve = 64; // a power of 2: t / pieces is exact

ClampedBSpline makeClampedBSpline(int degree) {
    ClampedBSpline work{.degree = degree, .pieces = piecesOfCurve};
    const auto count = work.pieces + static_cast<std::size_t>(degree);
    work.points = Dice(9).between(2 * count, -4, 4);
    work.knots = clampedKnots(work.pieces, degree);
    for (std::size_t piece = 0; piece < work.pieces; ++piece) {
        for (std::size_t k = 0; k < work.perPiece; ++k) {
            const auto t = static_cast<long double>(piece) +
                           static_cast<long double>(k) / static_cast<long double>(work.perPiece);
            for (std::size_t c = 0; c < 2; ++c) {
                work.positions.push_back(deBoor(&work.points[c], 2, work.knots, degree, piece, t));
            }
        }
    }
    return work;
}

Trial ourBSpline(int degree) {
    const auto& work = clampedBSpline(degree);
    const auto pieces = ours::clampedBSpline(work.points, degree);
    const auto more = ours::positionsSize(pieces, work.perPiece) - work.positions.size();
    return filling<double>(
        work.positions,
        [pieces, &work](std::span<double> out) { ours::positions(pieces, work.perPiece, out); },
        more);
}

} // namespace

const ClampedBSpline& clampedBSpline(int degree) {
    static const auto cubic = makeClampedBSpline(3);
    static const auto quintic = makeClampedBSpline(5);
    return degree == 3 ? cubic : quintic;
}

void addBSpline(Contest& contest) {
    contest.rows.push_back({.id = "b-spline-3",
                            .work = "clamped cubic B-spline, 2-D double",
                            .items = piecesOfCurve * clampedBSpline(3).perPiece,
                            .peers = {"Eigen", "SISL"},
                            .goals = {TimesAsFastAs{"Eigen", 50}}});
    contest.rows.push_back({.id = "b-spline-5",
                            .work = "same, degree 5",
                            .items = piecesOfCurve * clampedBSpline(5).perPiece,
                            .peers = {"Eigen", "SISL"},
                            .goals = {TimesAsFastAs{"Eigen", 50}}});
    contest.entries.push_back({"b-spline-3", ourName, [] { return ourBSpline(3); }});
    contest.entries.push_back({"b-spline-5", ourName, [] { return ourBSpline(5); }});
}

} // namespace splineloft::bench
