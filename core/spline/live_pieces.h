// The pieces of a curve whose points are being moved: only those are blended anew that a moved
// point reaches. Bit for bit what blending all of them gives.
#pragma once

#include "core/spline/blending.h"

#include <optional>
#include <vector>

namespace splineloft {

/// Which points of a curve are elsewhere than before, and which tangents.
struct Moves {
    std::vector<Range> points, tangents;
};

/// How one curve differs from another; nothing where in more than in where its points and tangents
/// are. Takes the time of comparing the memory of both.
std::optional<Moves> movesBetween(const Curve& before, const Curve& after);

/// A curve's pieces, with what it takes to bring them up to date.
class LivePieces {
  public:
    /// As `piecesOf` for a spline without problem.
    LivePieces(const Spline& spline, const PointsView& points, const PointsView& tangents);

    const Pieces& pieces() const { return pieces_; }
    Pieces take() && { return std::move(pieces_); }

    /// Follows a curve that differs from the one before by `moves`. Returns the pieces that may
    /// have changed; the knots may have as well. In local families this takes time for them alone,
    /// and where chords space the knots, an addition for every point; in others, for all.
    std::vector<Range> follow(const Curve& curve, const Moves& moves);

  private:
    using Columns = std::vector<std::vector<double>>;

    void fill(const PointsView& points, const PointsView& tangents, const Range& places);
    void blend(const Range& range);
    void moveKnots(std::span<const Range> intervals);
    std::vector<Range> piecesReading(std::span<const Range> places) const;

    const Family* family_;
    bool closed_;
    Arrangement arrangement_;
    Settings settings_;
    // Each of the numbers of a Bézier point, of all places: coordinates, and the weight.
    Columns columns_, tangentColumns_;
    Pieces pieces_;
};

} // namespace splineloft
