"""A monkey: what its hands do next, as arguments for xdotool. It sees nothing and knows only where
panels usually are, so the same seed gives the same deeds, whatever the program makes of them.
"""

import random

from desk import Layout

# Keys by their names in X. Caps Lock and Num Lock are left out: they would change what all later
# keys mean, those that put things in order included.
KEYS = ["Escape", "Return", "Tab", "BackSpace", "Delete", "Insert", "Home", "End", "Prior", "Next",
        "Left", "Right", "Up", "Down", "space", "KP_Enter", "Menu", "plus", "minus", "equal",
        "period", "comma", "slash", "bracketleft", "grave",
        *(f"F{number}" for number in range(1, 13)), *"0123456789",
        *"abcdefghijklmnopqrstuvwxyz"]
MODIFIERS = ["shift", "ctrl", "alt"]

# No slash: a typed name must not lead out of the folder.
LETTERS = [*"0123456789", *"0123456789", *"abcdefghijklmnopqrstuvwxyz", "plus", "minus", "asterisk",
           "period", "comma", "parenleft", "parenright", "space", "Greek_beta", "eacute"]

BUTTONS = LEFT, MIDDLE, RIGHT = 1, 2, 3
WHEEL = [4, 4, 4, 5, 5, 5, 6, 7]

LARGEST = (1440, 900)
SMALLEST = (160, 120)

_CANVAS_BOTTOM = Layout.window[1] - Layout.status - Layout.strip
_CANVAS_RIGHT = Layout.window[0] - Layout.inspector
# Left, top, right, bottom, and how often a hand goes there.
AREAS = [
    ((Layout.tools, Layout.menu, _CANVAS_RIGHT, _CANVAS_BOTTOM), 10),
    ((_CANVAS_RIGHT, Layout.menu, Layout.window[0], Layout.window[1] - Layout.status), 6),
    ((0, _CANVAS_BOTTOM, _CANVAS_RIGHT, Layout.window[1] - Layout.status), 3),
    ((0, Layout.menu, Layout.tools, _CANVAS_BOTTOM), 2),
    ((0, 0, 500, Layout.menu), 1),  # the menus, and what opens below them
    ((0, Layout.menu, 500, 500), 2),
    ((400, 300, 880, 500), 2),  # what is asked in the middle
    ((0, 0, *LARGEST), 1),  # outside as well
]


class Monkey:
    def __init__(self, seed, shortcuts):
        self._random = random.Random(seed)
        self._shortcuts = shortcuts  # as xdotool writes them
        self._visited = []  # places where there may be a point by now
        self._deeds = {self._wander: 8, self._click: 24, self._double_click: 5, self._drag: 18,
                       self._wheel: 6, self._key: 10, self._shortcut: 18, self._text: 6,
                       self._find_command: 2, self._resize: 2, self._grasp: 1}

    def act(self, window):
        """The next deed in a window, of that X id."""
        deed = self._random.choices(list(self._deeds), list(self._deeds.values()))[0]
        arguments = [str(argument) for argument in deed(window)]
        # Now and then a moment in which frames are drawn.
        return arguments + ["sleep", "0.05"] if self._chance(0.2) else arguments

    def _chance(self, part):
        return self._random.random() < part

    def _place(self):
        if self._visited and self._chance(0.4):
            x, y = self._random.choice(self._visited)
            return [max(part + self._random.randint(-3, 3), 0) for part in (x, y)]
        areas, weights = zip(*AREAS)
        left, top, right, bottom = self._random.choices(areas, weights)[0]
        place = self._random.randrange(left, right), self._random.randrange(top, bottom)
        self._visited = [*self._visited, place][-12:]
        return place

    def _move(self, window):
        return ["mousemove", "--window", window, *self._place()]

    def _button(self):
        return self._random.choices([LEFT, MIDDLE, RIGHT], [14, 2, 3])[0]

    def _holding(self, deed, part=0.2):
        """A deed, sometimes with a modifier held down."""
        if not self._chance(part):
            return deed
        modifier = self._random.choice(MODIFIERS)
        return ["keydown", modifier, *deed, "keyup", modifier]

    def _wander(self, window):
        steps = self._random.randint(1, 5)
        return [argument for _ in range(steps) for argument in self._move(window)]

    def _click(self, window):
        return self._holding([*self._move(window), "click", self._button()])

    def _double_click(self, window):
        return self._holding([*self._move(window), "click", LEFT, "click", LEFT])

    def _drag(self, window):
        button = self._button()
        steps = [argument for _ in range(self._random.randint(1, 5))
                 for argument in self._move(window)]
        end = self._random.choices([[], ["key", "Escape"], ["click", RIGHT]], [16, 1, 1])[0]
        held = ["mousedown", button, *steps, *end, "mouseup", button]
        return [*self._move(window), *self._holding(held, 0.3)]

    def _wheel(self, window):
        turns = ["click", self._random.choice(WHEEL)] * self._random.randint(1, 5)
        return [*self._move(window), *self._holding(turns)]

    def _key(self, window):
        names = [name for name in MODIFIERS if self._chance(0.15)] + [self._random.choice(KEYS)]
        name = "+".join(names)
        return [] if name == "ctrl+q" else ["key", *[name] * self._random.choice([1, 1, 1, 3])]

    def _shortcut(self, window):
        return ["key", self._random.choice(self._shortcuts)]

    def _typed(self, most):
        return [self._random.choice(LETTERS) for _ in range(self._random.randint(1, most))]

    def _text(self, window):
        end = self._random.choice([[], ["Return"], ["Tab"], ["Escape"]])
        start = ["ctrl+a"] if self._chance(0.3) else []
        return ["key", "--delay", 2, *start, *self._typed(8), *end]

    def _find_command(self, window):
        return ["key", "ctrl+shift+p", "sleep", "0.05", "key", *self._typed(3), "Return"]

    def _resize(self, window):
        size = [self._random.randint(least, most) for least, most in zip(SMALLEST, LARGEST)]
        usual = self._chance(0.6)
        return ["windowsize", window, *(Layout.window if usual else size)]

    def _grasp(self, window):
        """Takes hold of something and does not let go."""
        return [*self._move(window), "mousedown", self._button(), *self._move(window)]
