// The index of nearest spots against no index, on every set of instructions.
#include "core/spline/measure/nearest.h"

#include "tests/unit/random_pieces.h"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <string>
#include <vector>

namespace splineloft::test {
namespace {

/// Beside a random spot, on it, or far from all.
Point randomPlace(const Pieces& pieces, std::mt19937& random) {
    std::uniform_real_distribution<double> unit(0, 1);
    const std::array<double, 4> distances = {0, 1e-3, 1, 1e3};
    const auto segment = random() % pieces.size();
    Point place = pieces.position({segment, unit(random)});
    const double away = distances[random() % distances.size()];
    for (int c = 0; c < place.dimension(); ++c) {
        place[c] += away * (2 * unit(random) - 1);
    }
    return place;
}

void expectSameWithAndWithoutIndex(const Pieces& pieces, const std::string& instructions) {
    constexpr int places = 20;
    std::mt19937 random(12);
    const NearestIndex index(pieces);
    for (int i = 0; i < places; ++i) {
        const Point place = randomPlace(pieces, random);
        const auto one = nearestTo(pieces, place);
        const auto other = index.nearest(place);
        ASSERT_TRUE(one && other) << describe(pieces, instructions);
        ASSERT_EQ(one->spot, other->spot) << describe(pieces, instructions) << " place " << i;
        ASSERT_EQ(one->distance, other->distance) << describe(pieces, instructions);
        // No more than this is near enough, and then nothing is.
        ASSERT_EQ(index.nearest(place, one->distance).has_value(),
                  nearestTo(pieces, place, one->distance).has_value())
            << describe(pieces, instructions) << " place " << i;
    }
}

/// These pieces do not meet, as those of curves mostly do: the index may not rely on that.
TEST(NearestIndex, ofPiecesApartFindsWhatNoIndexFinds) {
    onEveryInstructionSet([](const std::string& instructions) {
        for (const std::size_t count : {1, 17, 64, 65}) {
            for (const int dimension : {1, 2, 3, 5}) {
                for (const auto form : {Form::polynomial, Form::rational}) {
                    const int degree = form == Form::rational ? 2 : 3;
                    ASSERT_NO_FATAL_FAILURE(expectSameWithAndWithoutIndex(
                        randomPieces(degree, dimension, form, evenKnots(count)), instructions));
                }
            }
        }
    });
}

/// One curve of very many pieces, so that there are three levels; and pieces that rest.
TEST(NearestIndex, ofALongCurveFindsWhatNoIndexFinds) {
    constexpr std::size_t count = 20'000;
    std::mt19937 random(5);
    std::uniform_real_distribution<double> step(-1, 1);
    std::vector<double> bezier;
    Point at = {3, -4};
    for (std::size_t i = 0; i < count; ++i) {
        const double size = i % 7 == 0 ? 0 : 1;
        for (int k = 0; k < 4; ++k) {
            bezier.insert(bezier.end(), at.coordinates().begin(), at.coordinates().end());
            at += k < 3 ? Point{size * step(random), size * step(random)} : Point{0, 0};
        }
    }
    const Pieces pieces(3, 2, KnotLine(evenKnots(count)), std::move(bezier));
    onEveryInstructionSet([&](const std::string& instructions) {
        expectSameWithAndWithoutIndex(pieces, instructions);
    });
}

} // namespace
} // namespace splineloft::test
