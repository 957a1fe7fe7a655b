#include "core/spline/measure/nearest.h"

#include "core/spline/algebra/scale.h"
#include "core/spline/measure/nearest_any.h"
#include "core/spline/measure/nearest_cubic.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace splineloft {
namespace {

/// Calls `use` with the quickest search for these pieces, whose largest coordinate is given.
template <std::size_t dimension, class Use>
auto withCubicSearch(const Pieces& pieces, const Point& place, double within, Use use) {
    switch (pieces.degree()) {
    case 1: return use(nearest::CubicSearch<dimension, 1>(pieces, place, within));
    case 2: return use(nearest::CubicSearch<dimension, 2>(pieces, place, within));
    default: return use(nearest::CubicSearch<dimension, 3>(pieces, place, within));
    }
}

template <class Use>
auto withSearch(const Pieces& pieces, double farthest, const Point& place, double within, Use use) {
    const double size = std::max(farthest, largestOf(place.coordinates()));
    const bool isOrdinary = size > nearest::leastQuick && size < nearest::mostQuick;
    if (isOrdinary && pieces.form() == Form::polynomial && pieces.degree() >= 1 &&
        pieces.degree() <= 3) {
        switch (pieces.dimension()) {
        case 1: return withCubicSearch<1>(pieces, place, within, use);
        case 2: return withCubicSearch<2>(pieces, place, within, use);
        case 3: return withCubicSearch<3>(pieces, place, within, use);
        default: break;
        }
    }
    return use(nearest::AnySearch(pieces, place, within));
}

bool isFinite(const Point& place) {
    return std::ranges::all_of(place.coordinates(), [](double x) { return std::isfinite(x); });
}

std::optional<Nearest> resultOf(const nearest::Best& best, const Pieces& pieces,
                                const Point& place) {
    if (!best.isFound()) {
        return std::nullopt;
    }
    return Nearest{best.spot(), std::min(distance(pieces.position(best.spot()), place),
                                         std::numeric_limits<double>::max())};
}

/// Looks at every piece, beginning with the one whose box is nearest.
template <class Search> void lookAtAll(Search& search, std::size_t pieces) {
    std::size_t first = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < pieces; ++i) {
        const double bound = search.bound(i);
        if (bound < least) {
            least = bound;
            first = i;
        }
    }
    search.look(first);
    for (std::size_t i = 0; i < pieces; ++i) {
        if (i != first && !search.best().rules(search.bound(i))) {
            search.look(i);
        }
    }
}

/// A member of a group and its lower bound, in one number that sorts by the bound. What the bound
/// loses of its last digits makes it lower.
using Candidate = std::uint64_t;
constexpr Candidate memberMask = ThickChords::groupSize - 1;

Candidate candidateOf(double bound, std::size_t member) {
    return (std::bit_cast<Candidate>(bound) & ~memberMask) | member;
}

/// The last candidate that may be nearer than what is found.
template <class Search> Candidate lastFor(const Search& search) {
    return std::bit_cast<Candidate>(search.distance()) | memberMask;
}

/// Looks at the pieces in a group of thick chords, the nearest ones first.
template <class Search>
void lookInto(Search& search, const ThickChords& chords, std::size_t level, std::size_t group,
              const Point& place) {
    constexpr auto size = ThickChords::groupSize;
    const auto bounds = chords.distances(level, group, place);
    const auto visit = [&](Candidate candidate) {
        const auto member = group * size + (candidate & memberMask);
        if (level == 0) {
            search.look(member);
        } else {
            lookInto(search, chords, level - 1, member, place);
        }
    };
    // All without branches, which nothing would predict: the nearest one as a tournament, and of
    // the others, the few that remain after it.
    std::array<Candidate, size> candidates, rest;
    for (std::size_t m = 0; m < size; ++m) {
        candidates[m] = rest[m] = candidateOf(bounds[m], m);
    }
    for (auto left = size / 2; left > 0; left /= 2) {
        for (std::size_t m = 0; m < left; ++m) {
            const auto one = rest[m];
            const auto other = rest[m + left];
            rest[m] = one < other ? one : other;
        }
    }
    const auto first = rest[0];
    if (first > lastFor(search)) {
        return;
    }
    visit(first);
    const auto present = std::min(size, chords.members(level) - group * size);
    const auto last = lastFor(search);
    std::size_t count = 0;
    for (std::size_t m = 0; m < present; ++m) {
        rest[count] = candidates[m];
        count += static_cast<std::size_t>(candidates[m] <= last) &
                 static_cast<std::size_t>(candidates[m] != first);
    }
    if (count > 1) {
        std::sort(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(count));
    }
    for (std::size_t i = 0; i < count && rest[i] <= lastFor(search); ++i) {
        visit(rest[i]);
    }
}

} // namespace

std::optional<Nearest> nearestTo(const Pieces& pieces, const Point& place, double within) {
    if (pieces.empty() || !isFinite(place)) {
        return std::nullopt;
    }
    return withSearch(pieces, largestOf(pieces.bezier()), place, within, [&](auto search) {
        lookAtAll(search, pieces.size());
        return resultOf(search.best(), pieces, place);
    });
}

NearestIndex::NearestIndex(const Pieces& pieces) : pieces_(&pieces), chords_(pieces) {}

std::optional<Nearest> NearestIndex::nearest(const Point& place, double within) const {
    const double size = std::max(chords_.farthest(), largestOf(place.coordinates()));
    if (chords_.levels() == 0 || !(size > nearest::leastQuick && size < nearest::mostQuick)) {
        return nearestTo(*pieces_, place, within);
    }
    return withSearch(*pieces_, chords_.farthest(), place, within, [&](auto search) {
        lookInto(search, chords_, chords_.levels() - 1, 0, place);
        return resultOf(search.best(), *pieces_, place);
    });
}

} // namespace splineloft
