// Which piece a parameter value falls on, quickly. Even knots need no search. Other knots are
// sorted into equal buckets, about two a piece, and what shares a bucket is halved without a
// branch, as a branch that follows random t is mispredicted half of the time.
#pragma once

#include "core/spline/fast/lanes/spot_lanes.h"
#include "core/spline/piece.h"

#include <cstdint>
#include <vector>

namespace splineloft::lanes {

/// Finds the spots that KnotLine::locate finds.
class KnotFinder {
  public:
    KnotFinder() = default;
    /// `knots` of at least one piece.
    explicit KnotFinder(const KnotLine& knots);

    /// For each of `count` t the piece and u. The three have room for `spotPadding` more.
    void locate(const double* t, std::size_t count, std::int32_t* pieces, double* u) const;

  private:
    bool areEven() const;
    void fillBuckets();
    std::size_t bucketOf(double t) const;
    Spot search(double t) const;

    std::vector<double> knots_;
    std::size_t last_ = 0; ///< the last piece that has an interval
    bool even_ = false;    ///< knot i is the first + i intervals, without rounding
    EvenKnots evenKnots_;
    double bucketsPerT_ = 0; ///< buckets in a unit of t
    /// Of each bucket the piece that begins last before it; one entry more than buckets.
    std::vector<std::uint32_t> before_;
    std::size_t firstStep_ = 0; ///< a power of two: halves the fullest bucket
};

} // namespace splineloft::lanes
