// A monkey at the machine: random events by the thousand. Whatever it does, the document stays one
// that can be drawn and saved, all numbers stay finite, undo and redo lead there and back, and
// memory does not grow. SPLINELOFT_SEED chooses its mood, SPLINELOFT_EVENTS its patience.
#include "chance.h"
#include "driver.h"
#include "tests/cases.h"

#include "ui/canvas/viewport.h"
#include "ui/commands.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <malloc.h>

#ifdef __SANITIZE_ADDRESS__
// Of sanitizer/allocator_interface.h, which GCC does not bring.
extern "C" std::size_t __sanitizer_get_current_allocated_bytes();
#endif

namespace splineloft::ui {
namespace {

class Monkey {
  public:
    explicit Monkey(unsigned long seed) : chance(seed) {}

    /// One thing that a hand could do; often near what there is to touch.
    void act(Driver& driver) {
        switch (chance.below(20)) {
        case 0:
        case 1: return key(driver);
        case 2: return driver.queue.push(WheelTurned{0, chance.real(-3, 3), held_});
        case 3: return driver.queue.push(TextTyped{U"0123456789-+.eE\t β"[chance.below(18)]});
        case 4: return rare(driver);
        case 5:
        case 6:
        case 7:
        case 8:
        case 9: return button(driver);
        default: return move(driver);
        }
    }

    Chance chance;

  private:
    void move(Driver& driver) {
        ScreenPoint to{chance.real(-20, driver.screen.width + 20),
                       chance.real(-20, driver.screen.height + 20)};
        const auto& curves = driver.session.document().curves;
        if (chance.below(2) == 0 && !curves.empty()) {
            const Curve& curve = *curves[chance.below(curves.size())];
            const auto places = controlPlaces(curve, driver.session.view.axes);
            if (!places.empty()) {
                to = driver.at(places[chance.below(places.size())]);
                to.x += chance.real(-3, 3);
            }
        }
        driver.queue.push(PointerMoved{to.x, to.y});
    }

    void button(Driver& driver) {
        const auto which = chance.below(8);
        const auto button = which == 0 ? Button::right : which == 1 ? Button::middle : Button::left;
        bool& down = down_[static_cast<std::size_t>(button)];
        down = !down;
        driver.queue.push(PointerButton{button, down, held_});
        if (!down && chance.below(3) == 0) { // a double click
            driver.queue.push(PointerButton{button, true, held_});
            driver.queue.push(PointerButton{button, false, held_});
        }
    }

    void key(Driver& driver) {
        Shortcut shortcut{Key::tab, {}};
        const auto& all = commands();
        if (const auto& command = all[chance.below(all.size())]; !command.shortcuts.empty()) {
            shortcut = command.shortcuts[chance.below(command.shortcuts.size())];
        } else {
            held_ = {.shift = chance.below(4) == 0, .control = chance.below(4) == 0};
            shortcut = {held_.shift ? Key::leftShift : Key::leftControl, held_};
        }
        driver.queue.push(KeyChanged{shortcut.key, true, chance.below(5) == 0, shortcut.modifiers});
        driver.queue.push(KeyChanged{shortcut.key, false, false, shortcut.modifiers});
    }

    void rare(Driver& driver) {
        switch (chance.below(12)) {
        case 0: return driver.queue.push(FocusChanged{chance.below(2) == 0});
        case 1: return driver.queue.push(FilesDropped{{"/there/file.json"}});
        case 2: return driver.queue.push(CloseAsked{});
        case 3: driver.screen.width = static_cast<int>(300 + chance.below(1500)); return;
        case 4: driver.screen.height = static_cast<int>(200 + chance.below(900)); return;
        default: return driver.queue.push(KeyChanged{Key::escape, true, false, {}});
        }
    }

    Modifiers held_;
    bool down_[3] = {};
};

/// What the program around the interface would do.
void answerRequests(Driver& driver, Monkey& monkey) {
    const auto requests = std::exchange(driver.session.requests, {});
    for (const auto& request : requests) {
        if (std::holds_alternative<OpenFiles>(request)) {
            driver.session.opened(monkey.chance.document(), "/there/file.json");
        } else if (const auto* save = std::get_if<SaveFile>(&request)) {
            monkey.chance.below(3) == 0 ? driver.session.failed("the disk is full", save->chosenIn)
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

/// Megabytes of memory that this program holds; 0 where the system does not tell. Under the address
/// sanitizer, what it has been given: freed memory, of which the sanitizer keeps much, is not held.
double heldMegabytes() {
#ifdef __SANITIZE_ADDRESS__
    return static_cast<double>(__sanitizer_get_current_allocated_bytes()) / (1 << 20);
#else
    malloc_trim(0); // what is free, and kept for later, is not held either
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;) {
        if (word == "VmRSS:") {
            double kilobytes = 0;
            status >> kilobytes;
            return kilobytes / 1024;
        }
    }
    return 0;
#endif
}

/// The least memory in each quarter of a run. A leak raises that too, and what a clipboard or a
/// long log holds at some moments does not.
class Account {
  public:
    void note(double done) {
        double& least = least_[std::min(static_cast<std::size_t>(4 * done), std::size_t{3})];
        const double now = heldMegabytes();
        least = least == 0 ? now : std::min(least, now);
    }

    /// How much more the last quarter held than the one before, as a part of that.
    double growth() const { return least_[2] > 0 ? least_[3] / least_[2] - 1 : 0; }

    void print() const {
        std::cout << "    memory, MB, by quarters:";
        for (const double least : least_) {
            std::cout << ' ' << least;
        }
        std::cout << std::endl;
    }

  private:
    std::array<double, 4> least_{};
};

/// Makes the program hold as little as it can: no document, in the usual window at the usual scale
/// (letters alone take from 4 to 20 MB, by their size). Then everything is as it was, but for the
/// document.
void noteAtRest(Driver& driver, Account& memory, double done) {
    const View view = std::exchange(driver.session.view, View{});
    const Screen screen = std::exchange(driver.screen, Screen{});
    driver.session.opened(Document{}, "");
    driver.session.dialog.reset();
    driver.frames(1, 0.02);
    memory.note(done);
    driver.session.view = view;
    driver.screen = screen;
}

/// Fewer events than these are over before everything has once been as large as it gets.
constexpr int eventsToFillMemory = 200'000;

TEST(Monkey, breaksNothing) {
    constexpr auto usual = testing_curves::underSanitizers ? 2'500 : 20'000;
    const auto seed = numberFrom("SPLINELOFT_SEED", 20'240'229);
    const auto events = static_cast<int>(numberFrom("SPLINELOFT_EVENTS", usual));
    SCOPED_TRACE("SPLINELOFT_SEED=" + std::to_string(seed));
    std::cout << "SPLINELOFT_SEED=" << seed << " SPLINELOFT_EVENTS=" << events << std::endl;
    Monkey monkey(seed);
    Driver driver(monkey.chance.document());
    std::size_t steps = 0;
    Account memory;
    for (int event = 1; event <= events; ++event) {
        monkey.act(driver);
        driver.frames(1, 0.02);
        answerRequests(driver, monkey);
        ASSERT_EQ(driver.faults(), "") << "after event " << event;
        if (event % 1000 == 0) {
            steps += static_cast<std::size_t>(driver.steps());
            ASSERT_NO_FATAL_FAILURE(expectThereAndBack(driver, event));
            noteAtRest(driver, memory, static_cast<double>(event) / events);
            driver.session.opened(monkey.chance.document(), "");
            driver.session.dialog.reset();
        }
    }
    memory.print();
    if (events >= eventsToFillMemory) {
        EXPECT_LT(memory.growth(), 0.01);
    }
    EXPECT_GT(steps, static_cast<std::size_t>(events) / 500) << "it did do something";
}

} // namespace
} // namespace splineloft::ui
