#include "ui/extremes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace splineloft::ui {
namespace {

constexpr double nothing = -std::numeric_limits<double>::infinity();

/// A quantity on one piece, with a sign that makes its extreme a greatest value.
class Course {
  public:
    Course(const Motion& motion, Quantity quantity, double sign, std::size_t segment)
        : motion_(motion), quantity_(quantity), sign_(sign), segment_(segment) {}

    double at(double u) const {
        const auto value = valueOf(motion_.at({segment_, u}), quantity_);
        return value ? sign_ * *value : nothing;
    }

  private:
    const Motion& motion_;
    Quantity quantity_;
    double sign_;
    std::size_t segment_;
};

/// Where the greatest value between `low` and `high` lies, if there is but one hill.
double topBetween(const Course& course, double low, double high) {
    constexpr double part = 1 / std::numbers::phi;
    constexpr int sections = 44; // to 1e-9 of the stretch: beyond it a hill is flat in doubles
    double left = high - part * (high - low), right = low + part * (high - low);
    double atLeft = course.at(left), atRight = course.at(right);
    for (int i = 0; i < sections; ++i) {
        if (atLeft >= atRight) {
            high = std::exchange(right, left);
            atRight = atLeft;
            left = high - part * (high - low);
            atLeft = course.at(left);
        } else {
            low = std::exchange(left, right);
            atLeft = atRight;
            right = low + part * (high - low);
            atRight = course.at(right);
        }
    }
    return atLeft >= atRight ? left : right;
}

/// Whether the value at a top is that of a hill, not of a pole: close by it is not far less.
bool isHill(const Course& course, double top, double value, double low, double high) {
    constexpr double closeBy = 1e-3; // of the stretch
    constexpr double farLess = 0.1;
    double beside = nothing;
    for (const double u : {top - closeBy * (high - low), top + closeBy * (high - low)}) {
        if (u > low && u < high) {
            beside = std::max(beside, course.at(u));
        }
    }
    return beside == nothing || value <= 0 || beside >= farLess * value;
}

/// The greatest of a quantity times `sign`.
std::optional<Extreme> greatestOf(std::span<const MotionRun> runs, Quantity quantity, double sign,
                                  const Motion& motion) {
    double greatest = nothing;
    const MotionRun* in = nullptr;
    std::size_t at = 0;
    for (const auto& run : runs) {
        for (std::size_t i = 0; i < run.size(); ++i) {
            const auto value = valueOf(run[i].moment, quantity);
            if (value && sign * *value > greatest) {
                greatest = sign * *value;
                in = &run;
                at = i;
            }
        }
    }
    if (in == nullptr) {
        return std::nullopt;
    }
    const Spot spot = (*in)[at].spot;
    const auto besideIt = [&](std::size_t i, double end) {
        return (*in)[i].spot.segment == spot.segment ? (*in)[i].spot.u : end;
    };
    const double low = at > 0 ? besideIt(at - 1, 0) : spot.u;
    const double high = at + 1 < in->size() ? besideIt(at + 1, 1) : spot.u;
    const Course course(motion, quantity, sign, spot.segment);
    const double u = topBetween(course, low, high);
    const double refined = course.at(u);
    const bool isHigher = refined > greatest;
    const double top = isHigher ? u : spot.u;
    const double value = isHigher ? refined : greatest;
    const Spot there{spot.segment, top};
    return Extreme{there, motion.timeAt(there), sign * value,
                   isHill(course, top, value, low, high)};
}

/// A size, and for how many seconds it lasts.
struct Lasting {
    double size, seconds;
};

std::vector<Lasting> sizesIn(std::span<const MotionRun> runs, Quantity quantity) {
    std::vector<Lasting> sizes;
    for (const auto& run : runs) {
        for (std::size_t i = 0; i < run.size(); ++i) {
            if (const auto value = valueOf(run[i].moment, quantity)) {
                const double from = run[i > 0 ? i - 1 : i].time;
                const double to = run[std::min(i + 1, run.size() - 1)].time;
                sizes.push_back({std::abs(*value), (to - from) / 2});
            }
        }
    }
    std::ranges::sort(sizes, {}, &Lasting::size);
    return sizes;
}

/// Above which size no more than this part of the time is spent. `sizes` rise.
double quantile(std::span<const Lasting> sizes, double part) {
    double all = 0;
    for (const auto& each : sizes) {
        all += each.seconds;
    }
    double sofar = 0;
    for (const auto& each : sizes) {
        sofar += each.seconds;
        if (sofar >= part * all) {
            return each.size;
        }
    }
    return 0;
}

/// The size up to which values are shown; all that are below `rounding` count as none.
double limitOf(std::span<const Lasting> sizes, double rounding) {
    constexpr double room = 5; // times what is usual
    const double greatest = sizes.back().size;
    for (const double part : {0.9, 0.97, 0.99, 0.997}) {
        const double usual = quantile(sizes, part);
        if (usual > rounding) {
            return greatest > 2 * room * usual ? room * usual : greatest;
        }
    }
    return greatest;
}

/// How large the quantity is on a curve that is about as simple as one can be: the way in that
/// time, or a bend by one radian on the whole of it.
double usualSize(std::span<const MotionRun> runs, Quantity quantity, double duration) {
    double way = 0;
    for (const auto& [speed, seconds] : sizesIn(runs, Quantity::speed)) {
        way += speed * seconds;
    }
    const double size = quantity == Quantity::speed          ? way / duration
                        : quantity == Quantity::acceleration ? way / duration / duration
                                                             : 1 / way;
    return std::isnormal(size) ? size : 1;
}

} // namespace

std::optional<Extremes> extremesOf(std::span<const MotionRun> runs, Quantity quantity,
                                   const Motion& motion) {
    const auto greatest = greatestOf(runs, quantity, 1, motion);
    const auto least = greatestOf(runs, quantity, -1, motion);
    return greatest && least ? std::optional(Extremes{*least, *greatest}) : std::nullopt;
}

ValueRange rangeOf(std::span<const MotionRun> runs, Quantity quantity, double duration) {
    constexpr double invisible = 1e-7; // of the usual size
    constexpr double most = 1e300;     // so that sums of a few stay finite
    const auto sizes = sizesIn(runs, quantity);
    const double usual = std::min(usualSize(runs, quantity, duration), most);
    if (sizes.empty() || sizes.back().size <= invisible * usual) {
        return {0, usual, true};
    }
    const double limit = std::min(limitOf(sizes, invisible * usual), most);
    ValueRange range{0, 0, false};
    for (const auto& run : runs) {
        for (const auto& sample : run) {
            const double value = valueOf(sample.moment, quantity).value_or(0);
            range.low = std::max(std::min(range.low, value), -limit);
            range.high = std::min(std::max(range.high, value), limit);
        }
    }
    return range;
}

} // namespace splineloft::ui
