"""A desk to try the editor on: a screen of its own (Xvfb), the real program, and a pair of hands
(xdotool). No window manager is needed.

Nothing here sleeps for a guessed time. `Editor.settle` waits until the program has gone back to
sleep, which it does whenever there is nothing to draw, and `eventually` waits for what should be.
"""

import json
import os
import pathlib
import select
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import x11

ROOT = pathlib.Path(__file__).resolve().parents[2]
PATIENCE = 30  # seconds; far more than a busy machine needs


class Layout:
    """Where things are, in design pixels of a window of 1280 x 800; see layOut in ui/stage.cpp."""

    window = (1280, 800)
    menu, status, tools, inspector, strip = 32, 28, 46, 312, 208
    fit_margin = 72  # ui/refit.cpp

    canvas_width = window[0] - tools - inspector
    canvas_height = window[1] - menu - status - strip
    canvas_middle = (tools + canvas_width / 2, menu + canvas_height / 2)

    # In the inspector, for one curve of the family `cardinal`.
    family_list = (1120, 148)
    family_first, family_step = 178.5, 22
    tension_track = (984, 1264, 261)  # left end, right end, y
    tension_range = (0, 2)
    first_x_field = (1090, 580)  # of P0, with three joints above it

    # The button of the unsaved work that is offered, where there is one.
    restore = (544, 441)

    # The question about unsaved changes, in the middle of the window.
    question = {"Save": (504, 430), "Don't save": (640, 430), "Cancel": (776, 430)}


def eventually(condition, what):
    """What `condition` returns, as soon as that is true."""
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        result = condition()
        if result:
            return result
        time.sleep(0.02)
    raise AssertionError(f"this did not happen within {PATIENCE} s: {what}")


def own_places(home):
    """The environment in which a program leaves its settings and all else below `home`."""
    return {"HOME": str(home), "XDG_CONFIG_HOME": str(home / "config"),
            "XDG_STATE_HOME": str(home / "state")}


class Screen:
    """An X server without a monitor, for programs that take `home` for their home. `dpi` becomes
    the resource Xft.dpi, which scales windows."""

    def __init__(self, home, size=(1280, 800), dpi=None, options=()):
        reading, writing = os.pipe()
        # -noreset: else the resources would go when xrdb, the only client so far, leaves.
        self._server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(writing), "-screen", "0", f"{size[0]}x{size[1]}x24",
             "-noreset", "-nolisten", "tcp", *options],
            pass_fds=[writing], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(writing)
        with os.fdopen(reading) as pipe:
            if not select.select([pipe], [], [], PATIENCE)[0]:
                self._server.kill()
                self._server.wait()
                raise AssertionError("Xvfb did not start")
            # The whole line must be read: Xvfb dies of a pipe that is closed before its end.
            self.display = ":" + pipe.readline().strip()
        self.environment = {**os.environ, **own_places(home), "DISPLAY": self.display,
                            "SPLINELOFT_DIALOG": "own"}
        self.environment.pop("WAYLAND_DISPLAY", None)
        self._manager = None
        if dpi is not None:
            subprocess.run(["xrdb", "-merge"], input=f"Xft.dpi: {dpi}\n", text=True, check=True,
                           env=self.environment, timeout=PATIENCE)

    def close(self):
        if self._manager:
            self._manager.close()
        self._server.terminate()
        self._server.wait()

    @property
    def manager(self):
        self._manager = self._manager or x11.WindowManager(self.display)
        return self._manager

    def hands(self, *arguments):
        """One run of xdotool."""
        done = subprocess.run(["xdotool", *map(str, arguments)], env=self.environment, text=True,
                              capture_output=True, timeout=PATIENCE)
        if done.stderr:
            raise AssertionError(f"xdotool {arguments}: {done.stderr}")
        return done.stdout.strip()


class Editor:
    """The program with its window open, and what a person does to it. Places are design pixels."""

    def __init__(self, program, screen, *files, cwd=None, scale=1):
        self.screen, self.scale = screen, scale
        self._errors = tempfile.TemporaryFile()  # a pipe could become full
        self.process = subprocess.Popen([program, *map(str, files)], env=screen.environment,
                                        cwd=cwd, stderr=self._errors)
        self.window = eventually(self._find_window, "the window opens")
        self.settle()

    def _find_window(self):
        if self.process.poll() is not None:
            raise AssertionError("the program ended: " + self.complaints)
        found = self.screen.hands("search", "--onlyvisible", "--all", "--pid", self.process.pid,
                                  "--name", "Splineloft")
        return int(found.split()[0]) if found else None

    def close(self):
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()
        self._errors.close()

    # --- what can be seen from outside

    @property
    def complaints(self):
        """What it has written to its standard error so far."""
        errors = self._errors.fileno()
        return os.pread(errors, os.fstat(errors).st_size, 0).decode(errors="replace")

    @property
    def title(self):
        return self.screen.hands("getwindowname", self.window)

    @property
    def unsaved(self):
        return "●" in self.title

    @property
    def size(self):
        lines = self.screen.hands("getwindowgeometry", "--shell", self.window).splitlines()
        facts = dict(line.split("=") for line in lines)
        return int(facts["WIDTH"]), int(facts["HEIGHT"])

    def ticks(self):
        """Processor time used so far by all its threads, in clock ticks."""
        text = pathlib.Path(f"/proc/{self.process.pid}/stat").read_text()
        fields = text.rsplit(")", 1)[1].split()
        return int(fields[11]) + int(fields[12])

    def _status(self):
        text = pathlib.Path(f"/proc/{self.process.pid}/status").read_text()
        return dict(line.split(":\t", 1) for line in text.splitlines())

    def resident(self):
        """Kilobytes of memory that are its own at this moment."""
        return int(self._status()["VmRSS"].split()[0])

    def _sleep(self):
        """How often its main thread has gone to sleep so far; None if it is awake."""
        facts = self._status()
        return facts["voluntary_ctxt_switches"] if facts["State"][0] == "S" else None

    def settle(self):
        """Waits until the program sleeps: it was not once awake for some frames. Or has ended."""
        def asleep():
            before = self._sleep()
            time.sleep(0.08)
            ended = self.process.poll() is not None
            return ended or (before and before == self._sleep())
        eventually(asleep, "the program comes to rest")

    def answer(self):
        """Waits until the program has taken all that was done to it so far, even if it is busy
        with something that does not end, such as playing. Or has ended."""
        manager = self.screen.manager
        question = manager.ping(self.window)
        eventually(lambda: manager.heard(question) or self.process.poll() is not None,
                   "the program answers")

    def ended(self):
        """Waits for the program to end by itself; its exit status."""
        eventually(lambda: self.process.poll() is not None, "the program ends")
        return self.process.returncode

    # --- hands

    def _at(self, place):
        return [round(place[0] * self.scale), round(place[1] * self.scale)]

    def _move(self, place):
        return ["mousemove", "--window", self.window, *self._at(place)]

    def act(self, *arguments):
        self.screen.hands(*arguments)
        self.settle()

    def point(self, place):
        self.act(*self._move(place))

    def click(self, place, times=1):
        self.point(place)
        self.act(*["click", 1] * times)

    def press(self):
        self.act("mousedown", 1)

    def release(self, button=1):
        self.act("mouseup", button)

    def turn_wheel(self, place, steps):
        """Up, or down where `steps` is negative."""
        self.point(place)
        self.act(*["click", 4 if steps > 0 else 5] * abs(steps))

    def keys(self, *names):
        for name in names:
            self.act("key", name)

    def type(self, text):
        self.act("type", "--delay", 5, "--", text)

    def drag(self, start, end, holding=None, steps=3):
        """Presses, moves in steps and lets go, with a key held if so wished."""
        self.grab(start, end, holding, steps)
        self.release()
        if holding:
            self.act("keyup", holding)

    def grab(self, start, end, holding=None, steps=3, button=1):
        """A drag without its end."""
        self.point(start)
        if holding:
            self.act("keydown", holding)
        self.act("mousedown", button)
        for step in range(1, steps + 1):
            part = step / steps
            self.act(*self._move([a + (b - a) * part for a, b in zip(start, end)]))

    def drop(self, paths, place):
        """Carries files from another program to a place in the window and lets go."""
        position = self.screen.hands("getwindowgeometry", "--shell", self.window).splitlines()
        facts = dict(line.split("=") for line in position)
        x, y = self._at(place)
        other = x11.FileDrag(self.screen.display, paths)
        try:
            other.drop_on(self.window, int(facts["X"]) + x, int(facts["Y"]) + y, PATIENCE)
        finally:
            other.close()
        self.settle()

    def burst(self, start, end):
        """A whole drag that reaches the program at once: it is stopped until all has happened."""
        self.point(start)
        os.kill(self.process.pid, signal.SIGSTOP)
        self.screen.hands("mousedown", 1, *self._move(end), "mouseup", 1)
        os.kill(self.process.pid, signal.SIGCONT)
        self.settle()

    def saved(self, path):
        """Saves with Ctrl+S and reads the file back."""
        before = os.stat(path).st_ino, os.stat(path).st_mtime_ns
        self.act("key", "ctrl+s")
        eventually(lambda: (os.stat(path).st_ino, os.stat(path).st_mtime_ns) != before,
                   f"{path} is written")
        return json.loads(pathlib.Path(path).read_text())

    def ask_to_close(self):
        self.screen.manager.ask_to_close(self.window)
        self.settle()


class DeskTest(unittest.TestCase):
    """A test with a temporary folder, a screen and an editor, which are cleared away afterwards."""

    program = None

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="splineloft-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        self.home = pathlib.Path(tempfile.mkdtemp(prefix="splineloft-home-"))
        self.addCleanup(shutil.rmtree, self.home, ignore_errors=True)

    def screen(self, *arguments, **named):
        screen = Screen(self.home, *arguments, **named)
        self.addCleanup(screen.close)
        return screen

    def editor(self, *files, screen=None, scale=1, cwd=None):
        editor = Editor(self.program, screen or self.screen(), *files, scale=scale,
                        cwd=cwd or self.folder)
        self.addCleanup(editor.close)
        return editor

    def ask(self, *arguments):
        """What the command line answers."""
        done = subprocess.run([self.program, *map(str, arguments)], capture_output=True, text=True,
                              check=True, timeout=PATIENCE)
        return done.stdout


def require(tools):
    """Ends the script where tools are missing: as skipped, except in continuous integration, where
    that is a failure."""
    missing = [tool for tool in tools if shutil.which(tool) is None]
    if missing:
        verdict = "FAILED" if os.environ.get("CI") == "true" else "SKIPPED"
        print(f"{verdict}: not installed: {', '.join(missing)}", file=sys.stderr)
        sys.exit(1 if verdict == "FAILED" else 77)


def main(tools):
    """Runs the tests of the calling script, which need these tools: SCRIPT PROGRAM [TEST...]"""
    require(tools)
    DeskTest.program = str(pathlib.Path(sys.argv.pop(1)).resolve())
    unittest.main(verbosity=2)
