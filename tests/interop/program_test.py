"""The built program from outside: no display, pipes, files with odd names, a decimal comma.

What the commands compute and refuse is tested in command_line_test.cpp; here it is the real thing.

usage: program_test.py PROGRAM
"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = str(pathlib.Path(sys.argv[1]).resolve())
SHIP = str(ROOT / "assets/examples/ship-lines.json")


def run(*arguments, cwd=None, given="", **environment):
    """Runs the program without any display."""
    settings = {key: value for key, value in os.environ.items()
                if key not in ("DISPLAY", "WAYLAND_DISPLAY")}
    settings.update(environment)
    return subprocess.run([PROGRAM, *arguments], input=given, capture_output=True, text=True,
                          cwd=cwd, env=settings, timeout=60)


class Program(unittest.TestCase):
    def test_commands_need_no_display(self):
        for arguments in (["--version"], ["--help"], ["families"], ["families", "--json"],
                          ["check", SHIP], ["eval", SHIP, "--t", "1.5"],
                          ["basis", SHIP, "--segment", "2", "--u", "0.25"],
                          ["sample", SHIP, "--count", "10", "--spacing", "time"]):
            ran = run(*arguments)
            self.assertEqual(ran.returncode, 0, (arguments, ran.stderr))
            self.assertEqual(ran.stderr, "")
            self.assertNotEqual(ran.stdout, "")

    def test_exit_codes(self):
        self.assertEqual(run("check", "missing.json").returncode, 1)
        self.assertEqual(run("eval", SHIP).returncode, 2)
        self.assertEqual(run("families", "--nonsense").returncode, 2)

    def test_standard_input(self):
        text = pathlib.Path(SHIP).read_text()
        self.assertEqual(run("check", "-", given=text).stdout,
                         "standard input: ok (1 curve, 7 points)\n")
        self.assertEqual(run("sample", "-", "--count", "7", given=text).stdout,
                         run("sample", SHIP, "--count", "7").stdout)

    def test_file_named_like_a_command(self):
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, "eval").write_text(pathlib.Path(SHIP).read_text())
            self.assertEqual(run("check", "eval", cwd=folder).stdout,
                             "eval: ok (1 curve, 7 points)\n")
            ran = run("eval", "./eval", "--t", "0", cwd=folder)
            self.assertEqual(json.loads(ran.stdout)[0]["position"], [-4.375, 0])

    def test_full_disk_at_the_other_end(self):
        with open("/dev/full", "w", encoding="utf-8") as full:
            ran = subprocess.run([PROGRAM, "families"], stdout=full, stderr=subprocess.PIPE,
                                 text=True, timeout=60, check=False)
        self.assertEqual(ran.returncode, 1)
        self.assertIn("standard output", ran.stderr)

    def test_decimal_comma_changes_nothing(self):
        with tempfile.TemporaryDirectory() as folder:
            made = subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8",
                                   os.path.join(folder, "de_DE.UTF-8")],
                                  capture_output=True, check=False)
            if made.returncode != 0 and not os.environ.get("CI"):
                self.skipTest("localedef could not make de_DE.UTF-8 (install locales)")
            self.assertEqual(made.returncode, 0, made.stderr)
            german = {"LOCPATH": folder, "LC_ALL": "de_DE.UTF-8"}
            for arguments in (["families", "--json"], ["eval", SHIP, "--t", "0.5,1.25"],
                              ["sample", SHIP, "--count", "9"], ["check", SHIP]):
                self.assertEqual(run(*arguments, **german).stdout, run(*arguments).stdout)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
