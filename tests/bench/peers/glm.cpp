// GLM: catmullRom of gtx/spline, on windows of four points.
#include "tests/bench/peers/peers.h"
#include "tests/bench/works.h"

#define GLM_ENABLE_EXPERIMENTAL
#include <glm/glm.hpp>
#include <glm/gtx/spline.hpp>

namespace splineloft::bench {
namespace {

template <class Vector> std::vector<Vector> vectorsOf(const Coordinates& coordinates) {
    std::vector<Vector> vectors(coordinates.size() / static_cast<std::size_t>(Vector::length()));
    auto next = coordinates.begin();
    for (auto& vector : vectors) {
        for (int c = 0; c < Vector::length(); ++c) {
            vector[c] = static_cast<typename Vector::value_type>(*next++);
        }
    }
    return vectors;
}

template <class Vector> void append(const Vector& vector, typename Vector::value_type*& next) {
    for (int c = 0; c < Vector::length(); ++c) {
        *next++ = vector[c];
    }
}

template <class Vector> Trial dense(const UniformCubic& work) {
    using Number = typename Vector::value_type;
    std::vector<Number> us;
    for (std::size_t k = 0; k < work.perPiece; ++k) {
        us.push_back(static_cast<Number>(k) / static_cast<Number>(work.perPiece));
    }
    const auto points = vectorsOf<Vector>(work.points);
    return filling<Number>(work.positions, [points, us](std::span<Number> out) {
        auto* next = out.data();
        for (std::size_t i = 0; i + 3 < points.size(); ++i) {
            const auto a = points[i], b = points[i + 1], c = points[i + 2], d = points[i + 3];
            for (const auto u : us) {
                append(glm::catmullRom(a, b, c, d, u), next);
            }
        }
    });
}

Trial random() {
    const auto& work = randomSpots();
    const auto p = vectorsOf<glm::dvec2>(uniformCubic().points);
    return filling<double>(work.positions, [p, &work](std::span<double> out) {
        auto* next = out.data();
        for (const double t : work.t) {
            const auto i = static_cast<std::size_t>(t);
            const double u = t - static_cast<double>(i);
            append(glm::catmullRom(p[i], p[i + 1], p[i + 2], p[i + 3], u), next);
        }
    });
}

} // namespace

void addGlm(Contest& contest) {
    contest.entries.insert(
        contest.entries.end(),
        {{"dense-2f", "glm", [] { return dense<glm::vec2>(smallCubicOfFloats()); }},
         {"dense-2d", "glm", [] { return dense<glm::dvec2>(smallCubic(2)); }},
         {"dense-3d", "glm", [] { return dense<glm::dvec3>(smallCubic(3)); }},
         {"dense-2d-second", "glm", [] { return dense<glm::dvec2>(uniformCubic()); }},
         {"random-2d", "glm", random}});
}

} // namespace splineloft::bench
