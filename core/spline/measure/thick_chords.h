// Where the pieces of a curve lie, roughly: bounds for finding the nearest one without looking at
// all.
//
// A run of pieces lies within some radius of the chord from its first point to its last. Around a
// smooth curve such a thick chord is far tighter than a box. Sixteen thick chords are a group, with
// a thick chord of its own; sixteen groups are a group again, up to one group of all.
#pragma once

#include "core/spline/piece.h"

#include <array>
#include <cstddef>
#include <vector>

namespace splineloft {

/// A tree of thick chords over the pieces of a curve.
class ThickChords {
  public:
    static constexpr std::size_t groupSize = 16;

    explicit ThickChords(const Pieces& pieces);

    /// Levels of the tree; 0 where there are no pieces. On level 0 the members of the groups are
    /// pieces, on each higher one the groups of the level below.
    std::size_t levels() const { return levels_.size(); }
    std::size_t members(std::size_t level) const { return levels_[level].members; }

    /// Lower bounds of the distances from a place to the members of a group; infinity for what is
    /// missing in the last group. All coordinates should be of sizes whose squares are numbers.
    std::array<double, groupSize> distances(std::size_t level, std::size_t group,
                                            const Point& place) const;

    /// The largest coordinate of the curve's Bézier points.
    double farthest() const { return farthest_; }

  private:
    struct Level {
        std::size_t members = 0;
        // Group after group; in each, numbers of 16 members beside each other: the starts'
        // coordinates, one after the other, the chords', 1 / length^2 of the chord, the radius.
        std::vector<double> numbers;
    };

    std::size_t rows() const { return 2 * dimension_ + 2; }
    void addLevel(const Pieces& pieces, std::size_t piecesAMember);

    std::size_t dimension_ = 0;
    double farthest_ = 0;
    std::vector<Level> levels_;
};

} // namespace splineloft
