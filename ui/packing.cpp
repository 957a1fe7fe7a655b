#include "ui/packing.h"

#include <algorithm>

namespace splineloft::ui {

std::array<float, 2> split(double number) {
    const auto high = static_cast<float>(number);
    return {high, static_cast<float>(number - static_cast<double>(high))};
}

std::vector<float> packed(std::span<const PlanePoint> points) {
    std::vector<float> numbers(4 * points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto [x, restOfX] = split(points[i].x);
        const auto [y, restOfY] = split(points[i].y);
        numbers[4 * i] = x;
        numbers[4 * i + 1] = y;
        numbers[4 * i + 2] = restOfX;
        numbers[4 * i + 3] = restOfY;
    }
    return numbers;
}

Range pointsOf(const PieceTable& table, const Range& blocks) {
    return {blocks.first * table.blockPoints,
            std::min(blocks.last * table.blockPoints, table.points.size())};
}

} // namespace splineloft::ui
