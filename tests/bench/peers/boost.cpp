// Boost.Math: catmull_rom, and cardinal_cubic_b_spline, which wants x in equal steps.
#include "tests/bench/peers/peers.h"
#include "tests/bench/works.h"

#include <array>
#include <boost/math/interpolators/cardinal_cubic_b_spline.hpp>
#include <boost/math/interpolators/catmull_rom.hpp>

namespace splineloft::bench {
namespace {

template <std::size_t dimension> using Place = std::array<double, dimension>;

template <std::size_t dimension> using CatmullRom = boost::math::catmull_rom<Place<dimension>>;

template <std::size_t dimension>
std::shared_ptr<CatmullRom<dimension>> uniformCatmullRom(const UniformCubic& work) {
    const auto& coordinates = work.points;
    std::vector<Place<dimension>> points(coordinates.size() / dimension);
    for (std::size_t i = 0; i < coordinates.size(); ++i) {
        points[i / dimension][i % dimension] = coordinates[i];
    }
    constexpr double uniform = 0;
    return std::make_shared<CatmullRom<dimension>>(std::move(points), false, uniform);
}

/// Our piece 0 begins at the second point, at which Boost's parameter is 1.
template <std::size_t dimension>
Trial evaluation(const UniformCubic& work, std::vector<double> parameters,
                 const References& reference) {
    for (auto& t : parameters) {
        t += 1;
    }
    return filling<double>(
        reference, [curve = uniformCatmullRom<dimension>(work), parameters](std::span<double> out) {
            auto* next = out.data();
            for (const double t : parameters) {
                const auto position = (*curve)(t);
                next = std::copy(position.begin(), position.end(), next);
            }
        });
}

Trial denseInSpace() {
    const auto& work = smallCubic(3);
    std::vector<double> parameters;
    for (std::size_t i = 0; i < work.pieces * work.perPiece; ++i) {
        parameters.push_back(static_cast<double>(i) / static_cast<double>(work.perPiece));
    }
    return evaluation<3>(work, parameters, work.positions);
}

Trial random() {
    return evaluation<2>(uniformCubic(), randomSpots().t, randomSpots().positions);
}

using BSpline = boost::math::interpolators::cardinal_cubic_b_spline<double>;

/// With the end slopes of the natural spline it is the natural spline.
BSpline splineOf(const Graph& work) {
    return {work.y.data(), work.y.size(),     work.x.front(),
            work.step,     work.slopeAtStart, work.slopeAtEnd};
}

void evaluate(const BSpline& spline, std::span<const double> x, std::span<double> out) {
    for (std::size_t i = 0; i < x.size(); ++i) {
        out[i] = spline(x[i]);
    }
}

Trial build() {
    const auto& work = smallEvenGraph();
    const auto built = std::make_shared<BSpline>();
    return {.pass =
                [built, &work] {
                    *built = splineOf(work);
                    benchmark::ClobberMemory();
                },
            .error =
                [built, &work] {
                    std::vector<double> found(askedOfBuilt);
                    evaluate(*built, std::span(work.asked).first(askedOfBuilt), found);
                    return deviation<double>(found, std::span(work.answers).first(askedOfBuilt));
                }};
}

Trial evaluationOfGraph() {
    const auto& work = smallEvenGraph();
    return filling<double>(work.answers, [spline = splineOf(work), &work](std::span<double> out) {
        evaluate(spline, work.asked, out);
    });
}

} // namespace

void addBoost(Contest& contest) {
    contest.entries.insert(contest.entries.end(),
                           {{"dense-3d", "Boost", denseInSpace},
                            {"random-2d", "Boost", random},
                            {"natural-build-even", "Boost", build},
                            {"natural-at-even", "Boost", evaluationOfGraph}});
}

} // namespace splineloft::bench
