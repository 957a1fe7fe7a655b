// Curves out of bytes: whatever a fuzzer thinks of becomes a curve, most often a nasty one.
#pragma once

#include "core/spline/curve.h"

#include <cstdint>
#include <span>

namespace splineloft::fuzz {

/// Reads values off the front of the bytes; zeros once they are used up.
class Bytes {
  public:
    Bytes(const std::uint8_t* data, std::size_t size) : rest_(data, size) {}

    std::uint8_t byte();
    /// 0 .. most.
    std::size_t upTo(std::size_t most) { return byte() % (most + 1); }
    bool flip() { return byte() % 2 == 1; }
    /// A small fraction, a special value, or any bit pattern at all.
    double number();
    /// From 0 to 1, both ends often.
    double part();

  private:
    std::span<const std::uint8_t> rest_;
};

/// A curve of any family, with up to 24 points of 1 to 4 coordinates, perhaps knots, weights and
/// local parameters of its own. It may have problems.
Curve curveFrom(Bytes& bytes);

/// Stops the program, for the fuzzer to notice, unless `holds`.
void require(bool holds, const char* what);

} // namespace splineloft::fuzz
