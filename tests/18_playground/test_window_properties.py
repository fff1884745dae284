#!/usr/bin/env python3
"""Properties of several entries at once, and methods that the program chooses, by real clicks and keys. Under Xvfb,
validated."""
import re
import unittest

from editor_case import EditorTest

# Seen from far away: frames in which little is drawn take less time.
SCENE = {"camera": {"position": [0, 5, 25], "target": [0, 0, 0], "fov_deg": 40}, "ambient": [0.25, 0.25, 0.3],
         "lights": [{"type": "point", "position": [0, 3, 0], "intensity": 2, "name": "first"},
                    {"type": "spot", "position": [1, 3, 0], "intensity": 3, "name": "second", "shadow": True}],
         "objects": [{"name": "one", "model": "models/cube.obj", "position": [-1, 0.25, 0]},
                     {"name": "two", "model": "models/cube.obj", "position": [1, 0.5, 0]}]}


class Properties(EditorTest):
    built = SCENE

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.before = cls().saved()

    def select(self, *names: str):
        """The last one is the active one."""
        for i, name in enumerate(names):
            self.session.tap("entry." + name, held="ctrl" if i else "")
        self.session.read_all()

    def undo_step(self, step: str):
        self.said_after("notice undone: " + step, "ctrl+z")

    def test_1_a_number_is_typed_and_is_one_step(self):
        self.select("one")
        self.type_number("numbers.position", "1.25")
        self.assertEqual(self.saved()["objects"][0]["position"][0], 1.25)
        self.undo()
        self.assertEqual(self.saved(), self.before)

    def test_4_switches_and_types_of_several_are_set_by_one_click(self):
        session = self.session
        self.select("second", "first")
        session.tap("check.shadow")  # of one only: then of both
        self.assertEqual([light.get("shadow") for light in self.saved()["lights"]], [True, True])
        session.tap("choice.type")
        session.tap("option.directional")
        self.assertEqual([light.get("type", "directional") for light in self.saved()["lights"]], ["directional"] * 2)
        self.undo_step("type of 2 entries")
        self.undo_step("shadow of first")
        self.select("one", "first", "two")  # objects and a light
        session.tap("check.hidden")
        scene = self.saved()
        self.assertEqual([one.get("hidden") for one in [*scene["objects"], scene["lights"][0]]], [True] * 3)
        self.undo_step("hide 3 entries")
        self.assertEqual(self.saved(), self.before)

    def filter(self, text: str):
        """Only the knobs with this in their names are shown."""
        session = self.session
        session.tap("filter")
        session.wait(lambda: session.types, "the filter")
        session.key("ctrl+a")
        session.type(text)

    def show_knob(self, knob: str):
        """By the filter: before it the knob has a place far below the window."""
        self.filter(knob)
        places, bottom = self.session.places, self.size[1]
        self.session.wait(lambda: places.get("knob." + knob, (0, bottom))[1] < bottom, knob + " on the screen")
        self.session.read_all()

    def choose(self, knob: str) -> str:
        """By the entry "auto" of its menu: the message."""
        session = self.session
        self.show_knob(knob)
        since = session.said()
        session.tap("knob." + knob)
        session.tap(f"option.{knob}.auto")
        return session.wait_for_line(r"auto (.*)", since)[1]

    def test_5_auto_measures_sets_and_saves_a_method_by_its_name_and_is_a_step(self):
        said = self.choose("lights.method")
        method = re.fullmatch(r"lights\.method: (\w+) is the fastest.*; .* \(FLIP .*, .* ms at \d+×\d+\)", said)
        self.assertIsNotNone(method, said)
        self.assertEqual(self.saved().get("knobs", {}).get("lights.method", "clustered"), method[1])

    def test_9_it_ends_with_nothing_to_say(self):
        self.saved()
        self.leave()


if __name__ == "__main__":
    unittest.main()
