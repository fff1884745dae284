#!/usr/bin/env python3
"""Random clicks, drags and keys: the editor does not end by itself, says no error, and saves a scene that can be read. Under Xvfb,
validated. --actions=2000 tries as many for each seed."""
import json
import random
import sys
import unittest

from editor_case import EditorTest

ACTIONS = int(next((word.partition("=")[2] for word in sys.argv if word.startswith("--actions=")), "120"))
SEEDS = (1, 2, 3)
# One Escape closes what is open; a second one in a row, with nothing to save, is how a person leaves.
KEYS = [*"abcdefghijklmnopqrstuvwxyz1234", "F1", "F2", "F4", "F6", "Up", "Down", "Left", "Right", "Return", "Tab", "Delete",
        "BackSpace", "Home", "KP_Enter", "minus", "period", *("ctrl+" + key for key in "zyadgrfos"), "ctrl+shift+z", "ctrl+shift+s",
        *("shift+" + key for key in "123hl"), "Escape 1"]


class Monkey(EditorTest):
    built = {"camera": {"position": [0, 0.8, 4], "target": [0, 0, 0], "fov_deg": 40}, "ambient": [0.25, 0.25, 0.3],
             "lights": [{"type": "directional", "direction": [-0.4, -0.8, -0.5], "intensity": 1.5}],
             "objects": [{"name": "cube", "model": "models/cube.obj"}]}

    def action(self, random_: random.Random) -> list:
        width, height = self.session.geometry()[2:]
        there = ["mousemove", "--window", self.session.window, str(random_.randrange(width)), str(random_.randrange(height))]
        kind, button = random_.random(), random_.choice("111123")
        if kind < 0.35:
            return [*there, "click", button]
        if kind < 0.55:
            by = [str(random_.randrange(-90, 90)) for _ in range(2)]
            return [*there, "mousedown", button, "mousemove_relative", "--", *by, "mouseup", button]
        if kind < 0.6:
            return [*there, "click", random_.choice("45")]
        return ["key", *random_.choice(KEYS).split()]

    def test_it_stays_open_and_what_it_saves_can_be_read(self):
        for seed in SEEDS:
            with self.subTest(seed=seed):
                random_ = random.Random(seed)
                for _ in range(ACTIONS // 10):
                    words = [word for _ in range(10) for word in [*self.action(random_), "sleep", "0.02"]]
                    self.session.xdotool(*words)
                    self.assertIsNone(self.session.process.poll(), " ".join(words))
                    self.session.park()  # the pointer comes last: all before it has arrived
                    self.session.read_all()
        said = [line for line in self.session.errors if line and not line.startswith("drawing: ")]  # how far a slow picture is
        self.assertEqual(said, [])
        for file in self.folder.glob("*.json*"):
            json.loads(file.read_text())


if __name__ == "__main__":
    unittest.main(argv=[word for word in sys.argv if not word.startswith("--actions=")])
