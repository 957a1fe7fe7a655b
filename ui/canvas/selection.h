// The selected points: a set that is cheap to copy, as every event does.
#pragma once

#include "core/document/document.h"

#include <algorithm>
#include <initializer_list>
#include <utility>
#include <vector>

namespace splineloft::ui {

/// Points by curve and number, each once, in this order. Ten thousand of them are copied in the
/// time that a tree of them takes to copy a few. Putting them in one by one is quick in order only.
class Selection {
  public:
    Selection() = default;
    Selection(std::initializer_list<PointId> ids) : Selection(std::vector(ids)) {}
    /// In any order, twice if need be.
    explicit Selection(std::vector<PointId> ids) : ids_(std::move(ids)) {
        std::ranges::sort(ids_);
        ids_.erase(std::unique(ids_.begin(), ids_.end()), ids_.end());
    }

    bool operator==(const Selection&) const = default;
    auto begin() const { return ids_.begin(); }
    auto end() const { return ids_.end(); }
    std::size_t size() const { return ids_.size(); }
    bool empty() const { return ids_.empty(); }
    const std::vector<PointId>& ids() const { return ids_; }
    bool contains(const PointId& id) const { return std::ranges::binary_search(ids_, id); }

    void clear() { ids_.clear(); }

    void insert(const PointId& id) {
        const auto at =
            ids_.empty() || ids_.back() < id ? ids_.end() : std::ranges::lower_bound(ids_, id);
        if (at == ids_.end() || *at != id) {
            ids_.insert(at, id);
        }
    }

    void insert(const Selection& others) {
        ids_.insert(ids_.end(), others.begin(), others.end());
        *this = Selection(std::move(ids_));
    }

    void erase(const PointId& id) { std::erase(ids_, id); }

    template <class Condition> void eraseIf(Condition condition) { std::erase_if(ids_, condition); }

  private:
    std::vector<PointId> ids_; ///< sorted
};

} // namespace splineloft::ui
