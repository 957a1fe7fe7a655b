#include "core/spline/fast/lanes/horner.h"

#include "core/spline/fast/lanes/table_lanes.h"

#include <algorithm>

namespace splineloft::lanes {
namespace {

/// Writes one row: Bézier point `index` of all pieces, times a factor.
void gatherRow(const double* bezier, std::size_t count, std::size_t index, std::size_t pieces,
               std::size_t width, double factor, double* row) {
    for (std::size_t piece = 0; piece < pieces; ++piece) {
        for (std::size_t c = 0; c < width; ++c) {
            *row++ = factor * bezier[(piece * count + index) * width + c];
        }
    }
}

/// From Bernstein coefficients to power form, in place: the k-th is the k-th forward difference at
/// the start, times binomial(degree, k).
void toPowerForm(const std::vector<double>& binomials, std::size_t across, double* rows) {
    const auto count = binomials.size();
    for (std::size_t level = 1; level < count; ++level) {
        for (std::size_t k = count - 1; k >= level; --k) {
            double* const row = rows + k * across;
            for (std::size_t i = 0; i < across; ++i) {
                row[i] -= rows[(k - 1) * across + i];
            }
        }
    }
    for (std::size_t k = 1; k + 1 < count; ++k) {
        for (std::size_t i = 0; i < across; ++i) {
            rows[k * across + i] *= binomials[k];
        }
    }
}

/// u = k / perPiece.
void fillSteps(std::size_t perPiece, std::size_t count, double* x) {
    const auto steps = static_cast<double>(perPiece);
    for (std::size_t k = 0; k < count; ++k) {
        x[k] = static_cast<double>(static_cast<int>(k)) / steps; // int: it has a vector conversion
    }
}

} // namespace

CoefficientMaker::CoefficientMaker(int degree) : degree_(degree) {
    double binomial = 1;
    for (int k = 0; k <= degree; ++k) {
        binomials_.push_back(binomial);
        binomial = binomial * (degree - k) / (k + 1); // a whole number each time
    }
}

void CoefficientMaker::make(const double* bezier, std::size_t pieces, std::size_t width,
                            double* coefficients) const {
    const auto count = binomials_.size();
    const auto across = pieces * width;
    for (std::size_t k = 0; k < count; ++k) {
        const double factor = isScaled(degree_) ? binomials_[k] : 1;
        gatherRow(bezier, count, k, pieces, width, factor, coefficients + k * across);
        if (isScaled(degree_)) {
            gatherRow(bezier, count, count - 1 - k, pieces, width, factor,
                      coefficients + (count + k) * across);
        }
    }
    if (!isScaled(degree_)) {
        toPowerForm(binomials_, across, coefficients);
    }
}

std::vector<Run> runsOf(int degree, std::size_t perPiece) {
    const auto padded = [](std::size_t set, std::size_t first, std::size_t count, bool scaled) {
        Run run{set, first, count, std::vector<double>(count + runPadding), {}};
        run.scale.resize(scaled ? count + runPadding : 0);
        return run;
    };
    if (!isScaled(degree)) {
        std::vector<Run> runs{padded(0, 0, perPiece, false)};
        fillSteps(perPiece, perPiece, runs[0].x.data());
        return runs;
    }
    // The first sample beyond u = 1/2; it and those after it are seen from the other end.
    const auto turn = std::min(perPiece / 2 + 1, perPiece);
    std::vector<Run> runs{padded(0, 0, turn, true)};
    const auto steps = static_cast<double>(perPiece);
    fillRatios({degree, steps, 0, 1, turn}, runs[0].x.data(), runs[0].scale.data());
    if (turn < perPiece) {
        runs.push_back(padded(1, turn, perPiece - turn, true));
        const auto left = perPiece - turn;
        fillRatios({degree, steps, static_cast<double>(left), -1, left}, runs[1].x.data(),
                   runs[1].scale.data());
    }
    return runs;
}

} // namespace splineloft::lanes
