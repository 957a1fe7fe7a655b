#include "core/spline/catalog.h"

#include <algorithm>
#include <array>

// A new family is one file in families/ that defines its function, and one line here.
#define SPLINELOFT_FAMILIES(family)                                                                \
    family(linear) family(lagrange) family(parametricParabola) family(bezier) family(bezierSpline) \
        family(hermite) family(cardinal) family(catmullRom) family(kochanekBartels)                \
            family(natural) family(bSpline) family(bcSpline) family(duff) family(beta)             \
                family(nurbs)

namespace splineloft {

namespace families {
#define DECLARE(family) Family family();
SPLINELOFT_FAMILIES(DECLARE)
#undef DECLARE
} // namespace families

std::span<const Family> catalog() {
#define ENTRY(family) families::family(),
    static const std::array entries{SPLINELOFT_FAMILIES(ENTRY)};
#undef ENTRY
    return entries;
}

const Family* findFamily(std::string_view id) {
    const auto found = std::ranges::find(catalog(), id, &Family::id);
    return found == catalog().end() ? nullptr : &*found;
}

std::string_view nameOf(Ends ends) {
    switch (ends) {
    case Ends::none: return "none";
    case Ends::open: return "open";
    case Ends::doubled: return "doubled";
    case Ends::reflected: return "reflected";
    case Ends::clamped: return "clamped";
    }
    return "none";
}

} // namespace splineloft
