#include "core/spline/measure/thick_chords.h"

#include "core/spline/algebra/scale.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace splineloft {
namespace {

// Where chords start that are not there: the square is a number, and no place is as far away.
constexpr double beyondAll = 0x1p500;

std::size_t quotientRoundedUp(std::size_t a, std::size_t b) {
    return (a + b - 1) / b;
}

/// The coordinates of all Bézier points.
std::vector<double> placesOf(const Pieces& pieces) {
    std::vector<double> places;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (int k = 0; k <= pieces.degree(); ++k) {
            const Point place = pieces[i].bezierPoint(k);
            places.insert(places.end(), place.coordinates().begin(), place.coordinates().end());
        }
    }
    return places;
}

/// A chord around a run of places.
class Chord {
  public:
    Chord(std::span<const double> places, std::size_t dimension)
        : places_(places), start_(places.first(dimension)), way_(places.last(dimension)) {
        way_ -= start_;
        const double over = 1 / dot(way_, way_);
        overLength2_ = std::isfinite(over) ? over : 0;
        moveIntoTheMiddle();
        for (std::size_t i = 0; i < places.size(); i += dimension) {
            const Point off = offAt(i);
            const double along = std::clamp(dot(off, way_) * overLength2_, 0.0, 1.0);
            radius_ = std::max(radius_, norm(off - along * way_));
        }
    }

    const Point& start() const { return start_; }
    const Point& way() const { return way_; }
    double overLength2() const { return overLength2_; } ///< 0 for a chord without length
    double radius() const { return radius_; }

  private:
    /// From the start to the place at number i.
    Point offAt(std::size_t i) const {
        return Point(places_.subspan(i, static_cast<std::size_t>(start_.dimension()))) - start_;
    }

    void moveIntoTheMiddle() {
        Point least(start_.dimension()), most(start_.dimension());
        for (std::size_t i = 0; i < places_.size();
             i += static_cast<std::size_t>(start_.dimension())) {
            const Point off = offAt(i);
            const Point aside = off - (dot(off, way_) * overLength2_) * way_;
            for (int c = 0; c < start_.dimension(); ++c) {
                least[c] = std::min(least[c], aside[c]);
                most[c] = std::max(most[c], aside[c]);
            }
        }
        start_ += 0.5 * (least + most);
    }

    std::span<const double> places_;
    Point start_, way_;
    double overLength2_ = 0;
    double radius_ = 0;
};

} // namespace

ThickChords::ThickChords(const Pieces& pieces)
    : dimension_(static_cast<std::size_t>(pieces.dimension())) {
    if (pieces.empty()) {
        return;
    }
    const auto places = placesOf(pieces);
    farthest_ = largestOf(places);
    for (std::size_t i = 1; i < pieces.size(); ++i) {
        gap_ = std::max(
            gap_, distance(pieces[i - 1].bezierPoint(pieces.degree()), pieces[i].bezierPoint(0)));
    }
    const auto perPiece = places.size() / pieces.size();
    addLevel(places, perPiece);
    for (auto run = groupSize; levels_.back().members > lanes::mostChords; run *= groupSize) {
        addLevel(places, run * perPiece);
    }
}

void ThickChords::addLevel(std::span<const double> places, std::size_t numbersAMember) {
    const auto members = quotientRoundedUp(places.size(), numbersAMember);
    const auto padded = quotientRoundedUp(members, groupSize) * groupSize;
    const auto stride = members <= lanes::mostChords ? padded : groupSize;
    const auto rows = lanes::ChordRows::rowsFor(dimension_);
    Level level{members, stride, std::vector<double>(padded * rows, 0)};
    for (std::size_t m = 0; m < padded; ++m) {
        double* const column = &level.numbers[m / stride * rows * stride + m % stride];
        if (m >= members) {
            *column = beyondAll;
            continue;
        }
        const auto first = m * numbersAMember;
        const auto count = std::min(numbersAMember, places.size() - first);
        const Chord chord(places.subspan(first, count), dimension_);
        for (std::size_t c = 0; c < dimension_; ++c) {
            column[c * stride] = chord.start()[static_cast<int>(c)];
            column[(dimension_ + c) * stride] = chord.way()[static_cast<int>(c)];
        }
        column[2 * dimension_ * stride] = chord.overLength2();
        // Positions are rounded, and so is the radius.
        column[(rows - 1) * stride] = chord.radius() * (1 + 8 * epsilon) + 64 * epsilon * farthest_;
    }
    levels_.push_back(std::move(level));
}

} // namespace splineloft
