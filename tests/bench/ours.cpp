#include "tests/bench/ours.h"

#include "core/spline/curve.h"
#include "core/spline/fast/dense.h"
#include "core/spline/fast/natural_function.h"
#include "core/spline/fast/power_form.h"
#include "core/spline/measure/length.h"
#include "core/spline/measure/nearest.h"
#include "core/spline/measure/sample.h"

#include <memory>

namespace splineloft::bench::ours {
namespace {

Curve curveOf(std::span<const double> points, int dimension, const char* family, Ends ends) {
    Curve curve;
    curve.family = family;
    curve.ends = ends;
    curve.coordinates = {"x", "y", "z"};
    curve.coordinates.resize(static_cast<std::size_t>(dimension));
    curve.points = Points(dimension);
    const auto stride = static_cast<std::size_t>(dimension);
    curve.points.reserve(points.size() / stride);
    for (std::size_t i = 0; i < points.size(); i += stride) {
        curve.points.append(Point(points.subspan(i, stride)));
    }
    return curve;
}

} // namespace

Pieces catmullRom(std::span<const double> points, int dimension) {
    return piecesOf(curveOf(points, dimension, "cardinal", Ends::open));
}

Pieces bezier(std::span<const double> points) {
    return piecesOf(curveOf(points, 2, "bezier", Ends::none));
}

Pieces bezierSpline(std::span<const double> bezier) {
    constexpr std::size_t numbersAPiece = 8;
    std::vector<double> knots;
    for (std::size_t i = 0; i <= bezier.size() / numbersAPiece; ++i) {
        knots.push_back(static_cast<double>(i));
    }
    return {3, 2, KnotLine(std::move(knots)), {bezier.begin(), bezier.end()}};
}

Pieces clampedBSpline(std::span<const double> points, int degree) {
    auto curve = curveOf(points, 2, "b-spline", Ends::clamped);
    curve.parameters["degree"] = degree;
    return piecesOf(curve);
}

PositionsAt positionsAt(const Pieces& pieces) {
    return [form = PowerForm(pieces)](std::span<const double> t, std::span<double> out) {
        form.positions(t, out);
    };
}

std::size_t positionsSize(const Pieces& pieces, std::size_t perPiece) {
    return placesPerPiece(pieces, perPiece) * static_cast<std::size_t>(pieces.dimension());
}

void positions(const Pieces& pieces, std::size_t perPiece, std::span<double> out) {
    positionsPerPiece(pieces, perPiece, out);
}

void positions(const Pieces& pieces, std::size_t perPiece, std::span<float> out) {
    positionsPerPiece(pieces, perPiece, out);
}

Jets jets(const Pieces& pieces, std::size_t perPiece) {
    const auto table = std::make_shared<DenseJets>();
    return {.run = [pieces, perPiece, table] { jetsPerPiece(pieces, perPiece, *table); },
            .result =
                [table] {
                    std::vector<double> numbers;
                    for (std::size_t i = 0; i < table->curvatures.size(); ++i) {
                        numbers.insert(numbers.end(),
                                       {table->positions[2 * i], table->positions[2 * i + 1],
                                        table->firsts[2 * i], table->firsts[2 * i + 1],
                                        table->curvatures[i]});
                    }
                    return numbers;
                }};
}

Build naturalBuild(std::span<const double> x, std::span<const double> y) {
    const auto function = std::make_shared<NaturalFunction>(x, y);
    return {.run = [=] { function->refit(x, y); },
            .at = [=](std::span<const double> places,
                      std::span<double> out) { function->evaluate(places, out); }};
}

double length(const Pieces& pieces) {
    return lengthOf(pieces, 1e-9);
}

void evenPoints(const Pieces& pieces, std::size_t count, std::span<double> out) {
    spreadPlaces(pieces, ArcLength(pieces), count, out);
}

NearestParameter nearest(const Pieces& pieces) {
    // The index refers to the pieces, which therefore live as long.
    struct Made {
        explicit Made(const Pieces& given) : pieces(given), index(pieces) {}
        Pieces pieces;
        NearestIndex index;
    };
    return [made = std::make_shared<Made>(pieces)](double x, double y) {
        return made->pieces.knots().parameter(made->index.nearest({x, y})->spot);
    };
}

} // namespace splineloft::bench::ours
