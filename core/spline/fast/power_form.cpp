#include "core/spline/fast/power_form.h"

#include "core/spline/fast/lanes/column_lanes.h"
#include "core/spline/fast/lanes/horner.h"
#include "core/spline/fast/lanes/knot_finder.h"
#include "core/spline/fast/lanes/spot_lanes.h"
#include "core/spline/fast/lanes/table_lanes.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace splineloft {
namespace {

/// Spots of one batch: few enough for the first cache, enough to keep the steps apart.
constexpr std::size_t batchSize = 64;

std::size_t widthOf(const Pieces& pieces) {
    return static_cast<std::size_t>(pieces.dimension()) + (pieces.form() == Form::rational ? 1 : 0);
}

/// The width, filled up to what vectors of 2 or 4 numbers divide.
std::size_t columnsFor(std::size_t width) {
    return width <= 2 ? width : (width + 3) / 4 * 4;
}

/// What is known of the spots of a batch, one entry each, and room for what vectors reach beyond.
/// Filled as far as it is used.
struct Batch {
    static constexpr std::size_t room = batchSize + lanes::spotPadding;
    static constexpr std::size_t mostColumns = (maxDimension + 1 + 3) / 4 * 4;

    std::size_t count;
    std::array<double, room> t;
    std::array<std::int32_t, room> pieces;
    std::array<double, room> x; ///< u at first, then what Horner's scheme wants
    std::array<double, room> scale;
    std::array<double, room> fromEnd;
    std::array<double, room * mostColumns> values;
};

} // namespace

struct PowerForm::Kept {
    Pieces pieces; ///< without Bézier points, but where the degree is too high for coefficients
    lanes::KnotFinder finder;
    std::size_t columns = 0;          ///< of the coefficients: a vector holds whole rows
    std::vector<double> coefficients; ///< pieces x (degree + 1) rows; none where the degree is high

    void keepCoefficients();
    void evaluate(Batch& batch, std::span<double> out) const;
    void finish(const double* rows, std::size_t count, double* out) const;
};

PowerForm::PowerForm(const Pieces& pieces) {
    if (pieces.empty()) {
        throw std::invalid_argument("PowerForm: the curve needs at least one piece");
    }
    Kept kept{pieces, lanes::KnotFinder(pieces.knots()), columnsFor(widthOf(pieces)), {}};
    if (pieces.degree() <= lanes::mostScaledDegree) {
        kept.keepCoefficients();
    }
    kept_ = std::make_shared<const Kept>(std::move(kept));
}

void PowerForm::Kept::keepCoefficients() {
    const lanes::CoefficientMaker maker(pieces.degree());
    const auto width = widthOf(pieces);
    const auto rows = static_cast<std::size_t>(pieces.degree()) + 1;
    std::vector<double> ofPiece(lanes::coefficientCount(pieces.degree()) * width);
    coefficients.resize(pieces.size() * rows * columns);
    auto* row = coefficients.data();
    for (std::size_t piece = 0; piece < pieces.size(); ++piece) {
        maker.make(pieces[piece].coordinates.data(), width, ofPiece.data());
        // The second set of a scaled form is the first in reverse: it is read upwards instead.
        for (std::size_t k = 0; k < rows; ++k, row += columns) {
            std::copy_n(ofPiece.data() + k * width, width, row);
        }
    }
    pieces = Pieces(pieces.degree(), pieces.dimension(), pieces.knots(), {}, pieces.form());
}

int PowerForm::dimension() const {
    return kept_->pieces.dimension();
}

Point PowerForm::position(double t) const {
    Point place(dimension());
    std::array<double, maxDimension> coordinates{};
    position(t, std::span(coordinates).first(static_cast<std::size_t>(dimension())));
    for (int c = 0; c < dimension(); ++c) {
        place[c] = coordinates[static_cast<std::size_t>(c)];
    }
    return place;
}

void PowerForm::position(double t, std::span<double> out) const {
    positions(std::span(&t, 1), out);
}

void PowerForm::positions(std::span<const double> t, std::span<double> out) const {
    const auto width = static_cast<std::size_t>(dimension());
    if (out.size() != t.size() * width) {
        throw std::invalid_argument("PowerForm: " + std::to_string(t.size()) +
                                    " places of dimension " + std::to_string(width) +
                                    " need room for " + std::to_string(t.size() * width) +
                                    " numbers, not " + std::to_string(out.size()));
    }
    Batch batch;
    std::fill(batch.t.begin(), batch.t.end(), 0.0);
    while (!t.empty()) {
        batch.count = std::min(batchSize, t.size());
        std::copy_n(t.begin(), batch.count, batch.t.begin());
        kept_->evaluate(batch, out.first(batch.count * width));
        t = t.subspan(batch.count);
        out = out.subspan(batch.count * width);
    }
}

void PowerForm::Kept::evaluate(Batch& batch, std::span<double> out) const {
    finder.locate(batch.t.data(), batch.count, batch.pieces.data(), batch.x.data());
    if (coefficients.empty()) {
        for (std::size_t i = 0; i < batch.count; ++i) {
            const Spot spot{static_cast<std::size_t>(batch.pieces[i]), batch.x[i]};
            const auto place = pieces.position(spot);
            std::copy(place.coordinates().begin(), place.coordinates().end(), out.begin());
            out = out.subspan(static_cast<std::size_t>(pieces.dimension()));
        }
        return;
    }
    lanes::Spots spots;
    spots.count = batch.count;
    spots.degree = pieces.degree();
    spots.columns = columns;
    spots.coefficients = coefficients.data();
    spots.pieces = batch.pieces.data();
    spots.x = batch.x.data();
    if (lanes::isScaled(pieces.degree())) {
        lanes::seeFromNearerEnd(spots.degree, batch.count, batch.x.data(), batch.scale.data(),
                                batch.fromEnd.data());
        spots.scale = batch.scale.data();
        spots.fromEnd = batch.fromEnd.data();
    }
    if (pieces.size() == 1) {
        const lanes::Columns table{batch.values.data(), Batch::room, batch.count,
                                   pieces.dimension()};
        lanes::evaluateSpotsOfOnePiece(spots, widthOf(pieces), table.stride, table.first);
        if (pieces.form() == Form::rational) {
            lanes::projectPositions(table);
        }
        lanes::weave(table, out.data());
    } else if (columns == static_cast<std::size_t>(pieces.dimension())) {
        lanes::evaluateSpots(spots, out.data());
    } else {
        lanes::evaluateSpots(spots, batch.values.data());
        finish(batch.values.data(), batch.count, out.data());
    }
}

/// Leaves out what fills up the columns, and divides by the weights.
void PowerForm::Kept::finish(const double* rows, std::size_t count, double* out) const {
    const auto width = static_cast<std::size_t>(pieces.dimension());
    for (std::size_t i = 0; i < count; ++i, rows += columns, out += width) {
        const double over = pieces.form() == Form::rational ? 1 / rows[width] : 1;
        for (std::size_t c = 0; c < width; ++c) {
            out[c] = over * rows[c];
        }
    }
}

} // namespace splineloft
