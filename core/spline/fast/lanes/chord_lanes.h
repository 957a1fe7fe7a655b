// Bounds of the distances from a place to many thick chords, compiled for every set of
// instructions: which of them the nearest spot may lie in.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace splineloft::lanes {

inline constexpr std::size_t chordPadding = 16;
inline constexpr std::size_t mostChords = 64;

/// Thick chords beside each other: what is in a chord lies within its radius of it.
struct ChordRows {
    /// Rows of `stride` numbers, one a chord: coordinate by coordinate the starts, then the ways to
    /// the ends, then 1 / length^2, then the radii. A chord that is not there starts beyond all
    /// places.
    const double* numbers = nullptr;
    std::size_t stride = 0; ///< a multiple of `chordPadding`, `mostChords` at most
    std::size_t dimension = 0;

    static constexpr std::size_t rowsFor(std::size_t dimension) { return 2 * dimension + 2; }
};

/// What is asked of the chords.
struct ChordQuestion {
    const double* place = nullptr;
    double rounding = 0; ///< of distances from the place
    /// What is in a chord leads from its start to its end, but may jump this far. So it comes as
    /// near as the radius and this to every point of the chord.
    double gap = 0;
    double limit = 0; ///< nothing farther away is wanted
};

/// A chord, in the last bits, and a lower bound of the distance to what is in it, in one number
/// that sorts by the bound. What the bound loses of its last digits makes it lower.
using Candidate = std::uint64_t;
inline constexpr Candidate chordMask = mostChords - 1;

/// The chords that the nearest spot may lie in.
struct ChordChoice {
    double limit; ///< as in the question, or lower
    std::size_t count;
    std::array<Candidate, mostChords> candidates; ///< the first `count`, in any order
};

ChordChoice chooseChords(const ChordRows& chords, const ChordQuestion& question);

} // namespace splineloft::lanes
