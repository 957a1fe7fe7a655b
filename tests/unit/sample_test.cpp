// Samples: how many, where, and that the last is the end.
#include "core/spline/sample.h"

#include "tests/property/random_curves.h"

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

INSTANTIATE_TEST_SUITE_P(Families, SampleLaws, testing::ValuesIn(familyIds()), testNameOf);

} // namespace
} // namespace splineloft
