// A curve as a row of samples, for programs that know no splines: as JSON, or as a table (CSV).
//
// Each sample has its parameter t, the length from the start, the time, the position, the tangent
// (derivative of the position by t) and the curvature (1 / unit of length; in the plane, left turns
// are positive), which is missing where the speed is zero. Time is the part of the way that has
// been travelled, from 0 to 1: who travels at constant speed is there at that part of the whole
// duration.
#pragma once

#include "core/formats/result.h"
#include "core/spline/curve.h"
#include "core/spline/measure/sample.h"

#include <string>
#include <variant>
#include <vector>

namespace splineloft {

/// Samples of a curve may be so many.
inline constexpr std::size_t mostSamples = mostSpots;

/// So many equal steps of u on every piece, and the end.
struct StepsPerPiece {
    std::size_t steps;
};

/// So many samples from the start to the end, even in something.
struct EvenSamples {
    std::size_t count;
    enum class In { parameter, length, time } in = In::parameter;
};

using Sampling = std::variant<StepsPerPiece, EvenSamples>;

/// The samples of one curve, and what there is to say about them.
struct SampledPath {
    std::string curve;
    std::string family;
    std::vector<std::string> coordinates;
    std::string spacing; ///< "per-segment", "parameter", "length" or "time"
    double length = 0;   ///< of the whole curve
    std::vector<Sample> samples;
};

/// Takes the samples of a curve without problem. Refused where it has no piece yet, and where the
/// samples would be fewer than 2 or more than `mostSamples`; places are JSON pointers from the
/// curve.
Result<SampledPath> sampledPath(const Curve& curve, const Sampling& sampling);

/// One line of names, then one line a sample, in the manner of RFC 4180 with line feeds: t, length,
/// time, the coordinates, tangent_ and each coordinate, curvature. A coordinate that bears the name
/// of a column before it gets an underscore at its end.
std::string samplesAsCsv(const SampledPath& path);

/// An object of the format "splineloft-samples".
std::string samplesAsJson(const SampledPath& path);

/// Why nothing can be computed on a curve without pieces, at "/points".
Refusal tooFewPoints(const Curve& curve);

} // namespace splineloft
