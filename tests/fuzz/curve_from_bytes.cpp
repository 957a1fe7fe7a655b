#include "tests/fuzz/curve_from_bytes.h"

#include "core/spline/catalog.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdio>
#include <cstdlib>

namespace splineloft::fuzz {
namespace {

constexpr std::size_t mostPoints = 24;
constexpr std::array special = {0.0, -0.0, 1.0, -1.0, 0.5, 1e300, -1e300, 1e-300, 5e-324, 1e9};

/// A value that the parameter accepts, its ends and its neutral value more often than others.
double valueOf(const Parameter& parameter, Bytes& bytes) {
    const double part = bytes.part();
    const double value = bytes.flip() ? parameter.neutral
                                      : parameter.sliderLeast +
                                            part * (parameter.sliderMost - parameter.sliderLeast);
    return parameter.scale == Scale::whole ? static_cast<double>(static_cast<int>(value)) : value;
}

void addLists(Curve& curve, const Family& family, Bytes& bytes) {
    const auto n = curve.points.size();
    if (family.usesWeights && bytes.flip()) {
        for (std::size_t i = 0; i < n; ++i) {
            curve.weights.push_back(static_cast<double>(bytes.byte() + 1) / 16);
        }
    }
    for (const auto& parameter : family.parameters) {
        if (parameter.local && bytes.byte() % 4 == 0) {
            auto& values = curve.local[std::string(parameter.key)];
            for (std::size_t i = 0; i < n; ++i) {
                values.push_back(valueOf(parameter, bytes));
            }
        }
    }
    if (family.usesKnots && bytes.flip()) {
        const auto degree = static_cast<std::size_t>(parameterOf(curve, "degree"));
        for (std::size_t i = 0; i < (curve.closed ? n + 1 : n + degree + 1); ++i) {
            curve.knots.push_back(bytes.byte() % 8 == 0 ? bytes.number() : bytes.byte() % 16);
        }
        std::ranges::sort(curve.knots);
        curve.ends = Ends::none;
    }
}

} // namespace

std::uint8_t Bytes::byte() {
    if (rest_.empty()) {
        return 0;
    }
    const auto first = rest_.front();
    rest_ = rest_.subspan(1);
    return first;
}

double Bytes::number() {
    const auto kind = byte();
    if (kind < 180) {
        return (static_cast<double>(byte()) * 256 + byte() - 32768) / 64;
    }
    if (kind < 240) {
        return special[upTo(special.size() - 1)];
    }
    std::uint64_t bits = 0;
    for (int i = 0; i < 8; ++i) {
        bits = (bits << 8U) | byte();
    }
    return std::bit_cast<double>(bits);
}

double Bytes::part() {
    return std::min(static_cast<double>(byte()), 250.0) / 250;
}

Curve curveFrom(Bytes& bytes) {
    Curve curve;
    const auto& family = catalog()[bytes.upTo(catalog().size() - 1)];
    curve.family = family.id;
    curve.closed = family.closable && bytes.flip();
    curve.ends = family.ends[bytes.upTo(family.ends.size() - 1)];
    for (const auto& parameter : family.parameters) {
        curve.parameters[std::string(parameter.key)] = valueOf(parameter, bytes);
    }
    const auto dimension = static_cast<int>(1 + bytes.upTo(3));
    curve.points = Points(dimension);
    curve.tangents = Points(dimension);
    curve.coordinates.clear();
    for (int c = 0; c < dimension; ++c) {
        curve.coordinates.push_back("c" + std::to_string(c));
    }
    const auto pointFrom = [&] {
        Point place(dimension);
        for (int c = 0; c < dimension; ++c) {
            place[c] = bytes.number();
        }
        return place;
    };
    const auto count = bytes.upTo(mostPoints);
    for (std::size_t i = 0; i < count; ++i) {
        // Now and then a point once more: coincident points are where formulas divide by zero.
        const bool again = i > 0 && bytes.byte() % 8 == 0;
        curve.points.append(again ? curve.points.at(i - 1) : pointFrom());
        if (family.usesTangents) {
            curve.tangents.append(pointFrom());
        }
    }
    addLists(curve, family, bytes);
    return curve;
}

void require(bool holds, const char* what) {
    if (!holds) {
        std::fprintf(stderr, "does not hold: %s\n", what);
        std::abort();
    }
}

} // namespace splineloft::fuzz
