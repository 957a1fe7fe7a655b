// Undo over a long sitting: whatever commands were run in whatever order, each that changed the
// document is one step, each that changed nothing is none, and all of it can be taken back and done
// again, byte for byte. SPLINELOFT_SEED chooses which commands, SPLINELOFT_COMMANDS how many.
#include "chance.h"
#include "driver.h"
#include "tests/cases.h"

#include "core/document/edits.h"
#include "core/formats/document_json.h"
#include "core/spline/catalog.h"
#include "ui/commands.h"

#include <gtest/gtest.h>

#include <iostream>

namespace splineloft::ui {
namespace {

constexpr std::size_t mostPoints = 300; ///< beyond these the sitting ends: duplicates double
constexpr std::size_t mostSteps = 1000; ///< fewer than undo holds

/// The commands that work on the document. Those of files leave it, undo is asked for by itself.
std::vector<const Command*> commandsOnDocuments() {
    std::vector<const Command*> found;
    for (const auto& command : commands()) {
        const auto& id = command.id;
        if (!id.starts_with("file.") && id != "edit.undo" && id != "edit.redo") {
            found.push_back(&command);
        }
    }
    return found;
}

/// A sitting at the editor, beside a plain list of the texts that its document has had.
class Sitting {
  public:
    Sitting(Driver& driver, Chance& chance) : session_(driver.session), chance_(chance) {
        session_.opened(chance.document(), "");
        texts_ = {text()};
    }

    bool isLong() const {
        std::size_t points = 0;
        for (const auto& curve : session_.document().curves) {
            points += curve->points.size();
        }
        return points > mostPoints || texts_.size() > mostSteps;
    }

    /// Steps that were made; some of them were undone and then forgotten for others.
    std::size_t steps() const { return steps_; }

    /// Does one thing, and sees that the history is as the list says.
    void act(const std::vector<const Command*>& all) {
        switch (chance_.below(16)) {
        case 0: return goBack();
        case 1: return goForth();
        case 2:
        case 3: drag(); break;
        case 4:
        case 5: turn(); break;
        case 6: add(); break;
        default: run(*chance_.among(all)); break;
        }
        noteStep();
    }

    /// Undoes everything, then does it all again.
    void expectThereAndBack() {
        while (now_ > 0) {
            ASSERT_NO_FATAL_FAILURE(goBack());
        }
        EXPECT_FALSE(session_.history.canUndo());
        while (now_ + 1 < texts_.size()) {
            ASSERT_NO_FATAL_FAILURE(goForth());
        }
        EXPECT_FALSE(session_.history.canRedo());
    }

  private:
    std::string text() const { return writeDocument(session_.document()); }

    void goBack() {
        session_.undo();
        now_ -= now_ > 0 ? 1 : 0;
        last_ = "undo";
        expectNow();
    }

    void goForth() {
        session_.redo();
        now_ += now_ + 1 < texts_.size() ? 1 : 0;
        last_ = "redo";
        expectNow();
    }

    void run(const Command& command) {
        last_ = command.id;
        choosePoints();
        if (command.possible(session_)) {
            command.run(session_);
        }
        session_.giveUpGesture();
        session_.dialog.reset();
        session_.contextMenu.reset();
        session_.requests.clear();
    }

    /// A drag of what is selected: three looks ahead, then it is let go or given up.
    void drag() {
        last_ = "drag";
        choosePoints();
        const auto ids = session_.view.selection.ids();
        const Document before = session_.document();
        for (const auto phase : {Phase::preview, Phase::preview, Phase::preview,
                                 chance_.oneIn(3) ? Phase::cancel : Phase::commit}) {
            Point delta = {chance_.real(-1, 1), chance_.real(-1, 1)};
            session_.apply({movePoints(before, ids, delta), phase, "Move"});
        }
    }

    /// A slider of the active curve, turned in two steps.
    void turn() {
        last_ = "turn";
        const auto active = session_.view.activeCurve;
        const Document before = session_.document();
        if (active >= before.curves.size() || familyOf(*before.curves[active]).parameters.empty()) {
            return;
        }
        const auto& parameter = chance_.among(familyOf(*before.curves[active]).parameters);
        for (const auto phase : {Phase::preview, Phase::commit}) {
            const double value = chance_.real(parameter.sliderLeast, parameter.sliderMost);
            session_.apply({setParameter(before, active, parameter.key, value), phase, "Turn"});
        }
    }

    /// A curve more, where there are few: what has been deleted leaves nothing to work on.
    void add() {
        last_ = "add";
        const Document more = chance_.document();
        if (session_.document().curves.size() < 3 && !more.curves.empty()) {
            session_.apply(
                {addCurve(session_.document(), *more.curves.front()), Phase::commit, "Add"});
        }
    }

    /// Selects a few points of any curves, and makes one of these the active one.
    void choosePoints() {
        const auto& curves = session_.document().curves;
        if (curves.empty() || chance_.oneIn(3)) {
            return; // as they are
        }
        session_.view.selection.clear();
        for (auto count = chance_.below(4); count > 0; --count) {
            const auto curve = chance_.below(curves.size());
            if (const auto points = curves[curve]->points.size(); points > 0) {
                session_.view.selection.insert({curve, chance_.below(points), Part::point});
                session_.view.activeCurve = curve;
            }
        }
    }

    void noteStep() {
        ASSERT_FALSE(session_.history.previewing()) << "after " << last_;
        if (const auto after = text(); after != texts_[now_]) {
            ++steps_;
            texts_.resize(++now_);
            texts_.push_back(after);
            EXPECT_FALSE(session_.history.undoLabel().empty()) << "after " << last_;
        }
        expectNow();
    }

    void expectNow() const {
        ASSERT_EQ(text(), texts_[now_]) << "after " << last_;
        ASSERT_EQ(session_.history.canUndo(), now_ > 0) << "after " << last_;
        ASSERT_EQ(session_.history.canRedo(), now_ + 1 < texts_.size()) << "after " << last_;
    }

    Session& session_;
    Chance& chance_;
    std::vector<std::string> texts_; ///< one of each state, as it would be saved
    std::size_t now_ = 0;
    std::size_t steps_ = 0;
    std::string last_;
};

TEST(UndoLaws, allCommandsAreTakenBackAndDoneAgainByteForByte) {
    const auto seed = numberFrom("SPLINELOFT_SEED", 1983);
    const auto count = numberFrom("SPLINELOFT_COMMANDS", testing_curves::casesOf(20'000));
    SCOPED_TRACE("SPLINELOFT_SEED=" + std::to_string(seed));
    Chance chance(seed);
    Driver driver;
    const auto all = commandsOnDocuments();
    std::size_t sittings = 0, steps = 0;
    for (unsigned long done = 0; done < count; ++sittings) {
        Sitting sitting(driver, chance);
        for (; done < count && !sitting.isLong(); ++done) {
            ASSERT_NO_FATAL_FAILURE(sitting.act(all)) << "command " << done;
        }
        steps += sitting.steps();
        ASSERT_NO_FATAL_FAILURE(sitting.expectThereAndBack()) << "command " << done;
    }
    std::cout << "    " << count << " commands in " << sittings << " sittings, seed " << seed
              << ", " << steps << " steps" << std::endl;
    EXPECT_GT(steps, count / 10) << "it did do something";
}

} // namespace
} // namespace splineloft::ui
