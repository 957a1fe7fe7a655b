// Documents made of curves, for tests.
#pragma once

#include "core/document/document.h"

#include <memory>
#include <utility>

namespace splineloft::testing_curves {

/// A document of this curve alone.
inline Document documentOf(Curve curve) {
    return {{std::make_shared<Curve>(std::move(curve))}, "{}"};
}

inline const Curve& firstOf(const Document& document) {
    return *document.curves[0];
}

} // namespace splineloft::testing_curves
