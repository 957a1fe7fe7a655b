#include "core/spline/change/basis_change.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace splineloft {

RationalMatrix::RationalMatrix(int size)
    : size_(size), entries_(static_cast<std::size_t>(size) * static_cast<std::size_t>(size)) {}

RationalMatrix::RationalMatrix(int size, std::vector<Rational> entries)
    : size_(size), entries_(std::move(entries)) {}

std::int64_t RationalMatrix::denominator() const {
    std::int64_t common = 1;
    for (const Rational entry : entries_) {
        const std::int64_t more = entry.denominator() / std::gcd(common, entry.denominator());
        common = (Rational(common) * Rational(more)).numerator();
    }
    return common;
}

RationalMatrix operator*(const RationalMatrix& a, const RationalMatrix& b) {
    RationalMatrix result(a.size());
    for (int row = 0; row < a.size(); ++row) {
        for (int column = 0; column < a.size(); ++column) {
            Rational sum;
            for (int k = 0; k < a.size(); ++k) {
                sum = sum + a.at(row, k) * b.at(k, column);
            }
            result.at(row, column) = sum;
        }
    }
    return result;
}

std::string textOf(const RationalMatrix& matrix) {
    const auto denominator = Rational(matrix.denominator());
    const std::string factor =
        denominator == Rational(1) ? "" : "1/" + std::to_string(denominator.numerator()) + " ";
    std::vector<std::string> cells;
    std::size_t widest = 0;
    for (int row = 0; row < matrix.size(); ++row) {
        for (int column = 0; column < matrix.size(); ++column) {
            cells.push_back(textOf(matrix.at(row, column) * denominator));
            widest = std::max(widest, cells.back().size());
        }
    }
    std::string text;
    for (int row = 0; row < matrix.size(); ++row) {
        text += row == 0 ? factor : std::string(factor.size(), ' ');
        text += '[';
        for (int column = 0; column < matrix.size(); ++column) {
            const auto& cell = cells[static_cast<std::size_t>(row * matrix.size() + column)];
            text += std::string(widest + 1 - cell.size(), ' ') + cell;
        }
        text += " ]\n";
    }
    return text;
}

} // namespace splineloft
