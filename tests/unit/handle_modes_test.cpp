// How the handles beside an anchor hang together, and that this outlives every edit.
#include "core/document/handle_modes.h"

#include "core/document/edits.h"
#include "core/document/handles.h"
#include "tests/documents.h"
#include "tests/property/random_curves.h"

#include <cmath>

namespace splineloft {
namespace {

using namespace testing_curves;
using enum HandleMode;

/// Anchors at 0, 3, 6, 9: mirrored at 3, aligned at 6.
Document smooth() {
    Curve curve = emptyCurve({"bezier-spline", false, Ends::none}, 2);
    curve.points = {{10, 0}, {11, 3}, {13, 4}, {14, 4}, {15, 4},
                    {18, 3}, {19, 5}, {21, 9}, {24, 9}, {25, 0}};
    return documentOf(curve);
}

const CurveEntry& entryOf(const Document& document) {
    return document.curves[0];
}

Point pointOf(const Document& document, std::size_t index) {
    return document.curves[0]->points.at(index);
}

Document withMode(const Document& document, std::size_t anchor, HandleMode mode) {
    return setHandleMode(document, std::vector<PointId>{{0, anchor}}, mode);
}

Document withHandleMoved(const Document& document, std::size_t handle, const Point& delta) {
    return movePoints(document, std::vector<PointId>{{0, handle}}, delta);
}

TEST(HandleModes, areReadOffTheHandles) {
    const Document document = smooth();
    EXPECT_EQ(modeOf(entryOf(document), 0), corner) << "one handle";
    EXPECT_EQ(modeOf(entryOf(document), 3), mirrored);
    EXPECT_EQ(modeOf(entryOf(document), 6), aligned);
    EXPECT_EQ(modeOf(entryOf(withHandleMoved(document, 6, {0, 0})), 6), aligned);
    const Document bent = setPoint(document, {0, 2}, {13, 5});
    EXPECT_EQ(modeOf(entryOf(bent), 3), corner);
    const Document shrunk = setPoint(document, {0, 2}, {14, 4});
    EXPECT_EQ(modeOf(entryOf(shrunk), 3), corner) << "no direction";
}

TEST(HandleModes, areReadRightFarFromTheOrigin) {
    const std::vector<PointId> all = {{0, 0}, {0, 3}, {0, 6}, {0, 9}};
    const Document document = movePoints(smooth(), all, {1e7 + 0.123456789, -3e7});
    EXPECT_EQ(modeOf(entryOf(document), 3), mirrored);
    EXPECT_EQ(modeOf(entryOf(document), 6), aligned);
}

TEST(HandleModes, areStoredOnlyWhereTheHandlesDoNotShowThem) {
    const Document document = smooth();
    EXPECT_EQ(withMode(document, 3, mirrored), document);
    EXPECT_EQ(withMode(document, 6, aligned), document);
    EXPECT_EQ(entryOf(withMode(document, 3, corner)).handleModes, (HandleModes{{3, corner}}));
    EXPECT_EQ(entryOf(withMode(document, 3, aligned)).handleModes, (HandleModes{{3, aligned}}));
    EXPECT_TRUE(entryOf(withMode(document, 6, mirrored)).handleModes.empty());
    EXPECT_EQ(withMode(withMode(document, 3, corner), 3, mirrored), document);
    EXPECT_EQ(withMode(document, 2, corner), withMode(document, 3, corner)) << "by its handle";
}

TEST(HandleModes, turnBothHandlesOntoTheirMeanDirection) {
    Document document = setPoint(smooth(), {0, 2}, {14, 2}); // down, 2; the other one right, 1
    document = withMode(document, 3, aligned);
    const double half = std::sqrt(0.5);
    expectNear(pointOf(document, 2), Point{14, 4} - 2 * Point{half, half}, 1e-13, "arriving");
    expectNear(pointOf(document, 4), Point{14, 4} + 1 * Point{half, half}, 1e-13, "leaving");
    document = withMode(document, 3, mirrored);
    expectNear(pointOf(document, 2), Point{14, 4} - 1.5 * Point{half, half}, 1e-13, "arriving");
    expectNear(pointOf(document, 4), Point{14, 4} + 1.5 * Point{half, half}, 1e-13, "leaving");
    EXPECT_TRUE(entryOf(document).handleModes.empty());
}

TEST(HandleModes, aMovedHandleTakesItsPartnerAlongByTheMode) {
    const Document document = smooth();
    // Handle 2 goes from (13, 4) to (14, 1): below anchor 3, three away.
    const Point way = {1, -3};
    expectNear(pointOf(withHandleMoved(document, 2, way), 4), {14, 7}, 1e-13, "mirrored");
    expectNear(pointOf(withHandleMoved(withMode(document, 3, aligned), 2, way), 4), {14, 5}, 1e-13,
               "aligned");
    const Document free = withHandleMoved(withMode(document, 3, corner), 2, way);
    EXPECT_EQ(pointOf(free, 4), Point({15, 4})) << "corner, though they were in line";
    EXPECT_TRUE(entryOf(free).handleModes.empty()) << "now the handles show it";
}

TEST(HandleModes, automaticHandlesFollowTheParabolaThroughTheNeighbours) {
    Curve curve = emptyCurve({"bezier-spline", false, Ends::none}, 2);
    curve.points = {{0, 0}, {0, 0}, {9, 9}, {3, 4}, {9, 9}, {1, 1}, {15, 4}};
    const Document document = withMode(documentOf(curve), 3, automatic);
    // Legs of 5 and 12: the slope is 12/17 (3, 4)/5 + 5/17 (12, 0)/12.
    const Point slope = {12.0 / 17 * 0.6 + 5.0 / 17, 12.0 / 17 * 0.8};
    expectNear(pointOf(document, 2), Point{3, 4} - (5.0 / 3) * slope, 1e-13, "arriving");
    expectNear(pointOf(document, 4), Point{3, 4} + (12.0 / 3) * slope, 1e-13, "leaving");
    EXPECT_EQ(entryOf(document).handleModes, (HandleModes{{3, automatic}}));
}

TEST(HandleModes, automaticHandlesDoNotOvershoot) {
    Curve curve = emptyCurve({"bezier-spline", false, Ends::none}, 2);
    curve.points = {{1, 2}, {0, 0}, {0, 0}, {3, 4}, {0, 0}, {0, 0}, {1, 2}};
    const Document back = withMode(documentOf(curve), 3, automatic);
    EXPECT_EQ(pointOf(back, 2), Point({3, 4})) << "where the way turns back";
    EXPECT_EQ(pointOf(back, 4), Point({3, 4}));
    curve.points.set(0, {3, 4});
    const Document same = withMode(documentOf(curve), 3, automatic);
    EXPECT_EQ(pointOf(same, 2), Point({3, 4})) << "where two anchors coincide";
    EXPECT_FALSE(problemOf(same));
}

TEST(HandleModes, automaticEndsBeginWithoutCurvature) {
    Document document = smooth();
    document = withMode(withMode(document, 0, automatic), 9, automatic);
    expectNear(pointOf(document, 1), lerp(pointOf(document, 0), pointOf(document, 2), 0.5), 1e-14,
               "start");
    expectNear(pointOf(document, 8), lerp(pointOf(document, 9), pointOf(document, 7), 0.5), 1e-14,
               "end");
    Curve single = emptyCurve({"bezier-spline", false, Ends::none}, 2);
    single.points = {{0, 0}, {5, 5}, {7, 7}, {3, 6}};
    const Document line =
        setHandleMode(documentOf(single), std::vector<PointId>{{0, 0}, {0, 3}}, automatic);
    expectNear(pointOf(line, 1), {1, 2}, 1e-15, "straight");
    expectNear(pointOf(line, 2), {2, 4}, 1e-15, "straight");
}

TEST(HandleModes, automaticHandlesFollowWhatMoves) {
    const Document document = withMode(smooth(), 3, automatic);
    const Document moved = withHandleMoved(document, 0, {-5, 2});
    EXPECT_NE(pointOf(moved, 2), pointOf(document, 2)) << "a neighbour";
    EXPECT_EQ(moved,
              withMode(withHandleMoved(withMode(document, 3, corner), 0, {-5, 2}), 3, automatic));
    const Document itself = withHandleMoved(document, 3, {1, 1});
    EXPECT_EQ(modeOf(entryOf(itself), 3), automatic);
}

TEST(HandleModes, draggingAHandleOfAnAutomaticAnchorMakesItAligned) {
    const Document document = withMode(smooth(), 3, automatic);
    const double reach = distance(pointOf(document, 3), pointOf(document, 4));
    const Document after = withHandleMoved(document, 2, {0, -2});
    EXPECT_EQ(modeOf(entryOf(after), 3), aligned);
    EXPECT_NEAR(distance(pointOf(after, 3), pointOf(after, 4)), reach, 1e-12);
    EXPECT_EQ(modeOf(entryOf(setPoint(document, {0, 2}, {0, 0})), 3), corner);
}

TEST(HandleModes, keepTheirAnchorsThroughInsertionsAndDeletions) {
    const Document document = withMode(withMode(smooth(), 3, corner), 6, automatic);
    const Inserted first = insertOnCurve(document, 0, {0, 0.5});
    EXPECT_TRUE(first.keepsShape);
    EXPECT_EQ(entryOf(first.document).handleModes, (HandleModes{{6, corner}, {9, automatic}}));
    const Inserted second = insertOnCurve(document, 0, {2, 0.5});
    EXPECT_FALSE(second.keepsShape) << "the automatic handles beside it follow";
    EXPECT_EQ(entryOf(second.document).handleModes, (HandleModes{{3, corner}, {6, automatic}}));
    const Document deleted = deletePoints(document, std::vector<PointId>{{0, 0}});
    EXPECT_EQ(entryOf(deleted).handleModes, (HandleModes{{3, automatic}}))
        << "what was the corner at 3 is the start now, where there is nothing to keep";
    EXPECT_TRUE(
        entryOf(deletePoints(document, std::vector<PointId>{{0, 3}, {0, 6}})).handleModes.empty());
    EXPECT_EQ(entryOf(deletePoints(document, std::vector<PointId>{{0, 5}})).handleModes,
              (HandleModes{{3, corner}}))
        << "a handle drawn in is no automatic one";
}

TEST(HandleModes, newAnchorsAmongAutomaticOnesAreAutomatic) {
    const std::vector<PointId> all = {{0, 0}, {0, 3}, {0, 6}, {0, 9}};
    const Document document = setHandleMode(smooth(), all, automatic);
    EXPECT_EQ(entryOf(insertOnCurve(document, 0, {1, 0.3}).document).handleModes.size(), 5u);
    const Document longer = appendPoint(document, 0, {30, 3}).document;
    EXPECT_EQ(modeOf(entryOf(longer), 12), automatic);
    EXPECT_EQ(modeOf(entryOf(appendPoint(smooth(), 0, {30, 3}).document), 12), corner);
}

TEST(HandleModes, goWithTheFamilyAndFollowClosing) {
    const Document document = withMode(withMode(smooth(), 3, corner), 9, automatic);
    EXPECT_TRUE(entryOf(setFamily(document, 0, "cardinal")).handleModes.empty());
    const Document closed = setClosed(document, 0, true);
    EXPECT_EQ(entryOf(closed).handleModes, (HandleModes{{3, corner}, {9, automatic}}));
    EXPECT_EQ(handlesOf(*entryOf(closed), 9).size(), 2u);
    EXPECT_NE(pointOf(closed, 8), pointOf(document, 8)) << "it has two neighbours now";
}

TEST(HandleModes, succeedEachOther) {
    EXPECT_EQ(nextHandleMode(corner), aligned);
    EXPECT_EQ(nextHandleMode(aligned), mirrored);
    EXPECT_EQ(nextHandleMode(mirrored), automatic);
    EXPECT_EQ(nextHandleMode(automatic), corner);
    EXPECT_EQ(nameOf(automatic), "automatic");
}

/// One random edit of a Bézier spline.
Document withHandlesEdited(const Document& document, Dice& dice) {
    const Curve& curve = *document.curves[0];
    const auto any =
        static_cast<std::size_t>(dice.whole(0, static_cast<int>(curve.points.size()) - 1));
    const std::vector<PointId> ids = {{0, any}};
    switch (dice.whole(0, 7)) {
    case 0: return movePoints(document, ids, dice.pointOnGrid(2, 5));
    case 1: return setPoint(document, {0, any}, dice.pointOnGrid(2, 50));
    case 2: return appendPoint(document, 0, dice.pointOnGrid(2, 50)).document;
    case 3: return curve.points.size() > 12 ? deletePoints(document, ids) : document;
    case 4: return setClosed(document, 0, !curve.closed);
    case 5: {
        const auto pieces = static_cast<int>(piecesOf(curve).size());
        const Spot spot{static_cast<std::size_t>(dice.whole(0, pieces - 1)), dice.between(0, 1)};
        return insertOnCurve(document, 0, spot).document;
    }
    default: return setHandleMode(document, ids, static_cast<HandleMode>(dice.whole(0, 3)));
    }
}

TEST(HandleModes, staySoundOnAnyWay) {
    Dice dice(77);
    Document document = smooth();
    std::size_t stored = 0;
    for (int step = 0; step < 4000; ++step) {
        Document next = withHandlesEdited(document, dice);
        ASSERT_FALSE(problemOf(next)) << "step " << step;
        const auto& entry = entryOf(next);
        for (const auto& [anchor, mode] : entry.handleModes) {
            ASSERT_EQ(anchor % 3, 0u) << "step " << step;
            ASSERT_LT(anchor, entry->points.size()) << "step " << step;
            ASSERT_TRUE(mode == automatic || mode != shownMode(*entry, anchor)) << "step " << step;
        }
        Curve settled = *entry;
        HandleModes modes = entry.handleModes;
        settleModes(settled, modes);
        ASSERT_EQ(settled, *entry) << "automatic handles are in their places, step " << step;
        stored += entry.handleModes.size();
        document = entry->points.size() > 60 ? smooth() : std::move(next);
    }
    EXPECT_GT(stored, 4000u);
}

} // namespace
} // namespace splineloft
