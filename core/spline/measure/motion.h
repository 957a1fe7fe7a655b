// A curve as it is played: where it is at every moment, and how fast and how hard it goes there.
#pragma once

#include "core/spline/measure/length.h"
#include "core/spline/measure/sample.h"
#include "core/spline/piece.h"

#include <optional>
#include <span>
#include <vector>

namespace splineloft {

/// What a motion does at one spot. Derivatives are by time, in seconds, of all coordinates. Each is
/// nothing where it does not exist or is too large for a number; none is ever not-a-number.
struct Movement {
    std::optional<double> speed;        ///< |dC/dt|, units of length / s
    std::optional<double> acceleration; ///< |d2C/dt2|, units of length / s^2
    /// 1 / unit of length, as in Jet; zero on curves of one coordinate, which cannot bend, and on
    /// straight pieces, where a jet close to rest has but rounding.
    std::optional<double> curvature;
};

/// A motion along a curve from its start to its end in a given time. A joint is no part of it: at
/// its spots are the one-sided values. Keeps references to the pieces and lengths it is made of.
class Motion {
  public:
    /// Equal times for equal steps of the parameter t. By the chain rule speed and acceleration are
    /// the derivatives by t times (range of t / duration), once and twice. A piece of no interval
    /// is passed in no time: it has neither. Throws std::invalid_argument unless `duration`, in
    /// seconds, is finite and above zero.
    static Motion evenInParameter(const Pieces& pieces, double duration);
    /// Equal times for equal lengths: the speed is length / duration everywhere, and all of the
    /// acceleration is centripetal, speed^2 x |curvature| (Huygens 1673). There is none where the
    /// curvature has no value. A curve of no length rests, whatever the parameter does.
    /// Throws std::invalid_argument unless `duration`, in seconds, is finite and above zero.
    static Motion evenInLength(const Pieces& pieces, const ArcLength& lengths, double duration);

    double duration() const { return duration_; }
    /// Seconds from the start until the spot is reached: 0 to the duration.
    double timeAt(Spot spot) const;
    /// The spot that is reached at a time; the nearer end where it lies outside. The inverse of
    /// `timeAt` but for pieces that are passed in no time.
    Spot spotAt(double time) const;
    /// The same for many times that never fall: where they are close together, much quicker.
    std::vector<Spot> spotsAt(std::span<const double> times) const;
    Movement at(Spot spot) const;

  private:
    Motion(const Pieces& pieces, const ArcLength* lengths, double duration);

    const Pieces* pieces_;
    const ArcLength* lengths_; ///< null: even in the parameter
    double duration_;
};

} // namespace splineloft
