"""A monkey at the real window: thousands of moves, clicks, drags, keys and words, played by xdotool
on a screen of its own. Whatever it does, the program must go on and answer, its sanitizers must
stay silent, every document that it leaves must be a good one, and memory must not grow.

Every so often the hands let go of everything and begin a new document, saving the old one or not.
Only then is memory measured, so that the same is compared: an empty document in a window of the
usual size. Fonts for another size, or a buffer for many strokes, may still be there from before, so
what counts is the floor to which memory comes back: what never goes raises it. The least of the
third quarter against the least of the fourth is what it grew, all in one process, which is why
quitting on purpose is left to the first quarter. Should the monkey find Quit in a menu later, the
quarters are those of the process that lived longest. Of a sanitized program memory is told but not
judged: AddressSanitizer's own heap comes and goes by several percent.

The folder in which all files land lies so deep that clicking on ".." does not lead out of it.

usage: hands.py PROGRAM [ACTIONS [SEED]]
"""

import collections
import dataclasses
import json
import pathlib
import random
import re
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "window"))

import desk
from desk import Layout, eventually
from monkey import BUTTONS, LARGEST, MODIFIERS, Monkey

BATCH = 6  # actions in one run of xdotool
SITTING = 60  # actions from one new document to the next
LOGGED = 30  # actions that are told with a finding
MOST_FINDINGS = 5  # then it gives up
MOST_GROWTH = 0.01
ENOUGH = 5000  # actions from which on growth counts as a fault
ENOUGH_MEASURES = 32  # of one process, to tell growth from whim
DEPTH = 40  # of the folder in which it works
QUITS, KILLS = 0.1, 0.1  # parts of the sittings of the first quarter that end so
SHORT_NAME = 15  # letters of a file name with which the question is not wider than usual

ENVIRONMENT = {
    # Mesa and fontconfig leave leaks behind at the end, which are not ours. What is freed is kept
    # from use for a while, but not so much of it that it would look like growth.
    "ASAN_OPTIONS": "detect_leaks=0:quarantine_size_mb=16",
    "UBSAN_OPTIONS": "print_stacktrace=1",
    # By itself glibc takes ever larger blocks from its heap, where what is freed may stay resident:
    # megabytes come and go by whim. So, blocks beyond 128 kB go back to the system when freed.
    "MALLOC_MMAP_THRESHOLD_": "131072",
    "MALLOC_TRIM_THRESHOLD_": "131072"}

UNTITLED = "untitled - Splineloft"
SANITIZER = re.compile(r"runtime error:|ERROR: \w+Sanitizer")
NOT_FINITE = re.compile(r"\b(nan|inf(inity)?)\b", re.IGNORECASE)

X_NAMES = {"Esc": "Escape", "Enter": "Return", "Enter (keypad)": "KP_Enter", "Space": "space",
           "Backspace": "BackSpace", "←": "Left", "→": "Right", "↑": "Up", "↓": "Down",
           "-": "minus", "=": "equal", "+": "plus"}

EXAMPLES = ["families", "flight", "lath", "multiplicity", "rosette", "ship-lines"]  # to be opened


class Finding(Exception):
    """Something that the program must not do."""


class Ended(Exception):
    """The program has come to a good end."""


def x_shortcut(name):
    """A shortcut as xdotool writes it: "Ctrl+Shift+S" is ctrl+shift+s."""
    modifiers, key = re.fullmatch(r"((?:\w+\+)*)(.+)", name).groups()
    key = X_NAMES.get(key, key.lower() if len(key) == 1 else key)
    return modifiers.lower() + key


class Place:
    """A screen, a folder for files, and the judgement of what is found there."""

    def __init__(self, program, folder):
        self.program, self.folder = program, folder
        self.home, self.top = folder / "home", folder / "d"
        self.work = self.top.joinpath(*["d"] * DEPTH)
        self.home.mkdir()
        self.work.mkdir(parents=True)
        self.judged = 0
        self.sanitized = b"__asan_init" in pathlib.Path(program).read_bytes()
        self.tidy()
        self.screen = desk.Screen(self.home, LARGEST)
        for name, value in ENVIRONMENT.items():
            self.screen.environment.setdefault(name, value)

    def close(self):
        self.screen.close()

    def open(self):
        return desk.Editor(self.program, self.screen, cwd=self.work)

    def files(self):
        recovery = self.home / "state/splineloft/recovery"
        found = [*self.top.rglob("*"), *recovery.glob("*.json*")]
        return [path for path in found if path.is_file()]

    def tidy(self):
        """Nothing is there but some documents to open."""
        for path in self.top.rglob("*"):
            if path.is_file():
                path.unlink()
        for name in EXAMPLES:
            shutil.copy(desk.ROOT / f"assets/examples/{name}.json", self.work)

    def judge(self):
        """Every file that the program has left must be a good one."""
        for path in self.files():
            try:
                text = path.read_text()
            except FileNotFoundError:
                continue  # unsaved work, which is in a file by now
            fault = self.fault_of(path, text)
            if fault:
                raise Finding(f"{path}: {fault}\n{text}")
        self.judge_whereabouts()

    def fault_of(self, path, text):
        if path.suffix == ".bad":
            return "put aside as unreadable"
        if path.suffix == ".csv":
            return "a number that is not finite" if NOT_FINITE.search(text) else ""
        try:
            content = json.loads(text)
        except ValueError as fault:
            return str(fault)
        return "" if "samples" in content else self.verdict(text)

    def verdict(self, text):
        """What is wrong with a document, by the program itself."""
        said = subprocess.run([self.program, "check", "-"], input=text, capture_output=True,
                              text=True, env=self.screen.environment, timeout=desk.PATIENCE)
        self.judged += 1
        bad = said.returncode != 0 or SANITIZER.search(said.stderr)
        return said.stderr or f"exit code {said.returncode}" if bad else ""

    def judge_whereabouts(self):
        recent = self.home / "state/splineloft/recent.json"
        paths = json.loads(recent.read_text()) if recent.exists() else []
        strange = [path for path in paths if not path.startswith(str(self.folder))]
        if strange:
            sys.exit(f"the monkey has got out of its folder: {strange}")


@dataclasses.dataclass
class Measure:
    """Memory after so many actions, with an empty document."""

    life: int  # which process
    done: int
    kilobytes: int


def floors(measures):
    """The least of each quarter of the longest life; None where that is too short to tell."""
    lives = collections.defaultdict(list)
    for measure in measures:
        lives[measure.life].append(measure)
    longest = max(lives.values(), key=lambda life: life[-1].done - life[0].done, default=[])
    if len(longest) < ENOUGH_MEASURES:
        return None
    start, end = longest[0].done, longest[-1].done
    quarters = [[], [], [], []]
    for measure in longest:
        quarters[min(4 * (measure.done - start) // (end - start), 3)].append(measure.kilobytes)
    return [min(quarter) for quarter in quarters]


class Soak:
    """The monkey at the program, until it has done all its actions."""

    def __init__(self, place, actions, seed):
        self.place, self.actions = place, actions
        self.done, self.life, self.findings = 0, 0, 0
        self.changed = 0  # documents that were other than saved at the end of a sitting
        self.measures = []
        self.log = collections.deque(maxlen=LOGGED)
        self.editor = place.open()
        self.mood = random.Random(seed)  # of what is done between the deeds of the monkey
        self.monkey = Monkey(seed, self.read_shortcuts())

    def close(self):
        self.editor.close()

    def read_shortcuts(self):
        """The program's own table, from the file that it makes of it."""
        file = self.place.home / "config/splineloft/shortcuts.json"
        self.editor.keys("ctrl+shift+p")
        self.editor.type("Shortcuts file")
        self.editor.keys("Return")
        eventually(file.exists, "the shortcuts file is made")
        table = json.loads(file.read_text())
        file.unlink()
        return sorted({x_shortcut(name) for command, names in table.items() for name in names
                       if command != "file.quit"})

    def run(self):
        start, told = time.monotonic(), 0
        while self.done < self.actions and self.findings < MOST_FINDINGS:
            self.guarded(self.sit)
            tenth = 10 * self.done // self.actions
            if tenth > told:
                self.report(time.monotonic() - start)
                told = tenth
        self.guarded(self.end)

    def report(self, seconds):
        memory = f"{self.measures[-1].kilobytes / 1024:.1f} MB" if self.measures else "not measured"
        print(f"{self.done} actions, {seconds:.0f} s: {self.account()}, memory {memory}",
              flush=True)

    def account(self):
        return (f"{self.life} starts after an end, {self.findings} findings, {self.changed} "
                f"documents changed, {self.place.judged} checked")

    # --- life and death of the program

    def guarded(self, deed):
        try:
            deed()
        except Ended:
            self.begin_again()
        except (Finding, AssertionError, subprocess.TimeoutExpired) as fault:
            # A window that has gone is a fault to xdotool.
            if isinstance(fault, Finding) or not self.ends_well():
                self.tell(fault)
            self.begin_again()

    def look_after(self):
        """Raises an exception where the program has ended or complains."""
        status, said = self.editor.process.poll(), self.editor.complaints
        if status not in (None, 0) or SANITIZER.search(said):
            raise Finding(said or "it ended by itself")
        if status == 0:
            raise Ended

    def ends_well(self):
        try:
            status = self.editor.process.wait(timeout=5)
        except subprocess.TimeoutExpired:
            return False
        return status == 0 and not SANITIZER.search(self.editor.complaints)

    def tell(self, fault):
        self.findings += 1
        status = self.editor.process.poll()
        print(f"FINDING {self.findings}, after {self.done} actions: {fault}")
        print(f"exit code {status}\n{self.editor.complaints}" if status is not None else
              f"it still runs\n{self.stack()}", flush=True)
        print("the last actions:", *self.log, sep="\n    ", flush=True)

    def stack(self):
        """Where the program is, if there is something to look with."""
        if not shutil.which("gdb"):
            return ""
        return subprocess.run(["gdb", "-batch", "-p", str(self.editor.process.pid), "-ex",
                               "backtrace 40"], capture_output=True, text=True).stdout

    def begin_again(self):
        self.editor.close()
        self.place.tidy()
        self.log.clear()
        self.life += 1
        self.editor = self.place.open()

    # --- one sitting

    def sit(self):
        """The actions from one new document to the next."""
        for _ in range(SITTING // BATCH):
            self.batch(min(BATCH, self.actions - self.done))
        early, whim = self.done < self.actions / 4, self.mood.random()
        if early and whim > 1 - KILLS:
            self.kill()
        self.put_in_order()
        self.changed += self.editor.unsaved
        if self.mood.random() < 0.5 or len(self.editor.title) > len(UNTITLED) + SHORT_NAME:
            self.save()
        self.place.judge()
        if early and whim < QUITS:
            self.quit()
        self.begin_document()
        self.place.tidy()
        self.measures.append(Measure(self.life, self.done, self.editor.resident()))
        if self.mood.random() < 0.5:
            self.open_document(self.mood.choice(EXAMPLES))

    def do(self, *arguments):
        """One run of xdotool, which the program answers and survives."""
        self.place.screen.hands(*arguments)
        self.editor.answer()
        self.look_after()

    def batch(self, count):
        arguments = []
        for _ in range(count):
            action = self.monkey.act(self.editor.window)
            self.log.append(shlex.join(["xdotool", *action]))
            arguments += action
        self.done += count
        if arguments:
            self.do(*arguments)

    def put_in_order(self):
        """Lets go of all, closes all that is open, stops playing: a window of the usual size."""
        usual = ["windowsize", self.editor.window, *Layout.window]
        self.do(*usual, *self.editor._move(Layout.canvas_middle))
        for button in BUTTONS:
            self.do("mouseup", button)
        self.do("keyup", *MODIFIERS, "key", *["Escape"] * 8, "Left")
        # From the smallest interface the usual one is two steps away.
        self.do(*usual, "key", *["ctrl+minus"] * 8, *["ctrl+equal"] * 2)
        eventually(lambda: self.editor.size == Layout.window, "the window has its usual size")
        self.editor.settle()

    def save(self):
        self.name_file("ctrl+shift+s", f"left-{self.done}.json")

    def open_document(self, example):
        self.name_file("ctrl+o", f"{example}.json")

    def name_file(self, shortcut, name):
        self.do("key", shortcut)
        self.editor.settle()
        self.editor.type(name)
        self.do("key", "Return")
        eventually(lambda: self.editor.title == f"{name} - Splineloft", f"{shortcut}: {name}")

    def answer_question(self, unsaved):
        if unsaved:
            self.editor.settle()
            self.editor.click(Layout.question["Don't save"])

    def begin_document(self):
        unsaved = self.editor.unsaved
        self.do("key", "ctrl+n")
        self.answer_question(unsaved)
        eventually(lambda: self.editor.title == UNTITLED, "a new document is begun")
        self.editor.settle()

    def kill(self):
        """The next to start offers what this one leaves unsaved."""
        self.place.judge()
        self.editor.process.kill()
        raise Ended

    def end(self):
        """Quits for good."""
        try:
            self.quit()
        except Ended:
            pass

    def quit(self):
        unsaved = self.editor.unsaved
        self.editor.ask_to_close()
        self.answer_question(unsaved)
        self.editor.ended()
        self.look_after()


def verdict(soak):
    """Says what came of it; the exit code."""
    found = floors(soak.measures)
    grew = False
    if found:
        growth = found[3] / found[2] - 1
        judged = soak.actions >= ENOUGH and not soak.place.sanitized
        grew = judged and growth >= MOST_GROWTH
        quarters = ", ".join(f"{kilobytes / 1024:.1f}" for kilobytes in found)
        print(f"memory with an empty document, least in each quarter: {quarters} MB; "
              f"in the last half {100 * growth:+.2f} % "
              + (f"(goal: below {100 * MOST_GROWTH:g} %)" if judged else "(not judged)"))
    else:
        print("memory: too short to tell")
    print(f"{soak.done} actions: {soak.account()}")
    return 1 if grew or soak.findings else 0


def main(program, actions=ENOUGH, seed=None):
    desk.require(["Xvfb", "xdotool"])
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))  # by way of all that tidies up
    seed = random.randrange(1_000_000) if seed is None else int(seed)
    print(f"seed {seed}", flush=True)
    with tempfile.TemporaryDirectory(prefix="splineloft-hands-") as folder:
        place = Place(str(pathlib.Path(program).resolve()), pathlib.Path(folder))
        try:
            soak = Soak(place, int(actions), seed)
            try:
                soak.run()
            finally:
                soak.close()
        finally:
            place.close()
    return verdict(soak)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
