#include "core/spline/fast/lanes/targets.h"

#include <hwy/highway.h>

#include <stdexcept>

namespace splineloft::lanes {
namespace {

std::vector<std::int64_t> targets() {
    static const auto all = hwy::SupportedAndGeneratedTargets(); // before any was set aside
    return all;
}

} // namespace

std::vector<std::string> instructionSets() {
    std::vector<std::string> names;
    for (const auto target : targets()) {
        names.emplace_back(hwy::TargetName(target));
    }
    return names;
}

void useInstructionSet(const std::string& name) {
    std::int64_t chosen = 0; // Highway's word for: no restriction
    for (const auto target : targets()) {
        chosen = hwy::TargetName(target) == name ? target : chosen;
    }
    if (chosen == 0 && !name.empty()) {
        throw std::invalid_argument("there is no instruction set '" + name + "' here");
    }
    hwy::SetSupportedTargetsForTest(chosen);
    // The next call asks anew what is supported.
    hwy::GetChosenTarget().DeInit();
}

} // namespace splineloft::lanes
