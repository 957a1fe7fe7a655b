#include "ui/track.h"

#include <algorithm>
#include <cmath>

namespace splineloft::ui {
namespace {

// How near to the neutral value the knob is drawn to it: part of the track.
constexpr double magnet = 0.012;

/// Few digits, as a hand can set them: a thousandth of the range, three digits of a ratio.
double tidied(const Parameter& parameter, double value) {
    if (parameter.scale == Scale::whole) {
        return std::round(value);
    }
    const double size = parameter.scale == Scale::ratio
                            ? std::abs(value)
                            : (parameter.sliderMost - parameter.sliderLeast) / 2;
    const double steps = std::pow(10.0, 3 - std::ceil(std::log10(size)));
    return std::round(value * steps) / steps;
}

} // namespace

double trackPosition(const Parameter& parameter, double value) {
    const double least = parameter.sliderLeast;
    const double most = parameter.sliderMost;
    return parameter.scale == Scale::ratio ? std::log(value / least) / std::log(most / least)
                                           : (value - least) / (most - least);
}

double valueOnTrack(const Parameter& parameter, double position) {
    const double at = std::clamp(position, 0.0, 1.0);
    if (std::abs(at - trackPosition(parameter, parameter.neutral)) < magnet) {
        return parameter.neutral;
    }
    const double least = parameter.sliderLeast;
    const double most = parameter.sliderMost;
    const double value = parameter.scale == Scale::ratio ? least * std::pow(most / least, at)
                                                         : least + (most - least) * at;
    return std::clamp(tidied(parameter, value), least, most);
}

} // namespace splineloft::ui
