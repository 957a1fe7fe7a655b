#include "core/spline/fast/dense.h"
#include "core/spline/fast/lanes/direct_sampler.h"
#include "tests/unit/random_pieces.h"

#include <gtest/gtest.h>

#include <limits>

namespace splineloft {
namespace {

using test::describe;
using test::evenKnots;
using test::onEveryInstructionSet;
using test::randomPieces;

constexpr double untouched = 12345;

/// Positions into the middle of a larger block, of which the rest must not change.
template <class Number>
std::vector<Number> positionsOf(const Pieces& pieces, std::size_t perPiece, std::size_t offset) {
    const auto count =
        placesPerPiece(pieces, perPiece) * static_cast<std::size_t>(pieces.dimension());
    std::vector<Number> block(offset + count + 64, static_cast<Number>(untouched));
    positionsPerPiece(pieces, perPiece, std::span(block).subspan(offset, count));
    const auto inside = block.begin() + static_cast<std::ptrdiff_t>(offset);
    const auto end = inside + static_cast<std::ptrdiff_t>(count);
    EXPECT_TRUE(std::all_of(block.begin(), inside, [](Number n) { return n == untouched; }));
    EXPECT_TRUE(std::all_of(end, block.end(), [](Number n) { return n == untouched; }));
    return {inside, end};
}

Spot spotOf(const Pieces& pieces, std::size_t perPiece, std::size_t place) {
    return place == pieces.size() * perPiece
               ? Spot{pieces.size() - 1, 1}
               : Spot{place / perPiece,
                      static_cast<double>(place % perPiece) / static_cast<double>(perPiece)};
}

/// Largest deviation from plain evaluation.
template <class Number>
double deviation(const Pieces& pieces, std::size_t perPiece, const std::vector<Number>& found) {
    double worst = 0;
    const auto dimension = static_cast<std::size_t>(pieces.dimension());
    for (std::size_t i = 0; i < found.size() / dimension; ++i) {
        const auto right = pieces.position(spotOf(pieces, perPiece, i));
        for (std::size_t c = 0; c < dimension; ++c) {
            const double off = std::abs(right[static_cast<int>(c)] -
                                        static_cast<double>(found[i * dimension + c]));
            worst =
                std::isnan(off) ? std::numeric_limits<double>::infinity() : std::max(worst, off);
        }
    }
    return worst;
}

/// Of floats, where no coordinate is larger than 1: computed in floats, or rounded once.
double mostOfFloats(const Pieces& pieces) {
    const bool inFloats =
        pieces.form() == Form::polynomial && pieces.degree() <= 5 && pieces.dimension() <= 3;
    return inFloats ? 5e-7 : 3.1e-8;
}

template <class Check> void forManyKindsOfPieces(Check check) {
    for (int degree = 1; degree <= 25; ++degree) {
        for (const int dimension : {1, 2, 3, 4, 5, 16}) {
            for (const auto form : {Form::polynomial, Form::rational}) {
                check(randomPieces(degree, dimension, form, evenKnots(3)));
            }
        }
    }
}

TEST(Dense, IsWhatPlainEvaluationSays) {
    onEveryInstructionSet([](const std::string& instructions) {
        forManyKindsOfPieces([&](const Pieces& pieces) {
            std::size_t offset = 0;
            // Many only where the inner loops differ: plain evaluation takes its time.
            const bool many = pieces.degree() == 3 || pieces.degree() == 6;
            for (const std::size_t perPiece : {1, 2, 3, 7, many ? 256 : 33}) {
                const auto exact = positionsOf<double>(pieces, perPiece, offset++);
                EXPECT_LE(deviation(pieces, perPiece, exact), 1e-13)
                    << describe(pieces, instructions) << ", " << perPiece << " a piece";
                const auto rounded = positionsOf<float>(pieces, perPiece, offset++);
                EXPECT_LE(deviation(pieces, perPiece, rounded), mostOfFloats(pieces))
                    << describe(pieces, instructions) << ", " << perPiece << " a piece, float";
            }
        });
    });
}

TEST(Dense, WritesNothingElseWhereverTheOutputBegins) {
    onEveryInstructionSet([](const std::string& instructions) {
        for (const int dimension : {1, 2, 3, 4}) {
            for (const std::size_t count : {1, 2, 5, 65, 130}) {
                const auto pieces = randomPieces(3, dimension, Form::polynomial, evenKnots(count));
                for (std::size_t offset = 0; offset < 17; ++offset) {
                    const auto perPiece = 1 + offset;
                    EXPECT_LE(
                        deviation(pieces, perPiece, positionsOf<double>(pieces, perPiece, offset)),
                        1e-14)
                        << describe(pieces, instructions);
                    EXPECT_LE(
                        deviation(pieces, perPiece, positionsOf<float>(pieces, perPiece, offset)),
                        mostOfFloats(pieces))
                        << describe(pieces, instructions);
                }
            }
        }
    });
}

TEST(Dense, LosesLittleOnTheWorstPoints) {
    // Points that alternate make the largest coefficients: 3^n together in power form.
    onEveryInstructionSet([](const std::string& instructions) {
        for (int degree = 1; degree <= 12; ++degree) {
            std::vector<double> bezier;
            for (int i = 0; i <= degree; ++i) {
                bezier.push_back(i % 2 == 0 ? 0.987654321 : -0.9753113579);
            }
            const Pieces pieces(degree, 1, KnotLine({0, 1}), bezier);
            const double most = degree <= 3 ? 1e-14 : 1e-13;
            EXPECT_LE(deviation(pieces, 251, positionsOf<double>(pieces, 251, 0)), most)
                << describe(pieces, instructions);
            EXPECT_LE(deviation(pieces, 251, positionsOf<float>(pieces, 251, 0)),
                      std::max(mostOfFloats(pieces), 6e-8))
                << describe(pieces, instructions);
        }
    });
}

TEST(Dense, FloatsOfAnySizeStayThemselves) {
    onEveryInstructionSet([](const std::string& instructions) {
        for (const double size : {3e38, 1e36, 1e30, 1.0, 1e-30}) {
            for (int degree = 1; degree <= 6; ++degree) {
                std::vector<double> bezier;
                for (int i = 0; i <= degree; ++i) {
                    bezier.push_back(i % 2 == 0 ? size : -size);
                }
                const Pieces pieces(degree, 1, KnotLine({0, 1}), bezier);
                EXPECT_LE(deviation(pieces, 100, positionsOf<float>(pieces, 100, 0)), 5e-7 * size)
                    << describe(pieces, instructions) << ", size " << size;
            }
        }
    });
}

TEST(Dense, HighDegreesNeitherOverflowNorFade) {
    for (const int degree : {60, 200, 400, 401}) {
        const auto pieces = randomPieces(degree, 2, Form::polynomial, evenKnots(1));
        EXPECT_LE(deviation(pieces, 40, positionsOf<double>(pieces, 40, 0)), 1e-13)
            << "degree " << degree;
        for (const double curvature : jetsPerPiece(pieces, 5).curvatures) {
            EXPECT_TRUE(std::isfinite(curvature)) << "degree " << degree;
        }
    }
}

TEST(Dense, BeginsAndEndsInTheBezierPoints) {
    forManyKindsOfPieces([](const Pieces& pieces) {
        const auto found = positionsOf<double>(pieces, 8, 0);
        const auto floats = positionsOf<float>(pieces, 8, 0);
        for (int c = 0; c < pieces.dimension(); ++c) {
            const auto place = static_cast<std::size_t>(c);
            EXPECT_EQ(found[place], pieces[0].bezierPoint(0)[c]) << describe(pieces, "best");
            EXPECT_EQ(floats[place], static_cast<float>(found[place])) << describe(pieces, "best");
            EXPECT_EQ(found[found.size() - static_cast<std::size_t>(pieces.dimension()) + place],
                      pieces[2].bezierPoint(pieces.degree())[c])
                << describe(pieces, "best");
        }
    });
}

template <class Number> void expectStreamedAsCached(const Pieces& pieces, std::size_t perPiece) {
    const auto count = pieces.size() * perPiece * static_cast<std::size_t>(pieces.dimension());
    std::vector<Number> cached(count);
    std::vector<Number> block(count + 32, static_cast<Number>(untouched));
    lanes::sampleDirectly(pieces, perPiece, lanes::Store::cached, cached);
    for (const std::size_t offset : {0, 1, 7, 16}) { // from the start of a cache line or not
        const auto streamed = std::span(block).subspan(offset, count);
        lanes::sampleDirectly(pieces, perPiece, lanes::Store::streamed, streamed);
        EXPECT_TRUE(std::equal(cached.begin(), cached.end(), streamed.begin()));
        EXPECT_EQ(block[offset + count], untouched);
        std::fill(block.begin(), block.end(), static_cast<Number>(untouched));
    }
}

TEST(Dense, PastTheCachesIsTheSame) {
    onEveryInstructionSet([](const std::string& instructions) {
        for (const int degree : {3, 8}) {
            for (const int dimension : {1, 2, 3}) {
                const auto pieces =
                    randomPieces(degree, dimension, Form::polynomial, evenKnots(70));
                for (const std::size_t perPiece : {1, 3, 256, 1500}) {
                    SCOPED_TRACE(describe(pieces, instructions) + ", " + std::to_string(perPiece) +
                                 " a piece");
                    expectStreamedAsCached<double>(pieces, perPiece);
                    expectStreamedAsCached<float>(pieces, perPiece);
                }
            }
        }
    });
    EXPECT_EQ(lanes::storeFor(4096), lanes::Store::cached);
    EXPECT_EQ(lanes::storeFor(std::size_t{1} << 40), lanes::Store::streamed);
}

TEST(Dense, NoPiecesHaveNoPlaces) {
    const Pieces none(3, 2, KnotLine(), {});
    EXPECT_EQ(placesPerPiece(none, 7), 0U);
    positionsPerPiece(none, 7, std::span<double>());
    EXPECT_TRUE(jetsPerPiece(none, 7).curvatures.empty());
    const auto pieces = randomPieces(3, 2, Form::polynomial, evenKnots(2));
    positionsPerPiece(pieces, 0, std::span<float>());
}

TEST(Dense, SaysWhichSizeWouldBeRight) {
    const auto pieces = randomPieces(3, 2, Form::polynomial, evenKnots(2));
    std::vector<double> out(10);
    try {
        positionsPerPiece(pieces, 4, std::span(out));
        FAIL() << "a wrong size was accepted";
    } catch (const std::invalid_argument& error) {
        EXPECT_STREQ(error.what(), "positionsPerPiece: 9 places of dimension 2 need room for 18 "
                                   "numbers, not 10");
    }
}

TEST(DenseJets, AreWhatPlainEvaluationSays) {
    onEveryInstructionSet([](const std::string& instructions) {
        forManyKindsOfPieces([&](const Pieces& pieces) {
            constexpr std::size_t perPiece = 37;
            const auto jets = jetsPerPiece(pieces, perPiece);
            const auto dimension = static_cast<std::size_t>(pieces.dimension());
            const double n = pieces.degree();
            for (std::size_t i = 0; i < jets.curvatures.size(); ++i) {
                const auto right = pieces.jet(spotOf(pieces, perPiece, i));
                for (std::size_t c = 0; c < dimension; ++c) {
                    const auto place = static_cast<int>(c);
                    EXPECT_NEAR(jets.positions[i * dimension + c], right.position[place], 1e-13);
                    EXPECT_NEAR(jets.firsts[i * dimension + c], right.first[place], 8 * n * 1e-13)
                        << describe(pieces, instructions);
                }
                // Curvature is as uncertain as the derivatives are, by the speed.
                const double speed = norm(right.first);
                const double k = right.curvature.value_or(0);
                const double uncertain =
                    1e-12 * n * n * (1 / (speed * speed) + std::abs(k) / speed);
                EXPECT_NEAR(jets.curvatures[i], k, uncertain) << describe(pieces, instructions);
            }
        });
    });
}

TEST(DenseJets, CurvatureIsNeverInfiniteOrNan) {
    onEveryInstructionSet([](const std::string& instructions) {
        // A double point at the start, a point curve, a cusp in the middle, and sizes at the edge.
        for (const double size : {1.0, 1e-300, 1e-160, 1e150, 1e300}) {
            for (const auto& shape : std::vector<std::vector<double>>{{0, 0, 0, 0, 1, 0, 1, 1},
                                                                      {1, 1, 1, 1, 1, 1, 1, 1},
                                                                      {0, 0, 1, 1, 0, 1, 1, 0}}) {
                auto bezier = shape;
                for (auto& number : bezier) {
                    number *= size;
                }
                const auto jets = jetsPerPiece(Pieces(3, 2, KnotLine({0, 1}), bezier), 8);
                for (const double curvature : jets.curvatures) {
                    EXPECT_TRUE(std::isfinite(curvature)) << instructions << ", size " << size;
                }
            }
        }
    });
}

TEST(DenseJets, CurvatureScalesWithTheSize) {
    // A quarter of a circle, rationally: the curvature is 1 / radius everywhere, to the left.
    for (const double radius : {1e-200, 1e-3, 1.0, 1e200}) {
        const double w = std::sqrt(0.5);
        const Pieces arc(2, 2, KnotLine({0, 1}),
                         {radius, 0, 1, w * radius, w * radius, w, 0, radius, 1}, Form::rational);
        for (const double curvature : jetsPerPiece(arc, 16).curvatures) {
            EXPECT_NEAR(curvature * radius, 1, 1e-13);
        }
    }
}

} // namespace
} // namespace splineloft
