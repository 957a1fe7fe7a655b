// A curve in the plane of the canvas that follows its points is what a look at all of it gives; and
// what is found by way of boxes is what a search through everything finds.
#include "ui/plane_study.h"

#include "hand.h"

#include "core/spline/catalog.h"
#include "ui/canvas/pick.h"
#include "ui/canvas/viewport.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace splineloft::ui {
namespace {

/// Random numbers that are the same on every system.
class Dice {
  public:
    explicit Dice(std::uint64_t seed) : engine_(seed) {}
    double between(double low, double high) {
        return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
    }
    int whole(int low, int high) { return low + static_cast<int>(between(0, high - low + 1)); }
    bool oneIn(int chances) { return whole(1, chances) == 1; }

  private:
    std::mt19937_64 engine_;
};

Curve longCurve(std::string_view family, std::size_t count, int dimension = 2) {
    Curve curve = curveOf(family, dimension);
    const bool hasTangents = !curve.tangents.empty();
    curve.points = curve.tangents = Points(dimension);
    for (std::size_t i = 0; i < count; ++i) {
        Point row(dimension);
        for (int c = 0; c < dimension; ++c) {
            row[c] = 10 + std::sin(0.37 * static_cast<double>(i) + c) * (3 + c) +
                     0.01 * static_cast<double>(i);
        }
        curve.points.append(row);
        if (hasTangents) {
            curve.tangents.append(0.1 * row);
        }
    }
    return curve;
}

Curve stirred(Curve curve, Dice& dice) {
    for (int k = dice.whole(1, 4); k > 0; --k) {
        const auto i =
            static_cast<std::size_t>(dice.whole(0, static_cast<int>(curve.points.size()) - 1));
        Point place(curve.points.dimension());
        for (int c = 0; c < place.dimension(); ++c) {
            place[c] = dice.between(-30, 30);
        }
        curve.points.set(i, place);
    }
    return curve;
}

void expectSame(const PlaneStudy& followed, const PlaneStudy& fresh) {
    EXPECT_TRUE(std::ranges::equal(followed.pieces().bezier(), fresh.pieces().bezier()));
    EXPECT_TRUE(
        std::ranges::equal(followed.pieces().knots().knots(), fresh.pieces().knots().knots()));
    EXPECT_TRUE(std::ranges::equal(followed.points().places(), fresh.points().places()));
    EXPECT_TRUE(std::ranges::equal(followed.tips().places(), fresh.tips().places()));
    const auto expectSameBoxes = [](const BoxTree& a, const BoxTree& b) {
        ASSERT_EQ(a.blocks(), b.blocks());
        for (std::size_t i = 0; i < a.blocks(); ++i) {
            EXPECT_EQ(a.boxOfBlock(i), b.boxOfBlock(i)) << "block " << i;
        }
        EXPECT_EQ(a.whole(), b.whole());
    };
    expectSameBoxes(followed.boxes(), fresh.boxes());
    expectSameBoxes(followed.points().boxes(), fresh.points().boxes());
    const auto count = fresh.points().places().size();
    EXPECT_NEAR(followed.points().way(count), fresh.points().way(count), 1e-9);
    for (std::size_t i = 0; i < fresh.boxes().blocks(); ++i) {
        EXPECT_EQ(followed.detail(i).largest, fresh.detail(i).largest) << "block " << i;
        EXPECT_EQ(followed.detail(i).bend, fresh.detail(i).bend) << "block " << i;
    }
}

TEST(PlaneStudies, followWhatMoves) {
    Dice dice(31);
    for (const auto& family : catalog()) {
        for (const int dimension : {1, 2, 3}) {
            const Axes axes = dimension == 3 ? Axes{2, 0} : Axes{};
            Curve curve =
                longCurve(family.id, std::min<std::size_t>(family.mostPoints, 301), dimension);
            if (family.hasHandles) {
                curve.points.erase(curve.points.size() - 1);
                curve.points.erase(curve.points.size() - 1);
            }
            ASSERT_FALSE(problemOf(curve)) << family.id;
            LivePieces live(curve, curve.points, curve.tangents);
            PlaneStudy study(curve, live.pieces(), axes);
            for (int turn = 0; turn < 4; ++turn) {
                SCOPED_TRACE(std::string(family.id) + " in " + std::to_string(dimension));
                const Curve next = stirred(curve, dice);
                const auto moves = movesBetween(curve, next);
                study.follow(next, *moves, live.follow(next, *moves));
                const Pieces fresh = piecesOf(next);
                expectSame(study, PlaneStudy(next, fresh, axes));
                curve = next;
            }
        }
    }
}

TEST(PlaneStudies, tellWhichBlocksAreNew) {
    const Curve curve = longCurve("catmull-rom", 1000);
    LivePieces live(curve, curve.points, curve.tangents);
    PlaneStudy study(curve, live.pieces(), {});
    const auto before = study.revisions().revision();
    EXPECT_TRUE(study.revisions().since(before).empty());
    EXPECT_EQ(study.revisions().since(0).size(), 1U) << "all of it, in one range";
    Curve next = curve;
    next.points.set(500, {1, 2});
    const auto moves = movesBetween(curve, next);
    study.follow(next, *moves, live.follow(next, *moves));
    const auto changed = study.revisions().since(before);
    ASSERT_EQ(changed.size(), 1U);
    EXPECT_LE(changed[0].size(), 2U);
    EXPECT_LE(changed[0].first * BoxTree::blockSize, 500U);
    EXPECT_EQ(study.revisions().since(0).size(), 1U);
    EXPECT_NE(study.revisions().identity(), Revisions(3).identity());
}

TEST(PlaneStudies, findTheNearestSpot) {
    Dice dice(5);
    for (const auto* family : {"catmull-rom", "bezier-spline", "nurbs", "linear", "natural"}) {
        const Curve curve = longCurve(family, 601);
        const Pieces pieces = piecesOf(curve);
        const PlaneStudy study(curve, pieces, {});
        for (int k = 0; k < 60; ++k) {
            const PlanePoint place{dice.between(0, 25), dice.between(0, 25)};
            const double within = dice.oneIn(2) ? HUGE_VAL : dice.between(0, 2);
            const auto found = nearestTo(study, place, within);
            const auto wanted = nearestTo(pieces, Point{place.x, place.y}, within);
            ASSERT_EQ(found.has_value(), wanted.has_value()) << family << ' ' << within;
            if (wanted) {
                EXPECT_NEAR(found->distance, wanted->distance, 1e-12) << family;
            }
        }
    }
}

TEST(PlaneStudies, findPointsInRectangles) {
    const Document document =
        documentOf({longCurve("catmull-rom", 3000), longCurve("linear", 100)});
    Studies studies;
    studies.follow(document);
    Dice dice(17);
    const Viewport viewport{{{12, 9}, 40}, {40, 30, 900, 700}};
    for (int k = 0; k < 50; ++k) {
        const ScreenRect rect{dice.between(0, 700), dice.between(0, 500), dice.between(1, 400),
                              dice.between(1, 400)};
        Selection wanted;
        for (std::size_t c = 0; c < document.curves.size(); ++c) {
            const auto places = controlPlaces(*document.curves[c], {});
            for (std::size_t i = 0; i < places.size(); ++i) {
                if (rect.contains(viewport.toScreen(places[i]))) {
                    wanted.insert({c, i, Part::point});
                }
            }
        }
        EXPECT_EQ(pointsInside(document, studies, View{}, viewport, rect), wanted) << k;
    }
}

TEST(Studies, takeOverNothingThatAnotherCurveNeeds) {
    const Curve first = longCurve("cardinal", 300);
    Curve second = first;
    second.name = "second";
    const Document before = documentOf({first, second});
    Studies studies;
    studies.follow(before);
    const auto* kept = studies[0].pieces().bezier().data();
    // A curve put before the first one moves it to the next place.
    Document after = before;
    Curve moved = first;
    moved.points.set(3, {7, 7});
    after.curves.insert(after.curves.begin(), std::make_shared<Curve>(moved));
    studies.follow(after);
    ASSERT_EQ(studies.size(), 3U);
    EXPECT_EQ(studies[1].pieces().bezier().data(), kept);
    for (std::size_t i = 0; i < 3; ++i) {
        const Pieces fresh = piecesOf(*after.curves[i]);
        EXPECT_TRUE(std::ranges::equal(studies[i].pieces().bezier(), fresh.bezier())) << i;
    }
}

TEST(Studies, measureTheSameTraitsAsFromScratch) {
    Dice dice(3);
    for (const auto* family : {"cardinal", "catmull-rom", "bezier-spline", "natural", "hermite"}) {
        for (const std::size_t count : {31, 601}) {
            for (const bool closed : {false, true}) {
                Curve curve = longCurve(family, closed ? count - 1 : count);
                curve.closed = closed;
                ASSERT_FALSE(problemOf(curve)) << family;
                Document document = documentOf({curve});
                Studies studies;
                for (int turn = 0; turn < 5; ++turn) {
                    studies.follow(document);
                    const Traits& traits = studies[0].traits();
                    const Study fresh(document.curves[0].curve);
                    const Traits& wanted = fresh.traits();
                    EXPECT_EQ(traits.onCurve, wanted.onCurve) << family;
                    EXPECT_EQ(traits.c, wanted.c) << family << count << closed;
                    EXPECT_EQ(traits.g, wanted.g) << family << count << closed;
                    ASSERT_EQ(traits.joints.size(), wanted.joints.size()) << family;
                    for (std::size_t i = 0; i < wanted.joints.size(); ++i) {
                        EXPECT_EQ(traits.joints[i].t, wanted.joints[i].t) << family << ' ' << i;
                        EXPECT_EQ(traits.joints[i].c, wanted.joints[i].c) << family << ' ' << i;
                        EXPECT_NEAR(traits.joints[i].turn, wanted.joints[i].turn, 1e-9) << i;
                    }
                    document = documentOf({stirred(curve, dice)});
                }
            }
        }
    }
}

} // namespace
} // namespace splineloft::ui
