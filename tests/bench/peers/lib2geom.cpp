// lib2geom, the geometry of Inkscape: Bézier curves of any degree, and paths of them.
#include "tests/bench/peers/peers.h"
#include "tests/bench/works.h"

#include <2geom/bezier-curve.h>
#include <2geom/path.h>

namespace splineloft::bench {
namespace {

std::vector<Geom::Point> pointsOf(const double* numbers, std::size_t count) {
    std::vector<Geom::Point> points;
    for (std::size_t i = 0; i < count; ++i) {
        points.emplace_back(numbers[2 * i], numbers[2 * i + 1]);
    }
    return points;
}

std::shared_ptr<Geom::Curve> curveOf(const double* numbers, std::size_t count) {
    return std::shared_ptr<Geom::Curve>(Geom::BezierCurve::create(pointsOf(numbers, count)));
}

std::vector<std::shared_ptr<Geom::Curve>> cubicsOf(const Coordinates& bezier) {
    std::vector<std::shared_ptr<Geom::Curve>> cubics;
    for (std::size_t i = 0; i < bezier.size(); i += 8) {
        cubics.push_back(curveOf(&bezier[i], 4));
    }
    return cubics;
}

Trial highDegreeBezier() {
    const auto& work = highDegree();
    const auto curve = curveOf(work.bezier.data(), work.bezier.size() / 2);
    return filling<double>(work.positions, [curve, &work](std::span<double> out) {
        for (std::size_t k = 0; k < work.samples; ++k) {
            const auto point =
                curve->pointAt(static_cast<double>(k) / static_cast<double>(work.samples));
            out[2 * k] = point.x();
            out[2 * k + 1] = point.y();
        }
    });
}

Trial length() {
    const auto cubics = cubicsOf(randomCubics().bezier);
    const auto lengths = std::make_shared<std::vector<double>>(cubics.size());
    return {.pass =
                [cubics, lengths] {
                    for (std::size_t i = 0; i < cubics.size(); ++i) {
                        (*lengths)[i] = cubics[i]->length(1e-9);
                    }
                    benchmark::ClobberMemory();
                },
            .error = [lengths] { return deviationOfLengths(*lengths); }};
}

Trial nearest() {
    const auto& work = surroundings();
    Geom::Path path;
    for (const auto& cubic : cubicsOf(work.bezier)) {
        path.append(*cubic);
    }
    const auto found = std::make_shared<std::vector<double>>(work.distances.size());
    return {.pass =
                [path, found, &work] {
                    for (std::size_t i = 0; i < found->size(); ++i) {
                        const auto time =
                            path.nearestTime({work.places[2 * i], work.places[2 * i + 1]});
                        (*found)[i] = time.asFlatTime();
                    }
                    benchmark::ClobberMemory();
                },
            .error = [found] { return excessDistance(*found); }};
}

Trial jets() {
    const auto& work = uniformCubic();
    const auto cubics = cubicsOf(work.bezier);
    const auto numbers = std::make_shared<std::vector<double>>(uniformCubicJets().size());
    return {.pass =
                [cubics, numbers, perPiece = work.perPiece] {
                    auto* next = numbers->data();
                    for (const auto& cubic : cubics) {
                        for (std::size_t k = 0; k < perPiece; ++k) {
                            const auto jet = cubic->pointAndDerivatives(
                                static_cast<double>(k) / static_cast<double>(perPiece), 2);
                            const double speed = jet[1].length();
                            *next++ = jet[0].x();
                            *next++ = jet[0].y();
                            *next++ = jet[1].x();
                            *next++ = jet[1].y();
                            *next++ = Geom::cross(jet[1], jet[2]) / (speed * speed * speed);
                        }
                    }
                    benchmark::ClobberMemory();
                },
            .error = [numbers] { return deviationOfJets(*numbers); }};
}

} // namespace

void addLib2geom(Contest& contest) {
    contest.entries.insert(contest.entries.end(), {{"bezier-20", "lib2geom", highDegreeBezier},
                                                   {"length", "lib2geom", length},
                                                   {"nearest", "lib2geom", nearest},
                                                   {"jets", "lib2geom", jets}});
}

} // namespace splineloft::bench
