#include "core/spline/fast/power_form.h"
#include "tests/unit/random_pieces.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace splineloft {
namespace {

using test::describe;
using test::evenKnots;
using test::onEveryInstructionSet;
using test::randomPieces;

/// Values of t all over the knots: random ones, the knots themselves, and their neighbours.
std::vector<double> manyT(const KnotLine& knots, std::size_t random) {
    std::vector<double> t;
    std::mt19937 dice(2);
    std::uniform_real_distribution<double> anywhere(knots.start(), knots.end());
    for (std::size_t i = 0; i < random; ++i) {
        t.push_back(anywhere(dice));
    }
    constexpr auto infinity = std::numeric_limits<double>::infinity();
    for (const double knot : knots.knots()) {
        t.insert(t.end(), {knot, std::nextafter(knot, -infinity), std::nextafter(knot, infinity)});
    }
    t.insert(t.end(), {knots.start() - 1, knots.end() + 1, -infinity, infinity});
    return t;
}

void expectPlainPositions(const Pieces& pieces, const std::vector<double>& t,
                          const std::string& instructions, double tolerance = 1e-13) {
    const PowerForm form(pieces);
    const auto dimension = static_cast<std::size_t>(pieces.dimension());
    std::vector<double> found(t.size() * dimension + 1, 12345);
    form.positions(t, std::span(found).first(t.size() * dimension));
    EXPECT_EQ(found.back(), 12345) << "wrote beyond the end";
    for (std::size_t i = 0; i < t.size(); ++i) {
        const auto right = pieces.position(pieces.knots().locate(t[i]));
        for (std::size_t c = 0; c < dimension; ++c) {
            EXPECT_NEAR(found[i * dimension + c], right[static_cast<int>(c)], tolerance)
                << describe(pieces, instructions) << " at t = " << t[i];
        }
    }
}

TEST(PowerForm, IsWhatPlainEvaluationSays) {
    onEveryInstructionSet([](const std::string& instructions) {
        for (int degree = 1; degree <= 25; ++degree) {
            for (const int dimension : {1, 2, 3, 4, 5, 16}) {
                for (const auto form : {Form::polynomial, Form::rational}) {
                    for (const std::size_t count : {1, 5}) {
                        const auto pieces = randomPieces(degree, dimension, form, evenKnots(count));
                        expectPlainPositions(pieces, manyT(pieces.knots(), 71), instructions);
                    }
                }
            }
        }
    });
}

TEST(PowerForm, FindsThePieceAmongAnyKnots) {
    // Every piece is a constant of its own: a wrong piece would show.
    const std::vector<std::vector<double>> lines = {
        {0, 1, 2, 3, 4, 5, 6},
        {-0.1, 0, 0.1, 0.2, 0.30000000000000004},
        {1e6, 1e6 + 1, 1e6 + 2, 1e6 + 3},
        {0, 0.1, 5, 5.5, 5.75, 100, 100.5},
        {0, 0, 1, 1, 1, 2, 3, 3},
        {0, 1e-9, 2e-9, 3e-9, 1, 1 + 1e-9, 1e9},
        {2, 2},
        {-1e308, 0, 1e308},
        {0, 5e-324, 1},
    };
    onEveryInstructionSet([&](const std::string& instructions) {
        for (const auto& knots : lines) {
            std::vector<double> numbers;
            for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
                numbers.insert(numbers.end(), 2, static_cast<double>(i));
            }
            const Pieces pieces(1, 1, KnotLine(knots), numbers);
            const bool wide = knots.back() - knots.front() > 1e308;
            auto t = manyT(KnotLine(wide ? std::vector<double>{0, 1e308} : knots), 200);
            t.insert(t.end(), knots.begin(), knots.end());
            expectPlainPositions(pieces, t, instructions, 1e-14);
        }
    });
}

TEST(PowerForm, FindsThePieceAmongManyUnevenKnots) {
    std::mt19937 dice(3);
    std::exponential_distribution<double> gap(1);
    std::vector<double> knots = {-3};
    for (int i = 0; i < 2000; ++i) {
        knots.push_back(knots.back() + std::pow(gap(dice), 3));
    }
    const auto pieces = randomPieces(3, 2, Form::polynomial, knots);
    expectPlainPositions(pieces, manyT(pieces.knots(), 5000), "best", 1e-14);
}

TEST(PowerForm, OnePositionIsOneOfMany) {
    for (const int degree : {3, 9, 450}) {
        const auto pieces = randomPieces(degree, 3, Form::rational, evenKnots(2));
        const PowerForm form(pieces);
        const auto place = form.position(0.75);
        const auto right = pieces.position({0, 0.75});
        EXPECT_LE(distance(place, right), 1e-13);
        EXPECT_EQ(form.dimension(), 3);
    }
}

TEST(PowerForm, NanIsTheStart) {
    for (auto knots : {evenKnots(3), std::vector<double>{0, 1, 3, 4}}) {
        const auto pieces = randomPieces(3, 2, Form::polynomial, std::move(knots));
        EXPECT_EQ(PowerForm(pieces).position(std::numeric_limits<double>::quiet_NaN()),
                  pieces[0].bezierPoint(0));
    }
}

TEST(PowerForm, RefusesNoPiecesAndWrongSizes) {
    EXPECT_THROW(PowerForm(Pieces(3, 2, KnotLine(), {})), std::invalid_argument);
    const PowerForm form(randomPieces(3, 2, Form::polynomial, evenKnots(1)));
    std::vector<double> three(3);
    EXPECT_THROW(form.position(0, three), std::invalid_argument);
    form.positions({}, {});
}

} // namespace
} // namespace splineloft
