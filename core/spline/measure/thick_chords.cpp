#include "core/spline/measure/thick_chords.h"

#include "core/spline/algebra/two.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace splineloft {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// A chord in the making.
struct Chord {
    Point start, way;
    double overLength2 = 0; // 1 / |way|^2, or 0 for a chord without length
    double radius = 0;

    Chord(const Point& from, const Point& to) : start(from), way(to - from) {
        const double over = 1 / dot(way, way);
        overLength2 = std::isfinite(over) ? over : 0;
    }

    void widenTo(const Point& place) {
        const Point off = place - start;
        const double along = std::clamp(dot(off, way) * overLength2, 0.0, 1.0);
        radius = std::max(radius, norm(off - along * way));
    }
};

} // namespace

ThickChords::ThickChords(const Pieces& pieces)
    : dimension_(static_cast<std::size_t>(pieces.dimension())) {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (int k = 0; k <= pieces.degree(); ++k) {
            const Point place = pieces[i].bezierPoint(k);
            for (const double x : place.coordinates()) {
                farthest_ = std::max(farthest_, std::abs(x));
            }
        }
    }
    std::size_t piecesAMember = 1;
    while (!pieces.empty() && (levels_.empty() || levels_.back().members > groupSize)) {
        addLevel(pieces, piecesAMember);
        piecesAMember *= groupSize;
    }
}

void ThickChords::addLevel(const Pieces& pieces, std::size_t piecesAMember) {
    Level level;
    level.members = (pieces.size() + piecesAMember - 1) / piecesAMember;
    const auto groups = (level.members + groupSize - 1) / groupSize;
    level.numbers.assign(groups * rows() * groupSize, 0);
    for (std::size_t m = 0; m < groups * groupSize; ++m) {
        double* const column = &level.numbers[m / groupSize * rows() * groupSize + m % groupSize];
        double* const radius = column + (rows() - 1) * groupSize;
        if (m >= level.members) {
            *radius = -std::numeric_limits<double>::infinity();
            continue;
        }
        const auto first = m * piecesAMember;
        const auto after = std::min(first + piecesAMember, pieces.size());
        Chord chord(pieces[first].bezierPoint(0), pieces[after - 1].bezierPoint(pieces.degree()));
        for (auto i = first; i < after; ++i) {
            for (int k = 0; k <= pieces.degree(); ++k) {
                chord.widenTo(pieces[i].bezierPoint(k));
            }
        }
        for (std::size_t c = 0; c < dimension_; ++c) {
            column[c * groupSize] = chord.start[static_cast<int>(c)];
            column[(dimension_ + c) * groupSize] = chord.way[static_cast<int>(c)];
        }
        column[2 * dimension_ * groupSize] = chord.overLength2;
        // Positions are rounded, and so is the radius.
        *radius = chord.radius * (1 + 8 * epsilon) + 64 * epsilon * farthest_;
    }
    levels_.push_back(std::move(level));
}

namespace {

constexpr auto size = ThickChords::groupSize;

Two load(const double* from) {
    return Two{from[0], from[1]};
}

/// Squared distances of a place from 16 chords. `numbers` are those of a group.
template <std::size_t dimension>
void squaresTo(const double* numbers, const Point& place, std::array<double, size>& squares) {
    const double* const starts = numbers;
    const double* const ways = starts + dimension * size;
    const double* const overLength2 = ways + dimension * size;
    constexpr Two none = {}, all = {1, 1};
    for (std::size_t m = 0; m < size; m += 2) {
        std::array<Two, dimension> off, way;
        Two along = {};
        for (std::size_t c = 0; c < dimension; ++c) {
            off[c] = place[static_cast<int>(c)] - load(starts + c * size + m);
            way[c] = load(ways + c * size + m);
            along += off[c] * way[c];
        }
        along *= load(overLength2 + m);
        along = along > none ? along : none;
        along = along < all ? along : all;
        Two sum = {};
        for (std::size_t c = 0; c < dimension; ++c) {
            const Two rest = off[c] - along * way[c];
            sum += rest * rest;
        }
        squares[m] = sum[0];
        squares[m + 1] = sum[1];
    }
}

/// The same in any dimension.
void squaresTo(const double* numbers, const Point& place, std::array<double, size>& squares) {
    const auto dimension = static_cast<std::size_t>(place.dimension());
    const double* const starts = numbers;
    const double* const ways = starts + dimension * size;
    const double* const overLength2 = ways + dimension * size;
    for (std::size_t m = 0; m < size; ++m) {
        double along = 0;
        for (std::size_t c = 0; c < dimension; ++c) {
            along += (place[static_cast<int>(c)] - starts[c * size + m]) * ways[c * size + m];
        }
        along = std::clamp(along * overLength2[m], 0.0, 1.0);
        squares[m] = 0;
        for (std::size_t c = 0; c < dimension; ++c) {
            const double off =
                place[static_cast<int>(c)] - starts[c * size + m] - along * ways[c * size + m];
            squares[m] += off * off;
        }
    }
}

} // namespace

std::array<double, size> ThickChords::distances(std::size_t level, std::size_t group,
                                                const Point& place) const {
    const double* const numbers = &levels_[level].numbers[group * rows() * size];
    const double* const radius = numbers + (rows() - 1) * size;
    std::array<double, size> distances;
    switch (dimension_) {
    case 2: squaresTo<2>(numbers, place, distances); break;
    case 3: squaresTo<3>(numbers, place, distances); break;
    default: squaresTo(numbers, place, distances);
    }
    double largest = 0;
    for (const double x : place.coordinates()) {
        largest = std::max(largest, std::abs(x));
    }
    takeRoots(distances);
    const double rounding = 16 * epsilon * largest;
    for (std::size_t m = 0; m < size; m += 2) {
        constexpr Two none = {};
        const Two bound = load(&distances[m]) * (1 - 8 * epsilon) - rounding - load(radius + m);
        const Two positive = bound > none ? bound : none;
        distances[m] = positive[0];
        distances[m + 1] = positive[1];
    }
    return distances;
}

} // namespace splineloft
