#include "ui/revisions.h"

#include <algorithm>
#include <atomic>

namespace splineloft::ui {
namespace {

std::uint64_t nextIdentity() {
    static std::atomic<std::uint64_t> last{0};
    return ++last;
}

} // namespace

Revisions::Revisions(std::size_t blocks) : identity_(nextIdentity()), stamps_(blocks, revision_) {}

void Revisions::note(const Range& blocks) {
    ++revision_;
    std::fill(stamps_.begin() + static_cast<std::ptrdiff_t>(blocks.first),
              stamps_.begin() + static_cast<std::ptrdiff_t>(blocks.last), revision_);
}

std::vector<Range> Revisions::since(std::uint64_t revision) const {
    std::vector<Range> changed;
    for (std::size_t i = 0; i < stamps_.size(); ++i) {
        if (stamps_[i] > revision) {
            if (!changed.empty() && changed.back().last == i) {
                ++changed.back().last;
            } else {
                changed.push_back({i, i + 1});
            }
        }
    }
    return changed;
}

} // namespace splineloft::ui
