// Points in equal steps of length: beads, travellers, dashes.
#include "tests/bench/ours.h"
#include "tests/bench/reference.h"
#include "tests/bench/rows.h"
#include "tests/bench/works.h"

#include <cmath>

namespace splineloft::bench {
namespace {

constexpr std::size_t piecesOfWalk = 8;
constexpr std::size_t numbersACubic = 8;

/// Where a cubic has the length `wanted`, by Newton's method.
long double parameterAtLength(const double* cubic, long double wanted, long double whole) {
    auto u = wanted / whole;
    for (int step = 0; step < 30; ++step) {
        const auto speed =
            std::hypot(bezier(cubic, 2, 3, u).first, bezier(cubic + 1, 2, 3, u).first);
        const auto next =
            std::clamp<long double>(u + (wanted - cubicLength(cubic, u)) / speed, 0, 1);
        if (std::abs(next - u) < 1e-17L) {
            break;
        }
        u = next;
    }
    return u;
}

EvenWalk makeEvenWalk() {
    EvenWalk work{.pieces = piecesOfWalk};
    Coordinates points; // to the right in steps of about 1, up and down by up to as much
    Dice dice(7);
    for (std::size_t i = 0; i < work.pieces + 3; ++i) {
        points.push_back(static_cast<double>(i) + dice.between(-0.25, 0.25));
        points.push_back(dice.between(-1, 1));
    }
    work.bezier = bezierOfCatmullRom(points, 2);
    std::vector<long double> upTo = {0};
    for (std::size_t piece = 0; piece < work.pieces; ++piece) {
        upTo.push_back(upTo.back() + cubicLength(&work.bezier[piece * numbersACubic]));
    }
    for (std::size_t i = 0; i < work.count; ++i) {
        const auto wanted =
            upTo.back() * static_cast<long double>(i) / static_cast<long double>(work.count - 1);
        std::size_t piece = 0;
        while (piece + 1 < work.pieces && upTo[piece + 1] < wanted) {
            ++piece;
        }
        const auto* cubic = &work.bezier[piece * numbersACubic];
        const auto u =
            parameterAtLength(cubic, wanted - upTo[piece], upTo[piece + 1] - upTo[piece]);
        work.positions.push_back(bezier(cubic, 2, 3, u).value);
        work.positions.push_back(bezier(cubic + 1, 2, 3, u).value);
    }
    return work;
}

Trial ourEvenWalk() {
    const auto& work = evenWalk();
    const auto pieces = ours::bezierSpline(work.bezier);
    return filling<double>(work.positions, [pieces, &work](std::span<double> out) {
        ours::evenPoints(pieces, work.count, out);
    });
}

} // namespace

const EvenWalk& evenWalk() {
    static const auto work = makeEvenWalk();
    return work;
}

void addEven(Contest& contest) {
    contest.rows.push_back({.id = "even",
                            .work = "1000 evenly spaced points to 1e-9",
                            .items = evenWalk().count,
                            .peers = {},
                            .goals = {TimesAsFastAs{"kurbo", 30}, AtMost{25}, ErrorAtMost{1e-9}},
                            .kurbo = 1146});
    contest.entries.push_back({"even", ourName, ourEvenWalk});
}

} // namespace splineloft::bench
