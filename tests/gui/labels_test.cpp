// Names on the canvas: none lies on another, none sticks out, and what must be read is there.
#include "ui/canvas/labels.h"

#include "driver.h"
#include "hand.h"

#include "core/spline/catalog.h"
#include "ui/canvas/illustrate.h"

#include "tests/gui/usual_frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace splineloft::ui {
namespace {

constexpr double markRadius = 7;

TextSize measured(const SceneLabel& label) {
    return {8.0 * static_cast<double>(label.text.size()) + (label.noted ? 14 : 0),
            label.noted ? 24.0 : 17.0};
}

bool overlap(const ScreenRect& a, const ScreenRect& b) {
    return a.left < b.right() && b.left < a.right() && a.top < b.bottom() && b.top < a.bottom();
}

void expectTidy(const std::vector<PlacedLabel>& placed, const ScreenRect& within,
                const std::string& where) {
    for (std::size_t i = 0; i < placed.size(); ++i) {
        const auto& r = placed[i].rect;
        EXPECT_TRUE(r.left >= within.left && r.top >= within.top && r.right() <= within.right() &&
                    r.bottom() <= within.bottom())
            << where << ": “" << placed[i].label->text << "” sticks out";
        for (std::size_t k = i + 1; k < placed.size(); ++k) {
            EXPECT_FALSE(overlap(r, placed[k].rect))
                << where << ": “" << placed[i].label->text << "” lies on “" << placed[k].label->text
                << "”";
        }
    }
}

Scene sceneOf(const Hand& hand, const View& view) {
    const Situation situation{hand.session.history.settled(),
                              hand.session.history.live(),
                              hand.session.studies,
                              {view.camera, usualFrame},
                              1};
    return illustrate(view, hand.session.gesture, situation);
}

TEST(LabelLaws, noneLiesOnAnotherAtAnyZoomOfAnyFamily) {
    for (const auto& family : catalog()) {
        Hand hand(documentOf({curveOf(family.id), curveOf("linear")}));
        View view = hand.session.view;
        for (const double zoom : {1.0, 8.0, 30.0, 100.0, 900.0}) {
            view.camera.pixelsPerUnit = zoom;
            for (const double u : {0.0, 0.3, 1.0}) {
                view.cursor.u = u;
                const Scene scene = sceneOf(hand, view);
                expectTidy(placeLabels(scene, measured, markRadius), usualFrame,
                           std::string(family.id) + " at zoom " + std::to_string(zoom));
            }
        }
    }
}

TEST(LabelLaws, noneLiesOnAnotherHoweverTheyCrowd) {
    std::mt19937 random(7);
    for (const double room : {5.0, 60.0, 400.0}) {
        Scene scene;
        scene.frame = usualFrame;
        std::uniform_real_distribution<double> spread(0, room);
        for (int i = 0; i < 120; ++i) {
            const ScreenPoint at{400 + spread(random), 200 + spread(random)};
            scene.marks.push_back({at, SignShape::disc, {Role::control, i}});
            SceneLabel label{"P_" + std::to_string(i), at, 11, {Role::control, i}};
            label.optional = i % 3 != 0;
            label.fixed = i % 7 == 0;
            label.noted = i % 11 == 0;
            scene.labels.push_back(label);
        }
        expectTidy(placeLabels(scene, measured, markRadius), usualFrame, std::to_string(room));
    }
}

TEST(LabelLaws, whereThereIsRoomEveryNameIsThereAndClearOfMarks) {
    Hand hand(documentOf({curveOf("cardinal")}));
    View view = hand.session.view;
    view.layers.ladder = false;
    const Scene scene = sceneOf(hand, view);
    const auto placed = placeLabels(scene, measured, markRadius);
    for (int i = 0; i < 7; ++i) {
        const auto name = "P_" + std::to_string(i);
        const auto found = std::ranges::find_if(
            placed, [&](const PlacedLabel& label) { return label.label->text == name; });
        ASSERT_NE(found, placed.end()) << name;
        for (const auto& mark : scene.marks) {
            const ScreenRect sign{mark.at.x - markRadius, mark.at.y - markRadius, 2 * markRadius,
                                  2 * markRadius};
            EXPECT_FALSE(overlap(found->rect, sign)) << name;
        }
    }
}

TEST(LabelLaws, aWeightIsTheNoteOfAPointThatIsTouched) {
    Curve curve = curveOf("nurbs");
    curve.weights = {1, 1, 2.5, 1, 0.125, 1, 1};
    Hand hand(documentOf({curve}));
    View view = hand.session.view;
    const auto notes = [&] {
        std::vector<std::string> texts;
        for (const auto& label : sceneOf(hand, view).labels) {
            if (label.text.find(" w ") != std::string::npos) {
                texts.push_back(label.text);
            }
        }
        return texts;
    };
    EXPECT_TRUE(notes().empty()) << "calm until it is asked";
    view.hovered = PointId{0, 2};
    EXPECT_EQ(notes(), (std::vector<std::string>{"P_2 · w 2.5"}));
    view.selection = {{0, 4}, {0, 5}};
    EXPECT_EQ(notes(), (std::vector<std::string>{"P_2 · w 2.5", "P_4 · w 0.125", "P_5 · w 1"}));
    expectTidy(placeLabels(sceneOf(hand, view), measured, markRadius), usualFrame, "weights");
    curve.weights.clear();
    hand = Hand(documentOf({curve}));
    EXPECT_TRUE(notes().empty()) << "where all weigh the same there is nothing to say";
}

TEST(LabelLaws, aFixedLabelStaysOrGoes) {
    Scene scene;
    scene.frame = usualFrame;
    SceneLabel number{"10", {100, 100}, 0, {Role::gridNumber}};
    number.fixed = true;
    scene.labels = {number, number};
    const auto placed = placeLabels(scene, measured, markRadius);
    ASSERT_EQ(placed.size(), 1U) << "the second would lie on the first";
    EXPECT_EQ(placed[0].rect.left, 100);
    EXPECT_EQ(placed[0].rect.top + placed[0].rect.height / 2, 100) << "its middle line there";
}

TEST(LabelLaws, inAFrameTooSmallThereAreNone) {
    Scene scene;
    scene.frame = {46, 32, 5, 5};
    SceneLabel name{"P_0", {48, 34}, 11, {Role::control}};
    name.optional = false;
    scene.labels = {name};
    EXPECT_TRUE(placeLabels(scene, measured, markRadius).empty());
}

} // namespace
} // namespace splineloft::ui
