#include "core/spline/measure/nearest.h"

#include "core/spline/algebra/scale.h"
#include "core/spline/measure/nearest_any.h"
#include "core/spline/measure/nearest_cubic.h"
#include "core/spline/measure/thick_chords.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

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

/// Searches the pieces in a tree of thick chords, the nearest ones first.
template <class Search> class TreeSearch {
  public:
    TreeSearch(Search& search, const ThickChords& chords, const Point& place)
        : search_(search), chords_(chords) {
        constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();
        question_.place = place.coordinates().data();
        question_.rounding = rounding * largestOf(place.coordinates());
        question_.gap = chords.gap();
        question_.limit = search.distance();
    }

    void lookInto(std::size_t level, std::size_t group) {
        auto choice = lanes::chooseChords(chords_.group(level, group), question_);
        question_.limit = choice.limit;
        const auto candidates = std::span(choice.candidates).first(choice.count);
        std::ranges::sort(candidates);
        for (const auto candidate : candidates) {
            if (candidate > (std::bit_cast<lanes::Candidate>(question_.limit) | lanes::chordMask)) {
                break;
            }
            const auto member = chords_.firstOf(level, group) + (candidate & lanes::chordMask);
            if (level > 0) {
                lookInto(level - 1, member);
            } else {
                search_.look(member);
                question_.limit = std::min(question_.limit, search_.distance());
            }
        }
    }

  private:
    Search& search_;
    const ThickChords& chords_;
    lanes::ChordQuestion question_;
};

} // namespace

std::optional<Nearest> nearestTo(const Pieces& pieces, const Point& place, double within) {
    if (pieces.empty() || !isFinite(place) || !(within >= 0)) {
        return std::nullopt;
    }
    return withSearch(pieces, largestOf(pieces.bezier()), place, within, [&](auto search) {
        lookAtAll(search, pieces.size());
        return resultOf(search.best(), pieces, place);
    });
}

NearestIndex::NearestIndex(const Pieces& pieces)
    : pieces_(&pieces), chords_(std::make_shared<const ThickChords>(pieces)) {}

std::optional<Nearest> NearestIndex::nearest(const Point& place, double within) const {
    const double size = std::max(chords_->farthest(), largestOf(place.coordinates()));
    const bool quick = size > nearest::leastQuick && size < nearest::mostQuick;
    if (chords_->levels() == 0 || !quick || !(within >= 0)) {
        return nearestTo(*pieces_, place, within);
    }
    return withSearch(*pieces_, chords_->farthest(), place, within, [&](auto search) {
        TreeSearch(search, *chords_, place).lookInto(chords_->levels() - 1, 0);
        return resultOf(search.best(), *pieces_, place);
    });
}

} // namespace splineloft
