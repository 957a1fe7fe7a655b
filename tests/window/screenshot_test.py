"""Pictures of the editor against reference pictures, as they must look on any machine.

Both are made smaller by half, each pixel the mean of four, and then compared pixel by pixel. Other
versions of Mesa smooth edges a little differently, which the means even out; a stroke that is
missing or elsewhere they do not hide. What passes as equal is given by LIMIT, and proven by the
other tests here: a softened or slightly shifted picture passes, one without a layer fails. Those
compare fresh pictures with each other and need no renewal.

usage: screenshot_test.py PROGRAM [TEST...]
       screenshot_test.py PROGRAM --renew     after the look has changed on purpose; look at them!
"""

import os
import pathlib
import shutil
import subprocess
import sys

import desk

EXAMPLES = desk.ROOT / "assets/examples"
REFERENCES = pathlib.Path(__file__).resolve().parent / "references"

ALL_LAYERS = "polygon,labels,ladder,comb,beads,joints,frames,basis"


class Scene:
    """An example, and the options of `splineloft screenshot` to draw it with."""

    def __init__(self, example, **options):
        self.example, self.options = example, options

    def draw(self, program, path, **changes):
        options = {**self.options, **changes}
        arguments = [part for key, value in options.items() for part in (f"--{key}", value)]
        # Without a display, so that it is drawn by the same means everywhere.
        environment = {key: value for key, value in os.environ.items()
                       if key not in ("DISPLAY", "WAYLAND_DISPLAY")}
        subprocess.run([program, "screenshot", EXAMPLES / f"{self.example}.json", "-o", path,
                        *arguments], check=True, env=environment, timeout=desk.PATIENCE)


SCENES = {
    "ship-lines-dark": Scene("ship-lines", size="1280x800"),
    "close-points-light": Scene("close-points", size="1280x800", theme="light",
                                show="polygon,labels,comb,joints,basis"),
    "families-light-large": Scene("families", size="1920x1080", theme="light"),
    "heart-dark-twice": Scene("heart", size="2560x1600", scale="2", show=ALL_LAYERS),
    "bezier-ladder-light-twice": Scene("bezier-ladder", size="2560x1600", scale="2",
                                       theme="light"),
    "flight-dark": Scene("flight", size="1280x800", show="polygon,labels,beads"),
    "flight-acceleration-light": Scene("flight", size="1280x800", theme="light",
                                       show="labels,joints,basis", plot="acceleration"),
    "lath-dark-large": Scene("lath", size="1920x1080", show="labels,comb,joints,basis"),
}

NOTICED = 24  # of 255: a difference that counts
LIMIT = 0.0015  # part of the pixels that may differ so


def halved(path, *changes):
    """The picture at half its size, three bytes a pixel."""
    done = subprocess.run(["convert", path, "-alpha", "off", *changes, "-scale", "50%",
                           "-depth", "8", "rgb:-"], check=True, capture_output=True)
    return done.stdout


def difference(one, other):
    """The part of the pixels that differ so much that it counts; 1 for pictures unlike in size."""
    if len(one) != len(other):
        return 1
    count = 0
    for at in range(0, len(one), 3):
        if one[at:at + 3] != other[at:at + 3]:
            count += max(abs(one[at + k] - other[at + k]) for k in range(3)) > NOTICED
    return count / (len(one) // 3)


def reference(name):
    return REFERENCES / f"{name}.png"


def renew(program):
    """Draws all references anew, in 160 colours, which is less than anyone can see."""
    REFERENCES.mkdir(exist_ok=True)
    for old in REFERENCES.glob("*.png"):
        old.unlink()
    for name, scene in SCENES.items():
        path = reference(name)
        scene.draw(program, path)
        subprocess.run(["convert", path, "-alpha", "off", "+dither", "-colors", "160", "-strip",
                        "-define", "png:compression-level=9", f"PNG8:{path}"], check=True)
        print(f"{path.stat().st_size:8} bytes  {path.relative_to(desk.ROOT)}")


class Screenshots(desk.DeskTest):
    def drawn(self, name, **changes):
        path = self.folder / f"{name}-{'-'.join(changes.values())}.png"
        SCENES[name].draw(self.program, path, **changes)
        return path

    def measured(self, name, one, other):
        share = difference(one, other)
        print(f"{name}: {100 * share:.3f} % of the pixels differ, "
              f"at most {100 * LIMIT:.3f} % may")
        return share

    def assert_noticed(self, name, picture, what):
        share = self.measured(name, halved(self.drawn(name)), halved(picture))
        self.assertGreater(share, LIMIT, f"{what} would not be noticed")

    def test_every_scene_looks_like_its_reference(self):
        for name in SCENES:
            with self.subTest(name):
                picture = self.drawn(name)
                share = self.measured(name, halved(reference(name)), halved(picture))
                if share > LIMIT:
                    kept = pathlib.Path.cwd() / f"{name}-differs.png"
                    shutil.copy(picture, kept)
                    self.fail(f"see {kept} beside {reference(name)}; if it is right, renew the "
                              "references as the head of this script says")

    def test_references_are_small(self):
        size = sum(reference(name).stat().st_size for name in SCENES)
        self.assertLess(size, 1_500_000)

    def test_another_smoothing_of_edges_passes(self):
        for name in ("ship-lines-dark", "close-points-light"):
            picture = self.drawn(name)
            for change in (["-blur", "0x0.4"], ["-distort", "SRT", "0,0 1 0 0.1,0.1"]):
                with self.subTest(name=name, change=change):
                    share = self.measured(name, halved(picture), halved(picture, *change))
                    self.assertLessEqual(share, LIMIT)

    def test_a_missing_layer_is_noticed(self):
        layers = ["polygon", "labels", "ladder", "basis"]
        for missing in layers:
            with self.subTest(missing):
                shown = ",".join(layer for layer in layers if layer != missing)
                self.assert_noticed("ship-lines-dark",
                                        self.drawn("ship-lines-dark", show=shown),
                                        f"a missing layer {missing}")

    def test_a_missing_comb_is_noticed(self):
        self.assert_noticed("lath-dark-large",
                            self.drawn("lath-dark-large", show="labels,joints,basis"),
                            "a missing comb")

    def test_a_missing_curve_is_noticed(self):
        # The curve's own colour is white in the dark theme; nothing else on the canvas has it.
        picture = self.drawn("ship-lines-dark")
        without = self.folder / "without.png"
        subprocess.run(["convert", picture, "-region", "920x530+47+33", "-fuzz", "12%",
                        "-fill", "#0f1216", "-opaque", "white", without], check=True)
        self.assert_noticed("ship-lines-dark", without, "a missing curve")

    def test_the_other_theme_is_noticed(self):
        self.assert_noticed("ship-lines-dark", self.drawn("ship-lines-dark", theme="light"),
                            "the other theme")


if __name__ == "__main__":
    if sys.argv[2:] == ["--renew"]:
        renew(str(pathlib.Path(sys.argv[1]).resolve()))
    else:
        desk.main(["convert"])
