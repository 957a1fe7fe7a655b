#include "core/spline/fast/natural_slopes.h"

#include "core/spline/families/tridiagonal.h"
#include "core/spline/fast/lanes/natural_lanes.h"

#include <cstddef>
#include <functional>
#include <memory>

namespace splineloft {
namespace {

/// Row i, of the slopes m, says that the second derivatives of both its pieces agree:
/// h[i] m[i-1] + 2 (h[i-1] + h[i]) m[i] + h[i-1] m[i+1] = 3 (h[i] s[i-1] + h[i-1] s[i])
/// with intervals h[i] = x[i+1] - x[i] and slopes s[i] of the chords. At the ends the second
/// derivative is none: 2 m[0] + m[1] = 3 s[0]. The equations of the second derivatives themselves
/// are as quick, but nothing here gets larger than the slopes do.
class SlopeRows {
  public:
    SlopeRows(std::span<const double> x, std::span<const double> y) : x_(x), y_(y) {}

    families::Rows<double> operator()(std::size_t first, std::size_t last) {
        const std::size_t count = last - first;
        reserve(count);
        // Of intervals and chords, entry k is the piece before row first + k. Those that are
        // missing at the ends are as long as their neighbours, and level.
        const bool atStart = first == 0;
        const bool atEnd = last == x_.size();
        const std::size_t begin = atStart ? 1 : 0;
        const std::size_t end = atEnd ? count : count + 1;
        lanes::measureChords(x_.data() + first + begin - 1, y_.data() + first + begin - 1,
                             end - begin, intervals_ + begin, chords_ + begin);
        if (atStart) {
            intervals_[0] = intervals_[1];
            chords_[0] = 0;
        }
        if (atEnd) {
            intervals_[count] = intervals_[count - 1];
            chords_[count] = 0;
        }
        lanes::formSlopeRows(intervals_, chords_, count, diagonal_, right_);
        if (atStart) {
            diagonal_[0] = 2 * intervals_[0];
        }
        if (atEnd) {
            diagonal_[count - 1] = 2 * intervals_[count];
        }
        return {{intervals_ + 1, count}, {diagonal_, count}, {intervals_, count}, {right_, count}};
    }

  private:
    void reserve(std::size_t count) {
        if (count > room_) {
            room_ = count;
            memory_ = std::make_unique_for_overwrite<double[]>(4 * count + 2);
            intervals_ = memory_.get();
            chords_ = intervals_ + count + 1;
            diagonal_ = chords_ + count + 1;
            right_ = diagonal_ + count;
        }
    }

    std::span<const double> x_, y_;
    std::size_t room_ = 0;
    std::unique_ptr<double[]> memory_; ///< of the four that follow
    double* intervals_ = nullptr;
    double* chords_ = nullptr;
    double* diagonal_ = nullptr;
    double* right_ = nullptr;
};

} // namespace

void solveNaturalSlopes(std::span<const double> x, std::span<const double> y,
                        std::span<double> slopes) {
    SlopeRows rows(x, y);
    families::solveInChains(std::ref(rows), slopes);
}

} // namespace splineloft
