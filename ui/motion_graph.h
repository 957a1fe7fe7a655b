// The course of speed, acceleration and curvature over a whole motion, sampled finely enough to be
// drawn, with its least and greatest values and a range that shows most of it.
#pragma once

#include "core/spline/measure/motion.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace splineloft::ui {

enum class Quantity { speed, acceleration, curvature };
inline constexpr std::array allQuantities = {Quantity::speed, Quantity::acceleration,
                                             Quantity::curvature};

/// A quantity at one moment: units of length / s, units of length / s^2, 1 / unit of length.
std::optional<double> valueOf(const Movement& moment, Quantity quantity);

struct MotionSample {
    Spot spot;
    double time = 0; ///< seconds
    Movement moment;
};

/// Samples that follow each other without a jump.
using MotionRun = std::vector<MotionSample>;

/// A place where a quantity is least or greatest of all.
struct Extreme {
    Spot spot;
    double time = 0; ///< seconds
    double value = 0;
    bool bounded = true; ///< if not, it grows beyond all bounds there, as at a cusp
};

struct Extremes {
    Extreme least, greatest;
};

/// Values to be shown; zero is among them.
struct ValueRange {
    double low = 0, high = 1;
    bool vanishes = false; ///< all values are rounding of zero
};

class MotionGraph {
  public:
    /// Takes two samples for each of so many columns, and both ends of every piece; of more pieces
    /// than can be told apart in them, three samples a column and no more.
    MotionGraph(const Pieces& pieces, const Motion& motion, std::size_t columns);

    std::span<const MotionRun> runs() const { return runs_; }
    /// The times at which one piece gives way to the next; none where they are too many.
    std::span<const double> joints() const { return joints_; }
    /// Nothing where the quantity has no value anywhere.
    const std::optional<Extremes>& extremes(Quantity quantity) const {
        return of_[static_cast<std::size_t>(quantity)].extremes;
    }
    /// From zero to the values that are reached, but for a rare few that are far greater than all
    /// others.
    const ValueRange& range(Quantity quantity) const {
        return of_[static_cast<std::size_t>(quantity)].range;
    }

  private:
    struct Summary {
        std::optional<Extremes> extremes;
        ValueRange range;
    };

    void sampleEachPiece(const Pieces& pieces, const Motion& motion, std::size_t columns);
    void sampleWhole(const Motion& motion, std::size_t columns);
    Summary summaryOf(Quantity quantity, const Motion& motion) const;

    std::vector<MotionRun> runs_;
    std::vector<double> joints_;
    std::array<Summary, allQuantities.size()> of_;
};

} // namespace splineloft::ui
