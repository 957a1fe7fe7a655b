// What there is to do: the inputs of each row, the same for every program, and the right answers in
// long double. All are made on first use, from fixed seeds.
#pragma once

#include <cstddef>
#include <vector>

namespace splineloft::bench {

using Coordinates = std::vector<double>;     ///< point after point
using References = std::vector<long double>; ///< in the order of what is to be computed

/// A uniform Catmull-Rom spline: piece i runs from point i + 1 to point i + 2, and its samples lie
/// at u = k / perPiece.
struct UniformCubic {
    int dimension = 2;
    std::size_t pieces = 0;
    std::size_t perPiece = 256;
    Coordinates points = {}; ///< pieces + 3
    Coordinates bezier = {}; ///< the same curve: 4 points a piece
    References positions = {};
};
/// One whose samples fit the first cache, in 2 or 3 dimensions.
const UniformCubic& smallCubic(int dimension);
/// The same in the plane, with control points that float has exactly.
const UniformCubic& smallCubicOfFloats();
/// One in the plane whose samples fit the second cache.
const UniformCubic& uniformCubic();

/// Position, first derivative by u and curvature at the samples of uniformCubic(): x, y, x', y',
/// k.
const References& uniformCubicJets();
/// Deviation of such jets, each of the three in units of its own largest value.
double deviationOfJets(const std::vector<double>& jets);

/// A uniform Catmull-Rom spline in the plane with so many samples that no cache holds them.
const UniformCubic& largeCubic();

/// Parameter values 0 <= t < pieces all over uniformCubic(), in no order.
struct RandomSpots {
    std::vector<double> t = {};
    References positions = {};
};
const RandomSpots& randomSpots();

/// One Bézier curve in the plane, sampled at u = k / samples.
struct HighDegree {
    int degree = 20;
    std::size_t samples = 4096;
    Coordinates bezier = {};
    References positions = {};
};
const HighDegree& highDegree();

/// y over rising x, for a natural spline, and where it is asked for.
struct Graph {
    std::vector<double> x = {}, y = {};
    std::vector<double> asked = {}; ///< in no order
    References answers = {};
    double step = 0;                         ///< of x where it is even, or 0
    double slopeAtStart = 0, slopeAtEnd = 0; ///< of the natural spline
};
const Graph& smallGraph();     ///< 10^4 points
const Graph& largeGraph();     ///< 10^6 points
const Graph& smallEvenGraph(); ///< 10^4 points, x in equal steps
/// As many of the questions as tell whether a spline was built rightly.
inline constexpr std::size_t askedOfBuilt = 1000;

/// Single cubics in the plane, 4 Bézier points each, some of them with near cusps.
struct RandomCubics {
    std::size_t count = 5000;
    Coordinates bezier = {};
    References lengths = {};
};
const RandomCubics& randomCubics();
/// The largest relative error of any one length.
double deviationOfLengths(const std::vector<double>& lengths);

/// A plane curve to be walked in equal steps of length, its ends included.
struct EvenWalk {
    std::size_t count = 1000;
    std::size_t pieces = 0;
    Coordinates bezier = {}; ///< 4 points a piece
    References positions = {};
};
const EvenWalk& evenWalk();

/// A clamped B-spline in the plane with simple inner knots 0, 1, 2, ...
struct ClampedBSpline {
    int degree = 3;
    std::size_t pieces = 0;
    std::size_t perPiece = 256;
    Coordinates points = {}; ///< pieces + degree
    std::vector<double> knots = {};
    References positions = {}; ///< at u = k / perPiece of each piece
};
const ClampedBSpline& clampedBSpline(int degree); // 3 or 5

/// A clamped cubic B-spline of a thousand pieces, and places around it.
struct Surroundings {
    ClampedBSpline spline = {}; ///< without positions
    Coordinates bezier = {};    ///< the same curve: 4 points a piece
    std::vector<double> places = {};
    References distances = {};
};
const Surroundings& surroundings();
/// How much farther away than the nearest spot the spots at these parameters t are at worst, in
/// units of the size of the curve.
double excessDistance(const std::vector<double>& parameters);

} // namespace splineloft::bench
