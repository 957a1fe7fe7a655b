#include "core/spline/fast/lanes/horner.h"

#include "core/spline/fast/lanes/table_lanes.h"

#include <algorithm>

namespace splineloft::lanes {
namespace {

/// From Bernstein coefficients to power form, in place: the k-th is the k-th forward difference at
/// the start, times binomial(degree, k).
void toPowerForm(const std::vector<double>& binomials, std::size_t width, double* rows) {
    const auto count = binomials.size() * width;
    for (auto first = width; first < count; first += width) {
        for (auto i = count; i-- > first;) {
            rows[i] -= rows[i - width];
        }
    }
    for (std::size_t k = 1; k + 1 < binomials.size(); ++k) {
        for (std::size_t c = 0; c < width; ++c) {
            rows[k * width + c] *= binomials[k];
        }
    }
}

// Most pieces are cubics in two or three dimensions. Where the width is a constant, compilers put
// the coordinates side by side.

/// The power form of a cubic.
template <std::size_t fixedWidth>
void toCubicPowerForm(const double* bezier, std::size_t anyWidth, double* rows) {
    const auto width = fixedWidth > 0 ? fixedWidth : anyWidth;
    for (std::size_t c = 0; c < width; ++c) {
        const auto leg0 = bezier[width + c] - bezier[c];
        const auto leg1 = bezier[2 * width + c] - bezier[width + c];
        const auto leg2 = bezier[3 * width + c] - bezier[2 * width + c];
        rows[c] = bezier[c];
        rows[width + c] = 3 * leg0;
        rows[2 * width + c] = 3 * (leg1 - leg0);
        rows[3 * width + c] = (leg2 - leg1) - (leg1 - leg0);
    }
}

/// The coefficients of a cubic about 1/2, and its start.
template <std::size_t width> void toCentredCubic(const double* bezier, float* rows) {
    for (std::size_t c = 0; c < width; ++c) {
        const auto outer = bezier[c] + bezier[3 * width + c];
        const auto inner = bezier[width + c] + bezier[2 * width + c];
        const auto whole = bezier[3 * width + c] - bezier[c];
        const auto middle = bezier[2 * width + c] - bezier[width + c];
        rows[c] = static_cast<float>(0.125 * outer + 0.375 * inner);
        rows[width + c] = static_cast<float>(0.75 * (whole + middle));
        rows[2 * width + c] = static_cast<float>(1.5 * (outer - inner));
        rows[3 * width + c] = static_cast<float>(whole - 3 * middle);
        rows[4 * width + c] = static_cast<float>(bezier[c]);
    }
}

/// From power form about 0 to one about 1/2, in place.
void centre(std::size_t degree, std::size_t width, double* rows) {
    const auto last = degree * width;
    for (std::size_t first = 0; first < last; first += width) {
        for (auto i = last; i-- > first;) {
            rows[i] += 0.5 * rows[i + width];
        }
    }
}

/// u = k / perPiece, less `middle`.
template <class Lane> std::vector<Lane> stepsFrom(double middle, std::size_t perPiece) {
    const auto steps = static_cast<double>(perPiece);
    std::vector<Lane> x(perPiece + runPadding);
    for (std::size_t k = 0; k < perPiece; ++k) {
        const auto number = static_cast<double>(static_cast<int>(k)); // int: in vectors, too
        x[k] = static_cast<Lane>(number / steps - middle);
    }
    return x;
}

} // namespace

CoefficientMaker::CoefficientMaker(int degree) : degree_(degree) {
    double binomial = 1;
    for (int k = 0; k <= degree; ++k) {
        binomials_.push_back(binomial);
        binomial = binomial * (degree - k) / (k + 1); // a whole number each time
    }
}

void CoefficientMaker::make(const double* bezier, std::size_t width, double* coefficients) const {
    const auto count = binomials_.size();
    if (degree_ == 3) {
        switch (width) {
        case 2: return toCubicPowerForm<2>(bezier, width, coefficients);
        case 3: return toCubicPowerForm<3>(bezier, width, coefficients);
        default: return toCubicPowerForm<0>(bezier, width, coefficients);
        }
    } else if (!isScaled(degree_)) {
        std::copy_n(bezier, count * width, coefficients);
        toPowerForm(binomials_, width, coefficients);
    } else {
        double* const reversed = coefficients + count * width;
        for (std::size_t k = 0; k < count; ++k) {
            for (std::size_t c = 0; c < width; ++c) {
                const auto number = binomials_[k] * bezier[k * width + c];
                coefficients[k * width + c] = number;
                reversed[(count - 1 - k) * width + c] = number;
            }
        }
    }
}

void CoefficientMaker::makeCentred(const double* bezier, std::size_t width,
                                   float* coefficients) const {
    if (degree_ == 3 && width == 2) {
        return toCentredCubic<2>(bezier, coefficients);
    }
    if (degree_ == 3 && width == 3) {
        return toCentredCubic<3>(bezier, coefficients);
    }
    const auto rounded = [](double number) { return static_cast<float>(number); };
    std::vector<double> rows(binomials_.size() * width);
    make(bezier, width, rows.data());
    centre(binomials_.size() - 1, width, rows.data());
    coefficients = std::ranges::transform(rows, coefficients, rounded).out;
    std::transform(bezier, bezier + width, coefficients, rounded);
}

std::vector<Run<double>> runsOf(int degree, std::size_t perPiece) {
    if (!isScaled(degree)) {
        return {{0, 0, perPiece, stepsFrom<double>(0, perPiece), {}}};
    }
    // The first sample beyond u = 1/2; it and those after it are seen from the other end.
    const auto turn = std::min(perPiece / 2 + 1, perPiece);
    const auto empty = [](std::size_t set, std::size_t first, std::size_t count) {
        const std::vector<double> table(count + runPadding);
        return Run<double>{set, first, count, table, table};
    };
    std::vector<Run<double>> runs{empty(0, 0, turn)};
    const auto steps = static_cast<double>(perPiece);
    fillRatios({degree, steps, 0, 1, turn}, runs[0].x.data(), runs[0].scale.data());
    if (turn < perPiece) {
        runs.push_back(empty(1, turn, perPiece - turn));
        const auto left = perPiece - turn;
        fillRatios({degree, steps, static_cast<double>(left), -1, left}, runs[1].x.data(),
                   runs[1].scale.data());
    }
    return runs;
}

Run<float> centredRun(std::size_t perPiece) {
    return {0, 0, perPiece, stepsFrom<float>(0.5, perPiece), {}};
}

} // namespace splineloft::lanes
