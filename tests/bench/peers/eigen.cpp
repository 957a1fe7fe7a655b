// Eigen: Spline of unsupported/Eigen/Splines, a B-spline over [0, 1] of fixed or dynamic degree.
#include "tests/bench/peers/peers.h"
#include "tests/bench/works.h"

#include <unsupported/Eigen/Splines>

namespace splineloft::bench {
namespace {

template <int degree>
Eigen::Spline<double, 2, degree> splineOf(const Coordinates& points,
                                          const std::vector<double>& knots) {
    using Spline = Eigen::Spline<double, 2, degree>;
    const auto knotCount = static_cast<Eigen::Index>(knots.size());
    const auto pointCount = static_cast<Eigen::Index>(points.size() / 2);
    const typename Spline::KnotVectorType knotVector =
        Eigen::Map<const Eigen::RowVectorXd>(knots.data(), knotCount) / knots.back();
    const typename Spline::ControlPointVectorType controls =
        Eigen::Map<const Eigen::Array2Xd>(points.data(), 2, pointCount);
    return Spline(knotVector, controls);
}

/// A uniform Catmull-Rom spline is the cubic B-spline with double knots whose control points are
/// the inner Bézier points.
Eigen::Spline<double, 2, 3> catmullRomSpline() {
    const auto& work = uniformCubic();
    Coordinates points = {work.bezier[0], work.bezier[1]};
    std::vector<double> knots = {0, 0, 0, 0};
    for (std::size_t piece = 0; piece < work.pieces; ++piece) {
        const auto inner = work.bezier.begin() + static_cast<std::ptrdiff_t>(8 * piece + 2);
        points.insert(points.end(), inner, inner + 4);
        const auto end = static_cast<double>(piece + 1);
        knots.insert(knots.end(), {end, end});
    }
    points.insert(points.end(), work.bezier.end() - 2, work.bezier.end());
    knots.insert(knots.end(), {knots.back(), knots.back()});
    return splineOf<3>(points, knots);
}

std::vector<double> evenParameters(std::size_t count) {
    std::vector<double> parameters;
    for (std::size_t i = 0; i < count; ++i) {
        parameters.push_back(static_cast<double>(i) / static_cast<double>(count));
    }
    return parameters;
}

template <class Spline>
Trial evaluation(const Spline& spline, const std::vector<double>& parameters,
                 const References& reference) {
    return filling<double>(reference, [spline, parameters](std::span<double> out) {
        auto* next = out.data();
        for (const double u : parameters) {
            const typename Spline::PointType position = spline(u);
            *next++ = position[0];
            *next++ = position[1];
        }
    });
}

Trial random() {
    auto parameters = randomSpots().t;
    for (auto& t : parameters) {
        t /= static_cast<double>(uniformCubic().pieces);
    }
    return evaluation(catmullRomSpline(), parameters, randomSpots().positions);
}

Trial highDegreeBezier() {
    const auto& work = highDegree();
    const auto order = static_cast<std::size_t>(work.degree + 1);
    std::vector<double> knots(order, 0);
    knots.insert(knots.end(), order, 1);
    return evaluation(splineOf<Eigen::Dynamic>(work.bezier, knots), evenParameters(work.samples),
                      work.positions);
}

template <int degree> Trial clamped() {
    const auto& work = clampedBSpline(degree);
    return evaluation(splineOf<degree>(work.points, work.knots),
                      evenParameters(work.pieces * work.perPiece), work.positions);
}

Trial jets() {
    const auto& work = uniformCubic();
    const auto parameters = evenParameters(work.pieces * work.perPiece);
    const auto pieces = static_cast<double>(work.pieces);
    const auto numbers = std::make_shared<std::vector<double>>(uniformCubicJets().size());
    return {.pass =
                [spline = catmullRomSpline(), parameters, pieces, numbers] {
                    auto* next = numbers->data();
                    for (const double u : parameters) {
                        const auto jet = spline.derivatives<2>(u);
                        const double x = jet(0, 1) / pieces, y = jet(1, 1) / pieces;
                        const double cross = jet(0, 1) * jet(1, 2) - jet(1, 1) * jet(0, 2);
                        const double speed = std::hypot(jet(0, 1), jet(1, 1));
                        *next++ = jet(0, 0);
                        *next++ = jet(1, 0);
                        *next++ = x;
                        *next++ = y;
                        *next++ = cross / (speed * speed * speed);
                    }
                    benchmark::ClobberMemory();
                },
            .error = [numbers] { return deviationOfJets(*numbers); }};
}

} // namespace

void addEigen(Contest& contest) {
    contest.entries.insert(contest.entries.end(), {{"random-2d", "Eigen", random},
                                                   {"bezier-20", "Eigen", highDegreeBezier},
                                                   {"b-spline-3", "Eigen", clamped<3>},
                                                   {"b-spline-5", "Eigen", clamped<5>},
                                                   {"jets", "Eigen", jets}});
}

} // namespace splineloft::bench
