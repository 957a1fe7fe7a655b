// Where the pieces of a curve lie, roughly: bounds for finding the nearest one without looking at
// all.
//
// A run of pieces lies within some radius of a chord: the way from its first point to its last,
// moved sideways into the middle of the run. Around a smooth curve such a thick chord is far
// tighter than a box. Sixteen thick chords are a group, with a thick chord of its own, and so on,
// until so few are left that all are looked at.
#pragma once

#include "core/spline/fast/lanes/chord_lanes.h"
#include "core/spline/piece.h"

#include <cstddef>
#include <span>
#include <vector>

namespace splineloft {

/// A tree of thick chords over the pieces of a curve.
class ThickChords {
  public:
    explicit ThickChords(const Pieces& pieces);

    /// Levels of the tree; 0 where there are no pieces. On level 0 the members of the groups are
    /// pieces, on each higher one the groups of the level below. The last level is one group, of
    /// up to `lanes::mostChords`.
    std::size_t levels() const { return levels_.size(); }
    /// The members of a group, the first of which is `firstOf` it.
    lanes::ChordRows group(std::size_t level, std::size_t group) const {
        const auto stride = levels_[level].stride;
        const auto size = stride * lanes::ChordRows::rowsFor(dimension_);
        return {&levels_[level].numbers[group * size], stride, dimension_};
    }
    std::size_t firstOf(std::size_t level, std::size_t group) const {
        return group * levels_[level].stride;
    }

    /// The largest coordinate of the curve's Bézier points.
    double farthest() const { return farthest_; }
    /// The longest way between the end of a piece and the start of the next.
    double gap() const { return gap_; }

  private:
    static constexpr std::size_t groupSize = lanes::chordPadding;

    struct Level {
        std::size_t members;
        std::size_t stride;          ///< of its groups
        std::vector<double> numbers; ///< group after group, as in lanes::ChordRows
    };

    void addLevel(std::span<const double> places, std::size_t numbersAMember);

    std::size_t dimension_ = 0;
    double farthest_ = 0;
    double gap_ = 0;
    std::vector<Level> levels_;
};

} // namespace splineloft
