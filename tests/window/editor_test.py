"""The editor as a person meets it: a real window, a real mouse and keyboard, and the files that
come of it, compared number by number.

usage: editor_test.py PROGRAM [CLASS[.TEST]...]
"""

import csv
import json
import os
import subprocess
import time

import desk
from desk import Layout, eventually

# Its points span 3 x 1.94 units around (1, 2). So a window of 1280 x 800 shows a unit as 200
# pixels, and a pixel is 0.005 units: every pixel is a round number.
POINTS = [[-0.5, 1.03], [0, 2.5], [0.5, 2.97], [1.2, 1.6], [2.5, 2.2]]
MIDDLE = (1, 2)
PIXELS_PER_UNIT = (Layout.canvas_height - 2 * Layout.fit_margin) / 1.94


def at(place):
    """Where on the screen a place of the document is, in design pixels."""
    return (Layout.canvas_middle[0] + (place[0] - MIDDLE[0]) * PIXELS_PER_UNIT,
            Layout.canvas_middle[1] - (place[1] - MIDDLE[1]) * PIXELS_PER_UNIT)


def moved(place, right, down):
    """A place of the document so many pixels further, as the shortest number that says it."""
    return [round(place[0] + right / PIXELS_PER_UNIT, 3),
            round(place[1] - down / PIXELS_PER_UNIT, 3)]


def beside(place, right, down):
    x, y = at(place)
    return x + right, y + down


class WithDocument(desk.DeskTest):
    family = "cardinal"

    def setUp(self):
        super().setUp()
        self.path = self.folder / "path.json"
        # Opening fits what the curve passes, and straight lines stay within their points.
        self.path.write_text(json.dumps({
            "format": "splineloft", "version": 1,
            "curves": [{"name": "path", "family": "linear", "coordinates": ["x", "y"],
                        "points": POINTS}]}))

    def open(self, **named):
        """An editor on the document, its curve drawn by the family of the test and saved so."""
        editor = self.editor(self.path, **named)
        if self.family != "linear":
            editor.keys(self.digit(self.family))
            self.curve(editor)
        return editor

    def curve(self, editor):
        """The curve as it is in the file after saving."""
        document = editor.saved(self.path)
        self.assertFalse(editor.unsaved, editor.title)
        return document["curves"][0]

    def catalog(self):
        return [family["id"] for family in json.loads(self.ask("families", "--json"))]

    def digit(self, family):
        return str(self.catalog().index(family) + 1)


class Editing(WithDocument):
    def test_a_drag_moves_a_point_by_as_much(self):
        editor = self.open()
        editor.drag(at(POINTS[1]), beside(POINTS[1], 67, 43))
        self.assertTrue(editor.unsaved, editor.title)
        expected = list(POINTS)
        expected[1] = moved(POINTS[1], 67, 43)
        self.assertEqual(self.curve(editor)["points"], expected)

    def test_a_drag_that_arrives_all_at_once_is_a_drag(self):
        editor = self.open()
        editor.burst(at(POINTS[3]), beside(POINTS[3], -31, 58))
        expected = list(POINTS)
        expected[3] = moved(POINTS[3], -31, 58)
        self.assertEqual(self.curve(editor)["points"], expected)

    def test_shift_keeps_the_axis_and_control_snaps_to_the_grid(self):
        editor = self.open()
        editor.drag(at(POINTS[1]), beside(POINTS[1], 67, 13), holding="shift")
        editor.drag(at(POINTS[3]), beside(POINTS[3], -27, 47), holding="ctrl")
        expected = list(POINTS)
        expected[1] = moved(POINTS[1], 67, 0)
        # Lines of the fine grid are 0.1 units apart, 20 pixels: the next one from 1.065, 1.365.
        expected[3] = [1.1, 1.4]
        self.assertEqual(self.curve(editor)["points"], expected)

    def test_escape_in_mid_drag_restores(self):
        editor = self.open()
        editor.grab(at(POINTS[2]), beside(POINTS[2], 90, 70))
        editor.keys("Escape")
        editor.release()
        self.assertFalse(editor.unsaved, editor.title)
        self.assertEqual(self.curve(editor)["points"], POINTS)

    def test_control_z_takes_a_drag_back_as_one_step(self):
        editor = self.open()
        editor.drag(at(POINTS[2]), beside(POINTS[2], 90, 70), steps=12)
        editor.keys("ctrl+z")
        self.assertFalse(editor.unsaved, editor.title)
        editor.keys("ctrl+y")
        self.assertEqual(self.curve(editor)["points"][2], moved(POINTS[2], 90, 70))

    def test_a_double_click_on_the_curve_inserts_a_point_on_it(self):
        editor = self.open()
        middle = [(a + b) / 2 for a, b in zip(POINTS[3], POINTS[4])]
        editor.keys(self.digit("linear"))
        editor.click(at(middle), times=2)
        points = self.curve(editor)["points"]
        self.assertEqual(points[:4] + points[5:], POINTS)
        for found, wanted in zip(points[4], middle):
            self.assertAlmostEqual(found, wanted, delta=1.5 / PIXELS_PER_UNIT)

    def test_the_pen_adds_points_at_the_end(self):
        editor = self.open()
        places = [beside(MIDDLE, 220, -130), beside(MIDDLE, 300, 90), beside(MIDDLE, 60, 140)]
        editor.keys("p")
        for place in places:
            editor.click(place)
        editor.keys("Escape")
        expected = [moved(MIDDLE, 220, -130), moved(MIDDLE, 300, 90), moved(MIDDLE, 60, 140)]
        self.assertEqual(self.curve(editor)["points"], POINTS + expected)

    def test_delete_takes_the_selected_points_away(self):
        editor = self.open()
        editor.click(at(POINTS[1]))
        editor.act("keydown", "shift")
        editor.click(at(POINTS[3]))
        editor.act("keyup", "shift")
        editor.keys("Delete")
        self.assertEqual(self.curve(editor)["points"], [POINTS[0], POINTS[2], POINTS[4]])

    def test_digits_and_the_list_change_the_family_and_keep_the_points(self):
        editor = self.open()
        catalog = self.catalog()
        for family in catalog[:9]:
            editor.keys(self.digit(family))
            self.assertEqual(self.curve(editor)["family"], family)
        editor.keys(self.digit("cardinal"))
        for family in ("b-spline", "natural"):
            editor.click(Layout.family_list)
            editor.click((Layout.family_list[0] - 60,
                          Layout.family_first + Layout.family_step * catalog.index(family)))
            curve = self.curve(editor)
            self.assertEqual(curve["family"], family)
            self.assertEqual(curve["points"], POINTS)

    def test_the_tension_slider_follows_the_hand(self):
        editor = self.open()
        left, right, y = Layout.tension_track
        low, high = Layout.tension_range
        place = lambda tension: (left + (tension - low) / (high - low) * (right - left), y)
        self.assertEqual(self.curve(editor)["parameters"], {"tension": 0.5})
        editor.drag(place(0.5), place(1.5))
        self.assertEqual(self.curve(editor)["parameters"], {"tension": 1.5})
        editor.grab(place(1.5), place(0.25))
        editor.keys("Escape")
        editor.release()
        self.assertEqual(self.curve(editor)["parameters"], {"tension": 1.5})
        editor.keys("ctrl+z")
        self.assertEqual(self.curve(editor)["parameters"], {"tension": 0.5})

    def test_values_can_be_typed_one_after_the_other(self):
        editor = self.open()
        editor.click(Layout.first_x_field)
        editor.keys("ctrl+a")
        editor.type("3+0.125")
        editor.keys("Tab")
        editor.type("-0.5")
        editor.keys("Return")
        self.assertEqual(self.curve(editor)["points"], [[3.125, -0.5]] + POINTS[1:])


class Viewing(WithDocument):
    """What the wheel and the middle button do shows in how far a drag then moves a point."""

    def test_the_wheel_zooms_at_the_pointer(self):
        editor = self.open()
        editor.turn_wheel(at(POINTS[3]), 3)
        editor.drag(at(POINTS[3]), beside(POINTS[3], 60, 0), holding="shift")
        nearer = self.curve(editor)["points"][3]
        self.assertEqual(nearer[1], POINTS[3][1])
        self.assertGreater(nearer[0], POINTS[3][0])
        self.assertLess(nearer[0] - POINTS[3][0], 0.8 * 60 / PIXELS_PER_UNIT)

        editor.keys("ctrl+z")
        editor.turn_wheel(at(POINTS[3]), -3)
        editor.drag(at(POINTS[3]), beside(POINTS[3], 60, 0), holding="shift")
        found = self.curve(editor)["points"][3]
        for number, expected in zip(found, moved(POINTS[3], 60, 0)):
            self.assertAlmostEqual(number, expected, delta=1 / PIXELS_PER_UNIT)

    def test_the_middle_button_takes_the_view_along(self):
        editor = self.open()
        editor.grab(at(MIDDLE), beside(MIDDLE, 70, 35), button=2)
        editor.release(button=2)
        self.assertFalse(editor.unsaved, editor.title)
        editor.drag(beside(POINTS[1], 70, 35), beside(POINTS[1], 100, 60))
        expected = list(POINTS)
        expected[1] = moved(POINTS[1], 30, 25)
        self.assertEqual(self.curve(editor)["points"], expected)


class SystemClipboard(WithDocument):
    def clipboard(self, screen):
        return subprocess.run(["xclip", "-selection", "clipboard", "-o"], text=True, check=True,
                              env=screen.environment, capture_output=True,
                              timeout=desk.PATIENCE).stdout

    def put(self, screen, text):
        # Its second process keeps the text, and must not keep the pipes of this one.
        subprocess.run(["xclip", "-selection", "clipboard", "-i"], input=text, text=True,
                       check=True, env=screen.environment, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL, timeout=desk.PATIENCE)

    def test_curves_go_from_one_window_to_another(self):
        screen = self.screen()
        first = self.open(screen=screen)
        first.keys("ctrl+a", "ctrl+c")
        self.assertEqual(json.loads(self.clipboard(screen))["curves"][0]["points"], POINTS)

        other = self.folder / "other.json"
        other.write_text(json.dumps({"format": "splineloft", "version": 1, "curves": []}))
        second = self.editor(other, screen=screen)
        second.point(Layout.canvas_middle)
        second.keys("ctrl+v")
        document = second.saved(other)
        self.assertEqual([curve["points"] for curve in document["curves"]], [POINTS])

    def test_path_data_of_svg_becomes_a_curve(self):
        screen = self.screen()
        editor = self.open(screen=screen)
        self.put(screen, "M 0,0 C 1,2 3,2 4,0")
        editor.keys("ctrl+v")
        document = editor.saved(self.path)
        self.assertEqual(len(document["curves"]), 2)
        self.assertEqual(document["curves"][1]["family"], "bezier-spline")
        self.assertEqual(len(document["curves"][1]["points"]), 4)


class Dropping(WithDocument):
    def setUp(self):
        super().setUp()
        self.other = self.folder / "another one, with ümlaut.json"
        self.other.write_text(json.dumps({
            "format": "splineloft", "version": 1,
            "curves": [{"name": "other", "family": "linear", "coordinates": ["x", "y"],
                        "points": [[0, 0], [1, 1]]}]}))

    def test_a_dropped_file_is_opened(self):
        editor = self.open()
        editor.drop([self.other], Layout.canvas_middle)
        eventually(lambda: self.other.name in editor.title, "the title shows the dropped file")

    def test_two_files_come_together(self):
        editor = self.open()
        editor.drop([self.other, self.path], Layout.canvas_middle)
        target = self.folder / "both.json"
        editor.keys("ctrl+shift+s", "ctrl+a")
        editor.type(str(target))
        editor.keys("Return")
        eventually(target.exists, "both are saved as one")
        document = json.loads(target.read_text())
        self.assertEqual([curve["name"] for curve in document["curves"]], ["other", "path"])

    def test_changes_are_asked_about_first(self):
        editor = self.open()
        editor.drag(at(POINTS[1]), beside(POINTS[1], 67, 43))
        editor.drop([self.other], Layout.canvas_middle)
        editor.click(Layout.question["Cancel"])
        self.assertTrue(editor.unsaved, editor.title)
        editor.drop([self.other], Layout.canvas_middle)
        editor.click(Layout.question["Don't save"])
        eventually(lambda: self.other.name in editor.title, "the title shows the dropped file")
        self.assertEqual(json.loads(self.path.read_text())["curves"][0]["points"], POINTS)


class HighResolution(WithDocument):
    def test_twice_the_dots_make_everything_twice_as_large(self):
        screen = self.screen((2560, 1600), dpi=192)
        editor = self.open(screen=screen, scale=2)
        self.assertEqual(editor.size, (2560, 1600))
        editor.drag(at(POINTS[1]), beside(POINTS[1], 67, 43))
        left, right, y = Layout.tension_track
        editor.drag((left + (right - left) / 4, y), (left + (right - left) / 2, y))
        curve = self.curve(editor)
        expected = list(POINTS)
        expected[1] = moved(POINTS[1], 67, 43)
        self.assertEqual(curve["points"], expected)
        self.assertEqual(curve["parameters"], {"tension": 1})


class Presenting(WithDocument):
    def test_f11_fills_the_monitor_and_gives_everything_back(self):
        editor = self.open(screen=self.screen((1920, 1080)))
        for leave in ("F11", "Escape"):
            editor.keys("F11")
            eventually(lambda: editor.size == (1920, 1080), "the window fills the monitor")
            editor.keys(leave)
            eventually(lambda: editor.size == Layout.window, "the window is as large as before")
            editor.settle()
        editor.drag(at(POINTS[1]), beside(POINTS[1], 67, 43))
        self.assertEqual(self.curve(editor)["points"][1], moved(POINTS[1], 67, 43))


class Files(WithDocument):
    def test_save_as_takes_a_typed_name_and_goes_on_under_it(self):
        editor = self.open()
        editor.drag(at(POINTS[1]), beside(POINTS[1], 20, 20))
        editor.keys("ctrl+shift+s")
        editor.type("a copy")
        editor.keys("Return")
        copy = self.folder / "a copy.json"
        eventually(copy.exists, "the copy is written")
        eventually(lambda: editor.title.startswith("a copy.json"), "the title tells the new name")
        written = json.loads(copy.read_text())["curves"][0]["points"]
        self.assertEqual(written[1], moved(POINTS[1], 20, 20))
        self.assertEqual(json.loads(self.path.read_text())["curves"][0]["points"], POINTS)

    def test_save_as_asks_before_it_replaces_a_file(self):
        other = self.folder / "other.json"
        other.write_text("mine")
        editor = self.open()
        editor.keys("ctrl+shift+s")
        editor.type("other")
        editor.keys("Return")
        self.assertEqual(other.read_text(), "mine")
        editor.keys("Escape")
        self.assertEqual(other.read_text(), "mine")
        self.assertTrue(editor.title.startswith("path.json"), editor.title)

    def test_exported_samples_are_those_of_the_command_line(self):
        editor = self.open()
        editor.keys("ctrl+e")
        editor.type("out.csv")
        editor.keys("Return")
        out = self.folder / "out.csv"
        eventually(out.exists, "the samples are written")
        expected = self.ask("sample", self.path, "--count", 100, "--spacing", "length")
        self.assertEqual(out.read_text(), expected)
        rows = list(csv.DictReader(expected.splitlines()))
        self.assertEqual(len(rows), 100)
        self.assertEqual([float(rows[0]["x"]), float(rows[0]["y"])], POINTS[0])
        for coordinate, wanted in zip("xy", POINTS[-1]):
            self.assertAlmostEqual(float(rows[-1][coordinate]), wanted, places=12)

    def test_a_damaged_file_leaves_the_document_as_it_is(self):
        (self.folder / "damaged.json").write_text('{"format": "splineloft",')
        editor = self.open()
        editor.keys("ctrl+o")
        editor.type("damaged.json")
        editor.keys("Return")
        editor.keys("Escape")  # the browser is there again, for another choice
        self.assertTrue(editor.title.startswith("path.json"), editor.title)
        self.assertEqual(self.curve(editor)["points"], POINTS)

    def test_a_file_that_cannot_be_written_leaves_the_changes_unsaved(self):
        editor = self.open()
        editor.drag(at(POINTS[1]), beside(POINTS[1], 20, 20))
        self.path.unlink()
        self.folder.rename(self.folder.with_suffix(".gone"))
        self.addCleanup(lambda: self.folder.with_suffix(".gone").rename(self.folder))
        editor.keys("ctrl+s")
        self.assertTrue(editor.unsaved, editor.title)
        self.assertIsNone(editor.process.poll())


class Recovery(WithDocument):
    """What a killed editor had in no file comes back."""

    def recovery(self):
        return sorted((self.home / "state/splineloft/recovery").glob("*.json"))

    def kill_with_changes(self, editor):
        """Kills an editor once its changes are kept: it does so at once after twenty."""
        editor.click(at(POINTS[1]))
        editor.keys(*["Right"] * 20)
        self.assertTrue(editor.unsaved, editor.title)
        eventually(self.recovery, "the changes are kept")
        editor.settle()
        editor.close()
        return json.loads(self.recovery()[0].read_text())["curves"][0]["points"]

    def test_after_a_kill_the_next_start_offers_the_changes(self):
        screen = self.screen()
        before = self.path.read_text()
        points = self.kill_with_changes(self.editor(self.path, screen=screen))
        self.assertNotEqual(points, POINTS)
        editor = self.editor(screen=screen)
        editor.click(Layout.restore)
        self.assertTrue(editor.title.startswith("path.json ●"), editor.title)
        self.assertEqual(self.path.read_text(), before, "a restored file is not saved by itself")
        self.assertEqual(self.curve(editor)["points"], points)
        eventually(lambda: not self.recovery(), "what is saved is kept no longer")

    def test_at_a_logout_nothing_is_lost(self):
        screen = self.screen()
        editor = self.open(screen=screen)
        editor.drag(at(POINTS[1]), beside(POINTS[1], 67, 43))
        editor.process.terminate()
        self.assertEqual(editor.ended(), 0)
        self.assertEqual(editor.complaints, "")
        self.assertEqual(json.loads(self.path.read_text())["curves"][0]["points"], POINTS)

        again = self.editor(screen=screen)
        again.click(Layout.restore)
        self.assertTrue(again.unsaved, again.title)
        expected = list(POINTS)
        expected[1] = moved(POINTS[1], 67, 43)
        self.assertEqual(self.curve(again)["points"], expected)

    def test_an_editor_that_still_runs_is_left_alone(self):
        screen = self.screen()
        first = self.editor(self.path, screen=screen)
        first.click(at(POINTS[1]))
        first.keys(*["Right"] * 20)
        eventually(self.recovery, "the changes are kept")
        second = subprocess.Popen([self.program], env=screen.environment, cwd=self.folder)
        self.addCleanup(second.wait)
        self.addCleanup(second.kill)
        eventually(lambda: len(screen.hands("search", "--onlyvisible", "--name",
                                            "Splineloft").split()) == 2, "the second opens")
        first.settle()
        self.assertEqual(len(self.recovery()), 1)

    def test_not_saving_on_purpose_leaves_nothing(self):
        editor = self.editor(self.path)
        editor.click(at(POINTS[1]))
        editor.keys(*["Right"] * 20)
        eventually(self.recovery, "the changes are kept")
        editor.ask_to_close()
        editor.click(Layout.question["Don't save"])
        self.assertEqual(editor.ended(), 0)
        self.assertEqual(list((self.home / "state/splineloft/recovery").iterdir()), [])


class Settings(WithDocument):
    def test_what_was_set_holds_at_the_next_start(self):
        screen = self.screen()
        file = self.home / "config/splineloft/settings.json"
        editor = self.editor(self.path, screen=screen)
        editor.keys("t", "k")
        eventually(lambda: file.exists() and json.loads(file.read_text())["theme"] == "light",
                   "the settings are written")
        editor.close()
        before = file.read_text()
        editor = self.editor(self.path, screen=screen)
        editor.ask_to_close()
        self.assertEqual(editor.ended(), 0)
        self.assertEqual(file.read_text(), before, "the same holds, and nothing was changed")

    def test_broken_ones_are_kept_beside(self):
        file = self.home / "config/splineloft/settings.json"
        file.parent.mkdir(parents=True)
        file.write_text("{ broken")
        editor = self.editor(self.path)
        self.assertEqual(file.with_suffix(".json.bad").read_text(), "{ broken")
        self.assertFalse(editor.unsaved)


class SystemDialog(WithDocument):
    """The system's dialog, played by a script."""

    def open_with(self, script):
        folder = self.home / "programs"
        folder.mkdir()
        program = folder / "zenity"
        program.write_text("#!/bin/sh\n" + script)
        program.chmod(0o755)
        screen = self.screen()
        screen.environment["PATH"] = f"{folder}:{os.environ['PATH']}"
        del screen.environment["SPLINELOFT_DIALOG"]
        return self.editor(self.path, screen=screen)

    def test_the_chosen_file_is_opened_and_the_editor_answers_meanwhile(self):
        other = self.folder / "other.json"
        other.write_text(self.path.read_text())
        go = self.folder / "go"
        editor = self.open_with(f"until [ -e '{go}' ]; do sleep 0.05; done; echo '{other}'")
        editor.screen.hands("key", "ctrl+o")
        editor.screen.hands(*editor._move(at(POINTS[1])), "click", 1, "key", "Right")
        eventually(lambda: editor.unsaved, "the editor answers while the dialog is open")
        editor.screen.hands("key", "ctrl+z")
        eventually(lambda: not editor.unsaved, "the change is undone")
        go.touch()
        eventually(lambda: editor.title.startswith("other.json"), "the chosen file is opened")

    def test_cancel_is_no_answer(self):
        editor = self.open_with("sleep 0.4; exit 1")
        editor.keys("ctrl+o")
        time.sleep(0.8)
        editor.settle()
        self.assertTrue(editor.title.startswith("path.json"), editor.title)
        editor.drag(at(POINTS[1]), beside(POINTS[1], 20, 20))
        self.assertTrue(editor.unsaved, "the canvas is free")


class Closing(WithDocument):
    def changed(self):
        """An editor with a change that is in no file, asked to close."""
        editor = self.open()
        editor.drag(at(POINTS[1]), beside(POINTS[1], 20, 20))
        self.assertTrue(editor.unsaved, editor.title)
        editor.ask_to_close()
        self.assertIsNone(editor.process.poll(), "it closed without asking")
        return editor

    def in_file(self):
        return json.loads(self.path.read_text())["curves"][0]["points"]

    def test_without_changes_it_just_closes(self):
        editor = self.open()
        editor.ask_to_close()
        self.assertEqual(editor.ended(), 0)

    def test_cancel_goes_on(self):
        editor = self.changed()
        editor.click(Layout.question["Cancel"])
        self.assertIsNone(editor.process.poll())
        self.assertEqual(self.curve(editor)["points"][1], moved(POINTS[1], 20, 20))

    def test_escape_goes_on(self):
        editor = self.changed()
        editor.keys("Escape")
        self.assertIsNone(editor.process.poll())
        self.assertTrue(editor.unsaved, editor.title)

    def test_dont_save_leaves_the_file_as_it_was(self):
        editor = self.changed()
        editor.click(Layout.question["Don't save"])
        self.assertEqual(editor.ended(), 0)
        self.assertEqual(self.in_file(), POINTS)

    def test_save_saves_and_closes(self):
        editor = self.changed()
        editor.click(Layout.question["Save"])
        self.assertEqual(editor.ended(), 0)
        self.assertEqual(self.in_file()[1], moved(POINTS[1], 20, 20))

    def test_closing_that_was_called_off_in_the_browser_is_forgotten(self):
        editor = self.editor(self.folder / "not there yet.json")
        editor.keys("ctrl+n", "p")
        for right in (-100, 0, 100):
            editor.click(beside(MIDDLE, right, 50))
        editor.keys("Return", "ctrl+q")
        editor.click(Layout.question["Save"])
        editor.keys("Escape", "ctrl+shift+s")
        editor.type("later")
        editor.keys("Return")
        eventually((self.folder / "later.json").exists, "the file is written")
        editor.settle()
        self.assertIsNone(editor.process.poll(), "it closed long after that was called off")


class Starting(desk.DeskTest):
    """Where no window can be had: a line with the cause and the remedy, and no core dump."""

    def refused(self, environment):
        ran = subprocess.run([self.program, desk.ROOT / "assets/examples/ship-lines.json"],
                             env=environment, capture_output=True, text=True,
                             timeout=desk.PATIENCE, cwd=self.folder)
        self.assertEqual(ran.returncode, 1, ran.stderr)  # a negative one would be a signal
        lines = ran.stderr.splitlines()
        self.assertEqual(len(lines), 1, ran.stderr)
        self.assertRegex(lines[0], r"^splineloft: .+\(.+\)$")
        return lines[0]

    def test_no_display_at_all(self):
        environment = {**self.screen().environment}
        del environment["DISPLAY"]
        self.assertIn("DISPLAY", self.refused(environment))

    def test_a_display_that_is_not_there(self):
        environment = {**self.screen().environment, "DISPLAY": ":6553"}
        self.assertIn(":6553", self.refused(environment))

    def test_an_opengl_that_is_too_old(self):
        environment = {**self.screen().environment, "MESA_GL_VERSION_OVERRIDE": "2.1"}
        self.assertIn("OpenGL 3.3", self.refused(environment))

    def test_a_display_without_opengl(self):
        screen = self.screen(options=["-extension", "GLX"])
        self.assertRegex(self.refused(screen.environment), "OpenGL|GLX")


class Idle(WithDocument):
    # A blinking text cursor or one needless frame a second would cost more.
    MOST = 0.02  # of one core
    SECONDS = 10

    def test_doing_nothing_costs_nothing(self):
        self.assert_idle(self.open())

    def test_nor_does_unsaved_work_once_it_is_kept(self):
        editor = self.open()
        editor.click(at(POINTS[1]))
        editor.keys(*["Right"] * 25)
        self.assertTrue(editor.unsaved, editor.title)
        self.assert_idle(editor)

    def assert_idle(self, editor):
        before = editor.ticks()
        time.sleep(self.SECONDS)
        ticks = editor.ticks() - before
        share = ticks / os.sysconf("SC_CLK_TCK") / self.SECONDS
        print(f"idle: {100 * share:.2f} % of a core over {self.SECONDS} s")
        self.assertLessEqual(share, self.MOST)


if __name__ == "__main__":
    desk.main(["Xvfb", "xdotool", "xrdb", "xclip"])
