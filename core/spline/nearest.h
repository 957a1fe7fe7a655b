// The spot of a curve nearest to a given place.
#pragma once

#include "core/spline/piece.h"

#include <limits>
#include <optional>

namespace splineloft {

/// The closest spot and how far away it is.
struct Nearest {
    Spot spot;
    double distance = 0;
};

/// The nearest spot of all pieces, if it is nearer than `within`; nothing where there is no piece.
/// Pieces whose hull lies farther away than the best spot so far are passed over.
std::optional<Nearest> nearestTo(const Pieces& pieces, const Point& place,
                                 double within = std::numeric_limits<double>::infinity());

} // namespace splineloft
