// The library as the benchmark calls it: one small function for each kind of work, so that it shows
// in one place which entrance is measured.
#pragma once

#include "core/spline/piece.h"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace splineloft::bench::ours {

/// Uniform Catmull-Rom through the points, from the second to the last but one.
Pieces catmullRom(std::span<const double> points, int dimension);
/// One Bézier curve in the plane.
Pieces bezier(std::span<const double> points);
/// A cubic Bézier spline in the plane, 4 points a piece.
Pieces bezierSpline(std::span<const double> bezier);
/// A clamped uniform B-spline in the plane.
Pieces clampedBSpline(std::span<const double> points, int degree);

/// Numbers that `positions` writes: its `perPiece` points of every piece, and maybe the end.
std::size_t positionsSize(const Pieces& pieces, std::size_t perPiece);
void positions(const Pieces& pieces, std::size_t perPiece, std::span<double> out);
void positions(const Pieces& pieces, std::size_t perPiece, std::span<float> out);

/// Makes ready to evaluate a plane curve at many parameter values; what is returned writes x, y.
using PositionsAt = std::function<void(std::span<const double> t, std::span<double> out)>;
PositionsAt positionsAt(const Pieces& pieces);

/// Makes ready to compute x, y, x', y' (by u) and curvature at `perPiece` points of every piece.
/// `run` works where the library puts its results, which `result` then copies out.
struct Jets {
    std::function<void()> run;
    std::function<std::vector<double>()> result;
};
Jets jets(const Pieces& pieces, std::size_t perPiece);

/// The natural spline through y over x: built anew by `run` in the memory it has, and evaluated at
/// many x. The spans must outlive it.
struct Build {
    std::function<void()> run;
    std::function<void(std::span<const double> x, std::span<double> out)> at;
};
Build naturalBuild(std::span<const double> x, std::span<const double> y);

double length(const Pieces& pieces);

/// `count` points in equal steps of length, measured and placed anew; x, y.
void evenPoints(const Pieces& pieces, std::size_t count, std::span<double> out);

/// Makes ready to find nearest spots; what is returned gives the parameter of the nearest one.
using NearestParameter = std::function<double(double x, double y)>;
NearestParameter nearest(const Pieces& pieces);

} // namespace splineloft::bench::ours
