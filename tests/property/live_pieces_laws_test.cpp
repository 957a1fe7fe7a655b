// Pieces that follow their points are, bit for bit, the pieces blended from scratch: in every
// family, with every way of ending, whatever moves.
#include "core/spline/live_pieces.h"

#include "core/spline/problem.h"
#include "tests/property/random_curves.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace splineloft {
namespace {

using namespace testing_curves;

bool sameBits(std::span<const double> a, std::span<const double> b) {
    return std::ranges::equal(a, b, {}, std::bit_cast<std::uint64_t, double>,
                              std::bit_cast<std::uint64_t, double>);
}

testing::AssertionResult same(const Pieces& followed, const Pieces& fresh) {
    if (!sameBits(followed.knots().knots(), fresh.knots().knots())) {
        return testing::AssertionFailure() << "the knots differ";
    }
    for (std::size_t i = 0; i < fresh.size(); ++i) {
        if (!sameBits(followed[i].coordinates, fresh[i].coordinates)) {
            return testing::AssertionFailure() << "piece " << i << " differs";
        }
    }
    return sameBits(followed.bezier(), fresh.bezier()) ? testing::AssertionSuccess()
                                                       : testing::AssertionFailure() << "pieces";
}

/// Some points elsewhere, now and then on top of one another, or far away.
Curve stirred(Curve curve, Dice& dice) {
    const auto n = static_cast<int>(curve.points.size());
    for (int k = dice.whole(1, 3); k > 0; --k) {
        const auto i = static_cast<std::size_t>(dice.whole(0, n - 1));
        const auto other = static_cast<std::size_t>(dice.whole(0, n - 1));
        const double reach = dice.oneIn(8) ? 1e6 : 20;
        curve.points.set(i, dice.oneIn(5) ? curve.points.at(other)
                                          : dice.pointOnGrid(curve.points.dimension(), reach));
        if (!curve.tangents.empty() && dice.oneIn(2)) {
            curve.tangents.set(other, dice.pointOnGrid(curve.points.dimension(), 5));
        }
    }
    return curve;
}

TEST(LivePieces, areWhatBlendingAnewGives) {
    Dice dice(20'260);
    for (const auto& form : everyForm()) {
        for (const int count : {2, 3, 4, 5, 9, 23}) {
            Curve curve = emptyCurve(form, dice.whole(1, 4));
            rollParameters(curve, dice);
            rollPoints(curve, static_cast<std::size_t>(count),
                       dice.pointOnGrid(curve.points.dimension(), 50), 20, dice);
            if (problemOf(curve)) {
                continue;
            }
            LivePieces live(curve, curve.points, curve.tangents);
            ASSERT_TRUE(same(live.pieces(), piecesOf(curve))) << form.family << ' ' << count;
            for (int turn = 0; turn < 6; ++turn) {
                const Curve next = stirred(curve, dice);
                const auto moves = movesBetween(curve, next);
                ASSERT_TRUE(moves);
                live.follow(next, *moves);
                ASSERT_TRUE(same(live.pieces(), piecesOf(next)))
                    << form.family << (form.closed ? " closed " : " open ")
                    << static_cast<int>(form.ends) << " of " << count << ", turn " << turn;
                curve = next;
            }
        }
    }
}

TEST(LivePieces, sayWhichPiecesMayHaveChanged) {
    Dice dice(7);
    for (const auto& form : everyForm()) {
        Curve curve = emptyCurve(form, 2);
        rollPoints(curve, 31, {40, -7}, 20, dice);
        if (problemOf(curve)) {
            continue;
        }
        LivePieces live(curve, curve.points, curve.tangents);
        const Pieces before = live.pieces();
        const Curve next = stirred(curve, dice);
        const auto changed = live.follow(next, *movesBetween(curve, next));
        std::vector<bool> told(before.size(), false);
        for (const auto& range : changed) {
            for (auto i = range.first; i < range.last; ++i) {
                told.at(i) = true;
            }
        }
        for (std::size_t i = 0; i < before.size(); ++i) {
            EXPECT_TRUE(told[i] || sameBits(before[i].coordinates, live.pieces()[i].coordinates))
                << form.family << ", piece " << i;
        }
    }
}

TEST(LivePieces, ofLocalFamiliesChangeFewAtATime) {
    for (const auto* family : {"catmull-rom", "b-spline", "cardinal", "bezier-spline", "hermite",
                               "duff", "beta", "nurbs", "linear", "kochanek-bartels"}) {
        Dice dice(11);
        const auto forms = formsOf(family);
        Curve curve = emptyCurve(forms.front(), 2);
        rollPoints(curve, 301, {40, -7}, 20, dice);
        ASSERT_FALSE(problemOf(curve)) << family;
        LivePieces live(curve, curve.points, curve.tangents);
        Curve next = curve;
        next.points.set(150, next.points.at(150) + Point{0.1, 0.2});
        std::size_t count = 0;
        for (const auto& range : live.follow(next, *movesBetween(curve, next))) {
            count += range.size();
        }
        EXPECT_GE(count, 1U) << family;
        EXPECT_LE(count, 6U) << family;
    }
}

TEST(LivePieces, knowMovesFromOtherChanges) {
    Curve curve;
    curve.points = {{1, 2}, {3, 5}, {8, 1}, {9, 9}, {12, 3}};
    Curve moved = curve;
    moved.points.set(1, {3, 6});
    moved.points.set(2, {8, 2});
    const auto moves = movesBetween(curve, moved);
    ASSERT_TRUE(moves);
    EXPECT_EQ(moves->points, (std::vector<Range>{{1, 3}}));
    EXPECT_TRUE(moves->tangents.empty());
    EXPECT_TRUE(movesBetween(curve, curve)->points.empty());
    for (const auto& change : std::vector<void (*)(Curve&)>{
             [](Curve& c) { c.closed = true; }, [](Curve& c) { c.parameters["tension"] = 0.7; },
             [](Curve& c) { c.points.append({1, 1}); }, [](Curve& c) { c.family = "b-spline"; },
             [](Curve& c) { c.name = "other"; }, [](Curve& c) { c.points = Points(3); }}) {
        Curve other = curve;
        change(other);
        EXPECT_FALSE(movesBetween(curve, other));
    }
}

} // namespace
} // namespace splineloft
