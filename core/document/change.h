// The way in which every edit changes one curve of a document.
#pragma once

#include "core/document/document.h"
#include "core/document/handles.h"

#include <concepts>
#include <memory>

namespace splineloft {

/// The document with one curve changed by `change(curve)`, or by `change(curve, modes)` where the
/// edit knows what becomes of the modes of its handles; afterwards they are in step with it.
template <class Change>
Document changed(const Document& document, std::size_t index, Change change) {
    auto curve = std::make_shared<Curve>(*document.curves[index]);
    Document next = document;
    auto& entry = next.curves[index];
    if constexpr (std::invocable<Change, Curve&, HandleModes&>) {
        change(*curve, entry.handleModes);
    } else {
        change(*curve);
    }
    settleModes(*curve, entry.handleModes);
    entry = std::move(curve);
    return next;
}

} // namespace splineloft
