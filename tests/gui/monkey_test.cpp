// A monkey at the machine: random events by the thousand. Whatever it does, the document stays one
// that can be drawn and saved, all numbers stay finite, and undo and redo lead there and back.
// SPLINELOFT_SEED chooses its mood, SPLINELOFT_EVENTS its patience.
#include "driver.h"
#include "hand.h"

#include "core/spline/catalog.h"
#include "ui/canvas/viewport.h"
#include "ui/commands.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

namespace splineloft::ui {
namespace {

unsigned long numberFrom(const char* variable, unsigned long otherwise) {
    const char* text = std::getenv(variable);
    return text != nullptr ? std::strtoul(text, nullptr, 10) : otherwise;
}

class Monkey {
  public:
    explicit Monkey(unsigned long seed) : random_(static_cast<std::mt19937::result_type>(seed)) {}

    /// One thing that a hand could do; often near what there is to touch.
    void act(Driver& driver) {
        switch (below(20)) {
        case 0:
        case 1: return key(driver);
        case 2: return driver.queue.push(WheelTurned{0, real(-3, 3), held_});
        case 3: return driver.queue.push(TextTyped{U"0123456789-+.eE\t β"[below(18)]});
        case 4: return rare(driver);
        case 5:
        case 6:
        case 7:
        case 8:
        case 9: return button(driver);
        default: return move(driver);
        }
    }

    std::size_t below(std::size_t count) {
        return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_);
    }

    Document someDocument() {
        Document document;
        for (auto count = below(4); count > 0; --count) {
            const auto& family = catalog()[below(catalog().size())];
            const bool closed = below(2) == 0 && family.closable;
            auto curve = below(3) == 0 ? curveOf(family.id, static_cast<int>(1 + below(6)))
                                       : curveOf(family.id, closed);
            addLists(curve);
            document.curves.push_back(std::make_shared<Curve>(curve));
        }
        return document;
    }

  private:
    /// Now and then weights, local parameters, and knots of its own, for a curve that may have
    /// them.
    void addLists(Curve& curve) {
        const auto& family = familyOf(curve);
        const auto n = curve.points.size();
        for (std::size_t i = 0; family.usesWeights && below(2) == 0 && i < n; ++i) {
            curve.weights.resize(n, 1);
            curve.weights[i] = real(0.1, 5);
        }
        for (const auto& parameter : family.parameters) {
            if (parameter.local && below(2) == 0) {
                curve.local[std::string(parameter.key)].assign(
                    n, real(parameter.sliderLeast, parameter.sliderMost));
            }
        }
        if (family.usesKnots && below(2) == 0) {
            const auto degree = static_cast<std::size_t>(parameterOf(curve, "degree"));
            for (std::size_t i = 0; i < n + (curve.closed ? 1 : degree + 1); ++i) {
                curve.knots.push_back(static_cast<double>(i));
            }
            curve.ends = Ends::none;
        }
    }

    double real(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random_);
    }

    void move(Driver& driver) {
        ScreenPoint to{real(-20, driver.screen.width + 20), real(-20, driver.screen.height + 20)};
        const auto& curves = driver.session.document().curves;
        if (below(2) == 0 && !curves.empty()) {
            const Curve& curve = *curves[below(curves.size())];
            const auto places = controlPlaces(curve, driver.session.view.axes);
            if (!places.empty()) {
                to = driver.at(places[below(places.size())]);
                to.x += real(-3, 3);
            }
        }
        driver.queue.push(PointerMoved{to.x, to.y});
    }

    void button(Driver& driver) {
        const auto which = below(8);
        const auto button = which == 0 ? Button::right : which == 1 ? Button::middle : Button::left;
        bool& down = down_[static_cast<std::size_t>(button)];
        down = !down;
        driver.queue.push(PointerButton{button, down, held_});
        if (!down && below(3) == 0) { // a double click
            driver.queue.push(PointerButton{button, true, held_});
            driver.queue.push(PointerButton{button, false, held_});
        }
    }

    void key(Driver& driver) {
        Shortcut shortcut{Key::tab, {}};
        const auto& all = commands();
        if (const auto& command = all[below(all.size())]; !command.shortcuts.empty()) {
            shortcut = command.shortcuts[below(command.shortcuts.size())];
        } else {
            held_ = {.shift = below(4) == 0, .control = below(4) == 0};
            shortcut = {held_.shift ? Key::leftShift : Key::leftControl, held_};
        }
        driver.queue.push(KeyChanged{shortcut.key, true, below(5) == 0, shortcut.modifiers});
        driver.queue.push(KeyChanged{shortcut.key, false, false, shortcut.modifiers});
    }

    void rare(Driver& driver) {
        switch (below(12)) {
        case 0: return driver.queue.push(FocusChanged{below(2) == 0});
        case 1: return driver.queue.push(FilesDropped{{"/there/file.json"}});
        case 2: return driver.queue.push(CloseAsked{});
        case 3: driver.screen.width = static_cast<int>(300 + below(1500)); return;
        case 4: driver.screen.height = static_cast<int>(200 + below(900)); return;
        default: return driver.queue.push(KeyChanged{Key::escape, true, false, {}});
        }
    }

    std::mt19937 random_;
    Modifiers held_;
    bool down_[3] = {};
};

/// What the program around the interface would do.
void answerRequests(Driver& driver, Monkey& monkey) {
    const auto requests = std::exchange(driver.session.requests, {});
    for (const auto& request : requests) {
        if (std::holds_alternative<OpenFiles>(request)) {
            driver.session.opened(monkey.someDocument(), "/there/file.json");
        } else if (const auto* save = std::get_if<SaveFile>(&request)) {
            monkey.below(3) == 0 ? driver.session.saveFailed("the disk is full")
                                 : driver.session.wasSaved(save->path);
        }
    }
}

/// Undoes everything and does it again; both ways lead through the same documents.
void expectThereAndBack(Driver& driver, int event) {
    driver.session.giveUpGesture();
    std::vector<Document> states = {driver.session.document()};
    while (driver.session.history.canUndo()) {
        driver.session.undo();
        ASSERT_EQ(driver.faults(), "") << "undoing after event " << event;
        states.push_back(driver.session.document());
    }
    for (auto state = states.rbegin() + 1; state != states.rend(); ++state) {
        driver.session.redo();
        ASSERT_TRUE(driver.session.document() == *state) << "redoing after event " << event;
    }
}

TEST(Monkey, breaksNothing) {
    const auto seed = numberFrom("SPLINELOFT_SEED", 20'240'229);
    const auto events = static_cast<int>(numberFrom("SPLINELOFT_EVENTS", 20'000));
    SCOPED_TRACE("SPLINELOFT_SEED=" + std::to_string(seed));
    std::cout << "SPLINELOFT_SEED=" << seed << " SPLINELOFT_EVENTS=" << events << std::endl;
    Monkey monkey(seed);
    Driver driver(monkey.someDocument());
    std::size_t steps = 0;
    for (int event = 1; event <= events; ++event) {
        monkey.act(driver);
        driver.frames(1, 0.02);
        answerRequests(driver, monkey);
        ASSERT_EQ(driver.faults(), "") << "after event " << event;
        if (event % 1000 == 0) {
            steps += static_cast<std::size_t>(driver.steps());
            ASSERT_NO_FATAL_FAILURE(expectThereAndBack(driver, event));
            driver.session.opened(monkey.someDocument(), "");
            driver.session.dialog.reset();
        }
    }
    EXPECT_GT(steps, static_cast<std::size_t>(events) / 500) << "it did do something";
}

} // namespace
} // namespace splineloft::ui
