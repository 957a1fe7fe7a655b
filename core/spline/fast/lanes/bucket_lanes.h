// Which of equally wide buckets values fall into, and a table of that, compiled for every set of
// instructions.
#pragma once

#include "core/spline/fast/buckets.h"

#include <cstddef>
#include <cstdint>

namespace splineloft::lanes {

/// The buckets of rising values, as `of` says.
void findBuckets(const Buckets& buckets, const double* values, std::size_t count,
                 std::uint32_t* found);

/// Of so many buckets beside each other, the entries are written at once.
inline constexpr std::size_t bucketsAhead = 4;

/// Behind the bucket of each of `count` points, entries get the point's number, up to the bucket of
/// the next point, and at least `bucketsAhead` of them. The numbers of the points begin with
/// `first`; buckets[-1] is that of the point before.
void enterBuckets(const std::uint32_t* buckets, std::size_t count, std::uint32_t first,
                  std::uint32_t* entries);

/// Whether any of `count` buckets is the one `distance` places before.
bool repeats(const std::uint32_t* buckets, std::size_t count, std::size_t distance);

} // namespace splineloft::lanes
