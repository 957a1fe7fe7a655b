// How far a frame looks into the queue: nothing changes there and back within one frame, nothing is
// lost, nothing changes places.
#include "ui/input.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <random>
#include <vector>

namespace splineloft::ui {
namespace {

constexpr KeyChanged pressed(Key key) {
    return {key, true, false, {}};
}

constexpr KeyChanged released(Key key) {
    return {key, false, false, {}};
}

constexpr PointerButton press{Button::left, true, {}};
constexpr PointerButton release{Button::left, false, {}};

// How many events each frame takes until the queue is empty.
std::vector<std::size_t> framesOf(std::initializer_list<InputEvent> events) {
    InputQueue queue;
    for (const auto& event : events) {
        queue.push(event);
    }
    std::vector<std::size_t> sizes;
    while (!queue.empty()) {
        sizes.push_back(queue.takeFrame().size());
    }
    return sizes;
}

using Sizes = std::vector<std::size_t>;

TEST(InputQueueTest, anEmptyQueueGivesAnEmptyFrame) {
    InputQueue queue;
    EXPECT_TRUE(queue.takeFrame().empty());
}

TEST(InputQueueTest, aDragThatArrivesAtOnceIsSeenAsThreeMoments) {
    EXPECT_EQ(framesOf({PointerMoved{3, 4}, press, PointerMoved{30, 44}, PointerMoved{60, 50},
                        release, PointerMoved{90, 90}}),
              (Sizes{2, 3, 1}));
}

TEST(InputQueueTest, aDoubleClickIsFourChanges) {
    EXPECT_EQ(framesOf({press, release, press, release}), (Sizes{1, 1, 1, 1}));
}

TEST(InputQueueTest, movesAndTextFlowTogether) {
    EXPECT_EQ(framesOf({PointerMoved{1, 2}, PointerMoved{3, 5}, TextTyped{U'a'}, TextTyped{U'β'},
                        WheelTurned{0, 1, {}}, WheelTurned{0, 1, {}}}),
              (Sizes{6}));
}

TEST(InputQueueTest, oneKeyChangesOnceAFrame) {
    EXPECT_EQ(framesOf({pressed(Key::a), TextTyped{U'a'}, pressed(Key::b), TextTyped{U'b'},
                        released(Key::a), released(Key::b)}),
              (Sizes{4, 2}));
}

TEST(InputQueueTest, controlIsStillHeldWhenItsShortcutIsSeen) {
    EXPECT_EQ(framesOf({pressed(Key::leftControl), pressed(Key::z), released(Key::leftControl),
                        released(Key::z)}),
              (Sizes{2, 2}));
    EXPECT_EQ(framesOf({pressed(Key::leftShift), press, released(Key::leftShift), release}),
              (Sizes{2, 2}));
    EXPECT_EQ(framesOf({WheelTurned{0, 1, {}}, pressed(Key::leftControl)}), (Sizes{1, 1}));
}

TEST(InputQueueTest, textTypedAfterBackspaceIsInsertedAfterIt) {
    EXPECT_EQ(framesOf({TextTyped{U'a'}, pressed(Key::backspace), TextTyped{U'b'}}), (Sizes{2, 1}));
}

TEST(InputQueueTest, losingTheFocusComesAfterAllThatWentBefore) {
    EXPECT_EQ(framesOf({press, FocusChanged{false}, release, CloseAsked{}}), (Sizes{1, 3}));
}

TEST(InputQueueTest, nothingIsLostAndNothingChangesPlaces) {
    std::mt19937 random(20240317);
    InputQueue queue;
    std::vector<InputEvent> pushed;
    for (int i = 0; i < 2000; ++i) {
        const auto mark = i + 0.5; // tells every move from the others
        const auto key = std::vector{Key::a, Key::del, Key::leftShift}[random() % 3];
        const std::vector<InputEvent> choices{PointerMoved{mark, 2 * mark},
                                              press,
                                              release,
                                              pressed(key),
                                              released(key),
                                              TextTyped{U'x'}};
        pushed.push_back(choices[random() % choices.size()]);
        queue.push(pushed.back());
    }
    std::size_t next = 0;
    while (!queue.empty()) {
        const auto frame = queue.takeFrame();
        ASSERT_FALSE(frame.empty()) << "the queue would never become empty";
        for (const auto& event : frame) {
            ASSERT_EQ(event.index(), pushed[next].index()) << "event " << next;
            if (const auto* const moved = std::get_if<PointerMoved>(&event)) {
                ASSERT_EQ(moved->x, std::get<PointerMoved>(pushed[next]).x) << "event " << next;
            }
            ++next;
        }
    }
    EXPECT_EQ(next, pushed.size());
}

} // namespace
} // namespace splineloft::ui
