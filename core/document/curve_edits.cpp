#include "core/document/curve_edits.h"

#include "core/document/change.h"
#include "core/document/reversal.h"

#include <algorithm>
#include <set>

namespace splineloft {
Document duplicateCurve(const Document& document, std::size_t curve) {
    Document next = document;
    const auto place = next.curves.begin() + static_cast<std::ptrdiff_t>(curve);
    next.curves.insert(place + 1, document.curves[curve]);
    return renameCurve(next, curve + 1, document.curves[curve]->name + " copy");
}

Document reverseCurve(const Document& document, std::size_t curve) {
    Document next = document;
    next.curves[curve] = reversed(document.curves[curve]);
    return next;
}

Document moveCurve(const Document& document, std::size_t from, std::size_t to) {
    Document next = document;
    const auto at = [&](std::size_t index) {
        return next.curves.begin() + static_cast<std::ptrdiff_t>(index);
    };
    if (from < to) {
        std::rotate(at(from), at(from + 1), at(to + 1));
    } else {
        std::rotate(at(to), at(from), at(from + 1));
    }
    return next;
}

Document renameCurve(const Document& document, std::size_t curve, std::string name) {
    return changed(document, curve, [&](Curve& renamed) { renamed.name = std::move(name); });
}

Document setLook(const Document& document, std::size_t curve, const Look& look) {
    Document next = document;
    next.curves[curve].look = look;
    return next;
}

Document removeCurves(const Document& document, std::span<const std::size_t> curves) {
    const std::set<std::size_t> gone(curves.begin(), curves.end());
    Document next = document;
    next.curves.clear();
    for (std::size_t i = 0; i < document.curves.size(); ++i) {
        if (!gone.contains(i)) {
            next.curves.push_back(document.curves[i]);
        }
    }
    return next;
}

} // namespace splineloft
