// Pieces with random Bézier points, and what is asked of fast evaluation on every set of
// instructions that the machine has.
#pragma once

#include "core/spline/fast/lanes/targets.h"
#include "core/spline/piece.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace splineloft::test {

/// Coordinates from -1 to 1, weights from 1/2 to 2, knots as given.
inline Pieces randomPieces(int degree, int dimension, Form form, std::vector<double> knots,
                           unsigned seed = 1) {
    std::mt19937 dice(seed);
    std::uniform_real_distribution<double> coordinate(-1, 1);
    std::uniform_real_distribution<double> weight(0.5, 2);
    std::vector<double> bezier;
    const auto points = (knots.size() - 1) * static_cast<std::size_t>(degree + 1);
    for (std::size_t i = 0; i < points; ++i) {
        const double w = form == Form::rational ? weight(dice) : 1;
        for (int c = 0; c < dimension; ++c) {
            bezier.push_back(w * coordinate(dice));
        }
        if (form == Form::rational) {
            bezier.push_back(w);
        }
    }
    return {degree, dimension, KnotLine(std::move(knots)), std::move(bezier), form};
}

/// Knots 0, 1, 2, ... of so many pieces.
inline std::vector<double> evenKnots(std::size_t pieces) {
    std::vector<double> knots;
    for (std::size_t i = 0; i <= pieces; ++i) {
        knots.push_back(static_cast<double>(i));
    }
    return knots;
}

/// Runs a check on each set of instructions, and goes back to the best at the end.
template <class Check> void onEveryInstructionSet(Check check) {
    for (const auto& name : lanes::instructionSets()) {
        lanes::useInstructionSet(name);
        check(name);
    }
    lanes::useInstructionSet("");
}

inline std::string describe(const Pieces& pieces, const std::string& instructions) {
    return instructions + ", degree " + std::to_string(pieces.degree()) + ", dimension " +
           std::to_string(pieces.dimension()) +
           (pieces.form() == Form::rational ? ", rational, " : ", polynomial, ") +
           std::to_string(pieces.size()) + " pieces";
}

} // namespace splineloft::test
