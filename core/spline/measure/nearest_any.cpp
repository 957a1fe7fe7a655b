#include "core/spline/measure/nearest_any.h"

#include "core/spline/algebra/scale.h"
#include "core/spline/ladder.h"

#include <algorithm>
#include <limits>

namespace splineloft::nearest {
namespace {

// So that differences of coordinates of any size stay finite.
constexpr double sixteenth = 1.0 / 16;

void divide(Bernstein& numbers, double divisor) {
    for (auto& x : numbers) {
        x /= divisor;
    }
}

double weightScaleOf(const Pieces& pieces) {
    if (pieces.form() == Form::polynomial) {
        return 1;
    }
    const auto width = static_cast<std::size_t>(pieces.dimension()) + 1;
    double largest = 0;
    for (std::size_t i = width - 1; i < pieces.bezier().size(); i += width) {
        largest = std::max(largest, pieces.bezier()[i]);
    }
    return scaleFor(largest);
}

/// Brings places of Bézier points, and the place itself, near 1.
double placeScaleOf(const Pieces& pieces, const Point& place) {
    double largest = largestOf(place.coordinates());
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (int k = 0; k <= pieces.degree(); ++k) {
            largest = std::max(largest, largestOf(pieces[i].bezierPoint(k).coordinates()));
        }
    }
    return sixteenth * scaleFor(largest);
}

} // namespace

AnySearch::AnySearch(const Pieces& pieces, const Point& place, double within)
    : pieces_(pieces), scale_(placeScaleOf(pieces, place)), weightScale_(weightScaleOf(pieces)),
      place_(scale_ * place), best_(within * scale_) {}

Piece AnySearch::pieceOf(const Part& part) const {
    return {part.coordinates, pieces_.degree(), pieces_.dimension(), pieces_.form()};
}

AnySearch::Part AnySearch::seenFromPlace(std::size_t segment) const {
    const Piece piece = pieces_[segment];
    const auto width = static_cast<std::size_t>(piece.width());
    Part part{{piece.coordinates.begin(), piece.coordinates.end()}};
    for (std::size_t i = 0; i < part.coordinates.size(); i += width) {
        double weight = 1;
        if (piece.form == Form::rational) {
            weight = part.coordinates[i + width - 1] *= weightScale_;
        }
        for (std::size_t c = 0; c < static_cast<std::size_t>(piece.dimension); ++c) {
            auto& x = part.coordinates[i + c];
            x = x * weightScale_ * scale_ - weight * place_[static_cast<int>(c)];
        }
    }
    return part;
}

double AnySearch::bound(std::size_t segment) const {
    const Part part = seenFromPlace(segment);
    const Piece piece = pieceOf(part);
    Point low = piece.bezierPoint(0);
    Point high = low;
    for (int i = 1; i <= piece.degree; ++i) {
        const Point p = piece.bezierPoint(i);
        for (int c = 0; c < piece.dimension; ++c) {
            low[c] = std::min(low[c], p[c]);
            high[c] = std::max(high[c], p[c]);
        }
    }
    Point outside(piece.dimension);
    for (int c = 0; c < piece.dimension; ++c) {
        outside[c] = std::max({low[c], -high[c], 0.0});
    }
    return norm(outside) * (1 - 8 * epsilon);
}

void AnySearch::look(std::size_t segment) {
    segment_ = segment;
    cuts_ = 0;
    whole_ = seenFromPlace(segment);
    const Piece piece = pieceOf(whole_);
    best_.offer(segment, 0, norm(piece.bezierPoint(0)));
    best_.offer(segment, 1, norm(piece.bezierPoint(piece.degree)));
    branch(whole_);
}

/// Measured at u as a double can hold it, not where a part says: on a piece that is fast enough the
/// two are far apart.
void AnySearch::offer(double u) {
    best_.offer(segment_, u, norm(pieceOf(whole_).position(u)));
}

/// The pull of a part and the lower bound of its distance.
struct AnySearch::Pull {
    Bernstein pull{0};
    double noise = 0;
    std::vector<Bernstein> ways; // one a coordinate, divided by the farthest number
    Bernstein weight{1};
    double farthest = 0;

    /// The pull is half the derivative by u of the squared distance, on a rational piece times the
    /// cube of the weight. It is divided by the sizes of its factors, so that it neither overflows
    /// nor vanishes.
    explicit Pull(const Piece& piece) {
        const bool rational = piece.form == Form::rational;
        if (rational) {
            weight = piece.column(piece.dimension);
        }
        for (int c = 0; c < piece.dimension; ++c) {
            ways.push_back(piece.column(c));
            farthest = std::max(farthest, largestOf(ways.back()));
        }
        if (!(farthest >= std::numeric_limits<double>::min())) {
            return;
        }
        std::vector<Bernstein> steps;
        double longest = 0;
        double terms = 0; // what cancels to the longest
        for (auto& way : ways) {
            divide(way, farthest);
            Bernstein step = derivative(way);
            terms = std::max(terms, largestOf(step));
            if (rational) {
                const Bernstein falling = product(way, derivative(weight));
                step = product(step, weight);
                terms = std::max({terms, largestOf(step), largestOf(falling)});
                step = sum(step, falling, -1);
            }
            longest = std::max(longest, largestOf(step));
            steps.push_back(std::move(step));
        }
        if (!(longest >= std::numeric_limits<double>::min())) {
            return;
        }
        for (std::size_t c = 0; c < ways.size(); ++c) {
            divide(steps[c], longest);
            const Bernstein share = product(ways[c], steps[c]);
            pull = c == 0 ? share : sum(pull, share);
        }
        noise = 8 * static_cast<double>(pull.size()) * epsilon * (terms / longest);
    }

    /// No spot of the part is nearer than this.
    double leastDistance() const {
        Bernstein squares;
        for (std::size_t c = 0; c < ways.size(); ++c) {
            const Bernstein share = product(ways[c], ways[c]);
            squares = c == 0 ? share : sum(squares, share);
        }
        const Bernstein weights = product(weight, weight);
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < squares.size(); ++k) {
            least = std::min(least, squares[k] / (weight.size() > 1 ? weights[k] : 1));
        }
        return farthest * std::sqrt(std::max(least, 0.0));
    }
};

void AnySearch::branch(const Part& part) {
    const Pull pull(pieceOf(part));
    const Signs signs(pull.pull, pull.noise);
    if (signs.haveNoMinimum() || pull.leastDistance() >= best_.measure() * (1 - gain)) {
        return;
    }
    if (signs.haveOneMinimum()) {
        settle(part, signs.crossing());
    } else {
        cut(part);
    }
}

void AnySearch::settle(const Part& part, double start) {
    // A part may be far smaller than the whole: in units of its own size, so that products of its
    // coordinates do not vanish.
    Part near = part;
    const auto width = static_cast<std::size_t>(pieceOf(part).width());
    const auto isWeight = [&](std::size_t i) {
        return i % width >= static_cast<std::size_t>(pieces_.dimension());
    };
    double largest = 0;
    for (std::size_t i = 0; i < near.coordinates.size(); ++i) {
        largest = isWeight(i) ? largest : std::max(largest, std::abs(near.coordinates[i]));
    }
    for (std::size_t i = 0; i < near.coordinates.size(); ++i) {
        near.coordinates[i] *= isWeight(i) ? 1 : scaleFor(largest);
    }
    const Piece piece = pieceOf(near);
    const double t = risingZero(
        [&](double at) {
            const Jet jet = piece.jet(at);
            double sizes = 0;
            for (int c = 0; c < piece.dimension; ++c) {
                sizes += std::abs(jet.position[c] * jet.first[c]);
            }
            return Zeroing{dot(jet.position, jet.first),
                           dot(jet.first, jet.first) + dot(jet.position, jet.second),
                           2 * epsilon * sizes};
        },
        start);
    offer(part.low + t * (part.high - part.low));
}

void AnySearch::cut(const Part& part) {
    const double middle = 0.5 * (part.low + part.high);
    if (cuts_ == mostCuts || !(part.low < middle && middle < part.high)) {
        settle(part, 0.5);
        return;
    }
    ++cuts_;
    const auto width = static_cast<std::size_t>(pieceOf(part).width());
    Part left{{}, part.low, middle};
    Part right{part.coordinates, middle, part.high};
    for (auto size = right.coordinates.size(); size > 0; size -= width) {
        const auto rungs = std::span(right.coordinates).first(size);
        left.coordinates.insert(left.coordinates.end(), rungs.begin(),
                                rungs.begin() + static_cast<std::ptrdiff_t>(width));
        for (std::size_t i = 0; i + width < size; ++i) {
            rungs[i] = 0.5 * (rungs[i] + rungs[i + width]);
        }
    }
    offer(middle);
    branch(left);
    branch(right);
}

} // namespace splineloft::nearest
