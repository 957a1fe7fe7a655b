// Undo and redo of whole documents.
#include "core/document/history.h"

#include "tests/property/random_curves.h"

#include <cmath>

namespace splineloft {
namespace {

using testing_curves::Dice;

/// A document that is recognisable by one number.
Document numbered(double number) {
    Curve curve;
    curve.points = {{number, 7}, {3, number}};
    Document document;
    document.curves = {std::make_shared<Curve>(curve)};
    return document;
}

TEST(History, beginsSettledWithNothingToUndo) {
    History history(numbered(1));
    EXPECT_EQ(history.live(), numbered(1));
    EXPECT_FALSE(history.canUndo() || history.canRedo() || history.previewing());
    EXPECT_EQ(history.undoLabel(), "");
    EXPECT_EQ(history.redoLabel(), "");
    history.undo();
    history.redo();
    EXPECT_EQ(history.live(), numbered(1));
}

TEST(History, namesTheStepsInBothDirections) {
    History history(numbered(0));
    history.commit(numbered(1), "Move P1");
    history.commit(numbered(2), "Close");
    EXPECT_EQ(history.undoLabel(), "Close");
    history.undo();
    EXPECT_EQ(history.undoLabel(), "Move P1");
    EXPECT_EQ(history.redoLabel(), "Close");
    history.undo();
    EXPECT_EQ(history.undoLabel(), "");
    EXPECT_EQ(history.redoLabel(), "Move P1");
}

TEST(History, aChangeOfNothingIsNoStep) {
    History history(numbered(0));
    history.commit(numbered(1), "Move");
    history.undo();
    EXPECT_FALSE(history.commit(numbered(0), "Nothing"));
    EXPECT_FALSE(history.canUndo());
    EXPECT_TRUE(history.canRedo()) << "what could be redone still can";
    history.preview(numbered(5));
    EXPECT_FALSE(history.commit(numbered(0), "There and back"));
    EXPECT_FALSE(history.previewing());
    EXPECT_EQ(history.live(), numbered(0));
}

TEST(History, aDragIsOneStepAndCancellingItNone) {
    History history(numbered(0));
    for (int i = 1; i <= 50; ++i) {
        history.preview(numbered(i));
        EXPECT_EQ(history.live(), numbered(i));
        EXPECT_EQ(history.settled(), numbered(0));
    }
    EXPECT_TRUE(history.commit(numbered(50), "Drag"));
    history.undo();
    EXPECT_EQ(history.live(), numbered(0));
    EXPECT_FALSE(history.canUndo());
    history.preview(numbered(9));
    history.cancel();
    EXPECT_EQ(history.live(), numbered(0));
    EXPECT_EQ(history.redoLabel(), "Drag") << "a preview forgets nothing";
}

TEST(History, aNewStepForgetsWhatWasUndone) {
    History history(numbered(0));
    history.commit(numbered(1), "one");
    history.commit(numbered(2), "two");
    history.undo();
    history.commit(numbered(3), "three");
    EXPECT_FALSE(history.canRedo());
    history.undo();
    EXPECT_EQ(history.live(), numbered(1));
}

TEST(History, remembersTwoThousandSteps) {
    History history(numbered(0));
    for (int i = 1; i <= 2500; ++i) {
        history.commit(numbered(i), std::to_string(i));
    }
    int steps = 0;
    while (history.canUndo()) {
        history.undo();
        ++steps;
    }
    EXPECT_EQ(steps, 2000);
    EXPECT_EQ(history.live(), numbered(500));
    EXPECT_EQ(history.undoLabel(), "");
    EXPECT_EQ(history.redoLabel(), "501");
    while (history.canRedo()) {
        history.redo();
    }
    EXPECT_EQ(history.live(), numbered(2500));
}

/// Random commands against a plain list of states with a finger in it.
TEST(History, isAListOfStates) {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        Dice dice(seed);
        History history(numbered(0));
        std::vector<double> states = {0};
        std::size_t now = 0;
        for (int step = 0; step < 300; ++step) {
            const double next = dice.whole(0, 3);
            switch (dice.whole(0, 4)) {
            case 0:
                if (history.commit(numbered(next), "commit")) {
                    states.resize(now + 1);
                    states.push_back(next);
                    ++now;
                }
                break;
            case 1: history.preview(numbered(next)); break;
            case 2: history.cancel(); break;
            case 3:
                history.undo();
                now -= now > 0 ? 1 : 0;
                break;
            default: history.redo(); now += now + 1 < states.size() ? 1 : 0;
            }
            ASSERT_EQ(history.settled(), numbered(states[now]))
                << "seed " << seed << " step " << step;
            ASSERT_EQ(history.canUndo(), now > 0) << "seed " << seed << " step " << step;
            ASSERT_EQ(history.canRedo(), now + 1 < states.size()) << "seed " << seed;
            ASSERT_TRUE(history.previewing() || history.live() == history.settled());
        }
    }
}

/// A document of one curve of so many points, all at `x`.
Document longDocument(std::size_t points, double x) {
    Curve curve;
    curve.points = Points(2);
    for (std::size_t i = 0; i < points; ++i) {
        curve.points.append(Point{x, 0});
    }
    Document document;
    document.curves = {std::make_shared<Curve>(curve)};
    return document;
}

TEST(History, forgetsTheOldestStepsBeyondSoManyBytes) {
    History history(longDocument(1000, 0), 10 * 16'000 + 10'000);
    for (int i = 1; i <= 50; ++i) {
        history.commit(longDocument(1000, i), "step");
    }
    int steps = 0;
    for (; history.canUndo(); history.undo()) {
        ++steps;
    }
    EXPECT_GE(steps, 8);
    EXPECT_LE(steps, 10);
    EXPECT_EQ(history.settled(), longDocument(1000, 50 - steps));
}

TEST(History, curvesThatAreSharedCountOnce) {
    const Document large = longDocument(1000, 0);
    History history(large, 40'000);
    for (int i = 1; i <= 1000; ++i) {
        Document next = large; // shares its curve
        next.extras = "{\"number\":" + std::to_string(i) + "}";
        history.commit(std::move(next), "step");
    }
    int steps = 0;
    for (; history.canUndo(); history.undo()) {
        ++steps;
    }
    EXPECT_EQ(steps, 1000);
}

TEST(History, keepsTheLastStepHoweverLarge) {
    History history(longDocument(1000, 0), 1);
    history.commit(longDocument(1000, 1), "step");
    history.commit(longDocument(1000, 2), "step");
    ASSERT_TRUE(history.canUndo());
    history.undo();
    EXPECT_EQ(history.settled(), longDocument(1000, 1));
    EXPECT_FALSE(history.canUndo());
}

TEST(Document, equalityLooksIntoTheCurves) {
    EXPECT_EQ(numbered(4), numbered(4)) << "not the same memory, but the same curve";
    EXPECT_NE(numbered(4), numbered(5));
    Document document = numbered(4);
    document.extras = R"({"by":"us"})";
    EXPECT_NE(document, numbered(4));
    EXPECT_NE(Document(), numbered(4));
    EXPECT_EQ(Document(), Document());
}

TEST(Document, problemsNameTheCurve) {
    Document document = numbered(4);
    EXPECT_FALSE(problemOf(document));
    document.curves.push_back(numbered(-1.5e9).curves[0]);
    const auto far = problemOf(document);
    ASSERT_TRUE(far);
    EXPECT_EQ(far->place, "/curves/1/points/0/0");
    Curve odd;
    odd.family = "odd";
    document.curves[1] = std::make_shared<Curve>(odd);
    ASSERT_TRUE(problemOf(document));
    EXPECT_EQ(problemOf(document)->place, "/curves/1/family");
}

TEST(Document, problemsOfAChangeAreThoseOfTheWhole) {
    const auto withPoint = [](Document document, std::size_t curve, double x) {
        Curve changed = *document.curves[curve];
        changed.points.set(1, {x, 2});
        document.curves[curve] = std::make_shared<Curve>(std::move(changed));
        return document;
    };
    Document sound = numbered(4);
    sound.curves.push_back(numbered(5).curves[0]);
    for (const double x : {5.0, 1e9, -1.5e9, 1e305, HUGE_VAL, std::nan("")}) {
        for (const std::size_t at : {0, 1}) {
            const Document after = withPoint(sound, at, x);
            const auto wanted = problemOf(after);
            const auto found = problemOf(after, sound);
            EXPECT_EQ(wanted.has_value(), !(std::abs(x) <= 1e9)) << x;
            ASSERT_EQ(found.has_value(), wanted.has_value()) << x;
            if (wanted) {
                EXPECT_EQ(found->place, wanted->place) << x;
                EXPECT_EQ(found->what, wanted->what) << x;
            }
        }
    }
    Curve odd = *sound.curves[1];
    odd.family = "odd";
    Document other = sound;
    other.curves[1] = std::make_shared<Curve>(odd);
    ASSERT_TRUE(problemOf(other, sound));
    EXPECT_EQ(problemOf(other, sound)->place, "/curves/1/family");
    EXPECT_FALSE(problemOf(sound, other));
}

} // namespace
} // namespace splineloft
