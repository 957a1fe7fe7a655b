// Samples: how many, where, and that the last is the end.
#include "core/spline/measure/sample.h"

#include "tests/property/random_curves.h"

#include <cmath>
#include <stdexcept>

namespace splineloft {
namespace {

using namespace testing_curves;

class SampleLaws : public EveryFamily {};

TEST_P(SampleLaws, spreadsFromEndToEnd) {
    forEveryForm(GetParam(), 6, [](const Curve& curve) {
        const Pieces pieces = piecesOf(curve);
        const ArcLength lengths(pieces);
        const Spot last{pieces.size() - 1, 1};
        for (const auto even : {Even::parameter, Even::length}) {
            for (const std::size_t count : {2u, 3u, 17u}) {
                const auto spots = spread(pieces, lengths, even, count);
                ASSERT_EQ(spots.size(), count);
                EXPECT_EQ(spots.front(), (Spot{0, 0}));
                EXPECT_EQ(spots.back(), last) << "u " << spots.back().u;
            }
        }
        for (const std::size_t grain : {1u, 2u, 7u}) {
            const auto spots = spreadPerPiece(pieces, grain);
            EXPECT_EQ(spots.size(), pieces.size() * grain + 1);
            EXPECT_EQ(spots.back(), last);
        }
    });
}

TEST_P(SampleLaws, evenInTheParameterIsEvenInT) {
    forEveryForm(GetParam(), 6, [](const Curve& curve) {
        const Pieces pieces = piecesOf(curve);
        const ArcLength lengths(pieces);
        const auto samples =
            samplesAt(pieces, lengths, spread(pieces, lengths, Even::parameter, 9));
        const auto& knots = pieces.knots();
        const double step = (knots.end() - knots.start()) / 8;
        for (std::size_t i = 0; i < samples.size(); ++i) {
            EXPECT_NEAR(samples[i].t, knots.start() + static_cast<double>(i) * step,
                        1e-14 * 8 * step);
            EXPECT_EQ(samples[i].position, pieces.position(samples[i].spot));
        }
    });
}

/// The memo promises (n - 3) * grain + 1 points for open ends, and its program forgets the last.
TEST(Sample, asManyAsTheMemoPromises) {
    Curve curve;
    curve.ends = Ends::open;
    curve.points = {{100, 50}, {130, 52}, {140, 80}, {111, 91}, {96, 70}, {90, 20}};
    for (const std::size_t grain : {1u, 4u, 256u}) {
        const Pieces pieces = piecesOf(curve);
        const auto spots = spreadPerPiece(pieces, grain);
        EXPECT_EQ(spots.size(), (curve.points.size() - 3) * grain + 1);
        EXPECT_EQ(pieces.position(spots.front()), Point({130, 52}));
        EXPECT_EQ(pieces.position(spots.back()), Point({96, 70}));
    }
}

TEST(Sample, grainOfZeroOrNoPiecesGivesNone) {
    Curve curve;
    EXPECT_TRUE(spreadPerPiece(piecesOf(curve), 8).empty());
    const Pieces none = piecesOf(curve);
    EXPECT_TRUE(spread(none, ArcLength(none), Even::length, 8).empty());
    curve.points = {{100, 50}, {130, 52}, {140, 80}};
    EXPECT_TRUE(spreadPerPiece(piecesOf(curve), 0).empty());
    const Pieces some = piecesOf(curve);
    EXPECT_TRUE(spread(some, ArcLength(some), Even::length, 1).empty());
}

/// A line from (10, 20), 5 long.
Pieces fiveLong() {
    Curve curve;
    curve.family = "linear";
    curve.ends = Ends::none;
    curve.points = {{10, 20}, {13, 24}};
    return piecesOf(curve);
}

TEST(SpreadByDistance, endsWithTheLastWholeStepUnlessCapped) {
    const Pieces pieces = fiveLong();
    const ArcLength lengths(pieces);
    const auto bare = spreadByDistance(pieces, lengths, 1.5);
    ASSERT_EQ(bare.size(), 4u);
    for (std::size_t i = 0; i < bare.size(); ++i) {
        EXPECT_NEAR(lengths.upTo(bare[i]), 1.5 * static_cast<double>(i), 1e-14) << i;
    }
    const auto capped = spreadByDistance(pieces, lengths, 1.5, Remainder::capped);
    ASSERT_EQ(capped.size(), 5u);
    EXPECT_EQ(capped.back(), (Spot{0, 1}));
    EXPECT_EQ(spreadByDistance(pieces, lengths, 7).size(), 1u) << "the start alone";
    EXPECT_EQ(spreadByDistance(pieces, lengths, 7, Remainder::capped).size(), 2u);
}

TEST(SpreadByDistance, reachesTheEndWhereItIsAWholeNumberOfStepsAway) {
    const Pieces pieces = fiveLong();
    const ArcLength lengths(pieces);
    for (const auto remainder : {Remainder::bare, Remainder::capped}) {
        for (const int steps : {1, 2, 3, 7, 10, 49, 1000, 99991}) {
            const auto spots =
                spreadByDistance(pieces, lengths, lengths.total() / steps, remainder);
            ASSERT_EQ(spots.size(), static_cast<std::size_t>(steps) + 1);
            EXPECT_EQ(spots.back(), (Spot{0, 1})) << steps;
        }
    }
}

TEST(SpreadByDistance, refusesWhatWouldNotEnd) {
    const Pieces pieces = fiveLong();
    const ArcLength lengths(pieces);
    for (const double distance : {0.0, -1.0, std::nan(""), 1e-9, 5e-324}) {
        EXPECT_THROW(spreadByDistance(pieces, lengths, distance), std::invalid_argument)
            << distance;
    }
    EXPECT_EQ(spreadByDistance(pieces, lengths, 5e-6).size(), 1'000'001u);
    try {
        spreadByDistance(pieces, lengths, 1e-9);
    } catch (const std::invalid_argument& error) {
        EXPECT_NE(std::string(error.what()).find("at least"), std::string::npos) << error.what();
    }
    const Pieces none;
    EXPECT_TRUE(spreadByDistance(none, ArcLength(none), 1).empty());
    const Pieces point(3, 2, KnotLine({0, 1}), {4, 7, 4, 7, 4, 7, 4, 7});
    EXPECT_EQ(spreadByDistance(point, ArcLength(point), 1).size(), 1u);
}

TEST(SpreadPlaces, areThePositionsOfTheSpots) {
    for (const auto& form : everyForm()) {
        const Curve curve = randomCurve(form, 3);
        const Pieces pieces = piecesOf(curve);
        const ArcLength lengths(pieces);
        const auto stride = static_cast<std::size_t>(pieces.dimension());
        for (const std::size_t count : {2u, 5u, 300u}) {
            std::vector<double> places(count * stride);
            spreadPlaces(pieces, lengths, count, places);
            const auto spots = spread(pieces, lengths, Even::length, count);
            for (std::size_t i = 0; i < count; ++i) {
                expectNear(Point(std::span(places).subspan(i * stride, stride)),
                           pieces.position(spots[i]), 1e-13 * (1 + farthest(curve)),
                           wordsOf(curve));
            }
        }
    }
    std::vector<double> tooFew(3);
    const Pieces pieces = fiveLong();
    EXPECT_THROW(spreadPlaces(pieces, ArcLength(pieces), 2, tooFew), std::invalid_argument);
}

INSTANTIATE_TEST_SUITE_P(Families, SampleLaws, testing::ValuesIn(familyIds()), testNameOf);

} // namespace
} // namespace splineloft
