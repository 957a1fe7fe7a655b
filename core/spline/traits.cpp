#include "core/spline/traits.h"

#include <algorithm>
#include <cmath>

namespace splineloft {
namespace {

// Rounding in the weights; a weight below it has no influence that a double could show.
constexpr double weightTolerance = 1e-13;

// Rounding in a sum of weights, relative to their sizes: those beside short chords are huge.
constexpr double affineTolerance = 1e-12;

/// Sum of the absolute weights, at least 1.
double sizeOf(const Blend& blend) {
    double sum = 0;
    for (const auto& share : blend.shares()) {
        sum += std::abs(share.weight);
    }
    return std::max(sum, 1.0);
}

/// Whether a blend is one control and nothing else.
bool isExactly(const Blend& blend, std::size_t control) {
    const Blend rest = blend - Blend::of(control);
    return std::ranges::all_of(rest.shares(), [](const Share& share) {
        return std::abs(share.weight) <= weightTolerance;
    });
}

/// The control point that a blend is, if it is just one.
std::optional<std::size_t> onlyControl(const Blend& blend, std::size_t controlPoints) {
    const auto shares = blend.shares();
    const auto main = std::ranges::max_element(shares, {}, &Share::weight);
    if (main == shares.end() || main->control >= controlPoints ||
        !isExactly(blend, main->control)) {
        return std::nullopt;
    }
    return main->control;
}

/// Whether a basis function dips below zero on a piece although it has a negative Bernstein
/// coefficient only there: 64 values decide.
bool dipsBelowZero(const BlendPieces& blends, std::size_t segment) {
    for (int k = 1; k < 64; ++k) {
        const Blend basis = blends.basis({segment, k / 64.0});
        for (const auto& share : basis.shares()) {
            if (share.weight < -weightTolerance) {
                return true;
            }
        }
    }
    return false;
}

bool hasNegative(std::span<const Blend> bezier) {
    return std::ranges::any_of(bezier, [](const Blend& blend) {
        return std::ranges::any_of(blend.shares(),
                                   [](const Share& s) { return s.weight < -weightTolerance; });
    });
}

/// For each control point the number of pieces that it moves, however little.
std::vector<std::size_t> piecesMoved(const BlendPieces& blends) {
    std::vector<std::size_t> moved(blends.controlPoints());
    std::vector<std::size_t> lastSeen(blends.controlPoints(), blends.size());
    for (std::size_t i = 0; i < blends.size(); ++i) {
        for (const auto& blend : blends[i]) {
            for (const auto& [control, weight] : blend.shares()) {
                if (control < moved.size() && weight != 0 && lastSeen[control] != i) {
                    lastSeen[control] = i;
                    ++moved[control];
                }
            }
        }
    }
    return moved;
}

} // namespace

Traits traitsOf(const Curve& curve, const Pieces& pieces, const BlendPieces& blends) {
    Traits traits;
    const auto n = blends.controlPoints();
    traits.onCurve.assign(n, false);
    if (blends.size() == 0) {
        return traits;
    }
    traits.affine = true;
    traits.inHull = true;
    for (std::size_t i = 0; i < blends.size(); ++i) {
        const auto bezier = blends[i];
        for (const auto* end : {&bezier.front(), &bezier.back()}) {
            if (const auto control = onlyControl(*end, n)) {
                traits.onCurve[*control] = true;
            }
        }
        for (const auto& blend : bezier) {
            traits.affine =
                traits.affine && std::abs(blend.sumBelow(n) - 1) <= affineTolerance * sizeOf(blend);
        }
        if (traits.inHull && hasNegative(bezier)) {
            traits.inHull = !dipsBelowZero(blends, i);
        }
    }
    // Tangents are displacements, not points: with them no hull of points holds the curve.
    traits.inHull = traits.inHull && traits.affine && !familyOf(curve).usesTangents;
    traits.throughAll = std::ranges::all_of(traits.onCurve, [](bool on) { return on; });
    traits.throughEnds = isExactly(blends[0].front(), 0) &&
                         isExactly(blends[blends.size() - 1].back(), curve.closed ? 0 : n - 1);
    const auto moved = piecesMoved(blends);
    traits.reach = std::ranges::max(moved);
    traits.global = std::ranges::min(moved) == blends.size();
    traits.joints = jointsOf(pieces, curve.closed);
    for (const auto& joint : traits.joints) {
        traits.c = std::min(traits.c, joint.c);
        traits.g = std::min(traits.g, joint.g);
    }
    return traits;
}

} // namespace splineloft
