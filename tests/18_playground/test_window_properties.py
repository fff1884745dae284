#!/usr/bin/env python3
"""Properties of several entries at once, and methods that the program chooses, by real clicks and keys. Under Xvfb,
validated."""
import json
import re
import shutil
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "common"))

from window_session import BUILD, ROOT, Session, XServer  # noqa: E402

WIDTH, HEIGHT = 720, 700
SCENE = {"camera": {"position": [0, 0.8, 4], "target": [0, 0, 0], "fov_deg": 40}, "ambient": [0.25, 0.25, 0.3],
         "lights": [{"type": "point", "position": [0, 3, 0], "intensity": 2, "name": "first"},
                    {"type": "spot", "position": [1, 3, 0], "intensity": 3, "name": "second", "shadow": True}],
         "objects": [{"name": "one", "model": "models/cube.obj", "position": [-1, 0.25, 0]},
                     {"name": "two", "model": "models/cube.obj", "position": [1, 0.5, 0]}]}


class Properties(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp(prefix="lightwalk_editor_"))
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.scene = cls.folder / "built.json"
        cls.scene.write_text(json.dumps(SCENE))
        cls.server = XServer()
        cls.addClassCleanup(cls.server.close)
        cls.session = Session(cls.server, BUILD / "chapters" / "18_playground",
                              ["--validate", "on", "--size", f"{WIDTH}x{HEIGHT}", "--scene", str(cls.scene)], cls.folder,
                              LIGHTWALK_ROOT=str(ROOT), XDG_CACHE_HOME=str(cls.folder / "cache"))
        cls.addClassCleanup(cls.session.close)
        cls.before = cls.saved()

    @classmethod
    def saved(cls) -> dict:
        since = cls.session.said()
        cls.session.key("ctrl+s")
        cls.session.wait_for_line(r"saved .*", since)
        return json.loads(cls.scene.read_text())

    def rest(self):
        self.session.settled(0, 0, *self.session.geometry()[2:])

    def select(self, *names: str):
        """The last one is the active one."""
        self.session.click("entry." + names[0])
        self.session.xdotool("keydown", "ctrl")
        for name in names[1:]:
            self.session.click("entry." + name)
        self.session.xdotool("keyup", "ctrl")
        self.rest()

    def type_first(self, place: str, text: str):
        """Into the first number of a widget, by Ctrl and a click."""
        session = self.session
        session.wait(lambda: place in session.places, place)
        session.move(session.areas[place][0] + 8, session.places[place][1])
        session.xdotool("keydown", "ctrl")
        session.press()
        session.release()
        session.xdotool("keyup", "ctrl")
        session.park()
        self.rest()
        session.key("ctrl+a")
        session.xdotool("type", "--", text)
        self.rest()
        session.key("Return")
        self.rest()

    def undo(self, step: str):
        since = self.session.said()
        self.session.key("ctrl+z")
        self.session.wait_for_line("notice undone: " + step, since)
        self.rest()

    def test_1_a_number_that_is_typed_is_set_in_all_and_its_neighbours_stay(self):
        self.select("one", "two")
        self.type_first("numbers.position", "0.5")
        self.assertEqual([one["position"] for one in self.saved()["objects"]], [[0.5, 0.25, 0], [0.5, 0.5, 0]])
        self.undo("position of 2 entries")
        self.assertEqual(self.saved(), self.before)

    def test_2_a_dash_stands_for_numbers_that_differ_and_may_become_the_active_ones(self):
        session = self.session

        def x_field() -> bytes:
            left, top, _, bottom = session.areas["numbers.position"]
            return session.pixels(left, top, 40, bottom - top)

        self.select("two")
        alone = x_field()
        self.select("one", "two")
        self.assertTrue(x_field() != alone, "no dash")
        self.type_first("numbers.position", "1")  # which "two" has already
        self.assertTrue(x_field() == alone, "not the number that was typed")
        self.assertEqual([one["position"] for one in self.saved()["objects"]], [[1, 0.25, 0], [1, 0.5, 0]])
        self.undo("position of one")
        self.assertEqual(self.saved(), self.before)

    def test_3_a_drag_over_a_number_is_one_step_for_all_lights(self):
        self.select("first", "second")
        left, top, right, bottom = self.session.areas["number.intensity"]
        self.session.drag((left + 20, (top + bottom) // 2), (left + 60, (top + bottom) // 2))
        self.rest()
        lights = self.saved()["lights"]
        self.assertGreater(lights[0]["intensity"], 3)
        self.assertEqual(lights[0]["intensity"], lights[1]["intensity"])
        self.undo("intensity of 2 entries")
        self.assertEqual(self.saved(), self.before)

    def test_4_switches_and_types_of_several_are_set_by_one_click(self):
        session = self.session
        self.select("second", "first")
        session.click("check.shadow")  # of one only: then of both
        self.assertEqual([light.get("shadow") for light in self.saved()["lights"]], [True, True])
        session.click("choice.type")
        session.click("option.directional")
        self.assertEqual([light.get("type", "directional") for light in self.saved()["lights"]], ["directional"] * 2)
        self.undo("type of 2 entries")
        self.undo("shadow of first")
        self.select("one", "first", "two")  # objects and a light
        session.click("check.hidden")
        scene = self.saved()
        self.assertEqual([one.get("hidden") for one in [*scene["objects"], scene["lights"][0]]], [True] * 3)
        self.undo("hide 3 entries")
        self.assertEqual(self.saved(), self.before)

    def choose(self, knob: str) -> str:
        """By the entry "auto" of its menu: what it says."""
        session = self.session
        session.click("filter")
        session.key("ctrl+a")
        session.xdotool("type", knob)
        session.wait(lambda: "knob." + knob in session.places, knob)
        self.rest()
        since = session.said()
        session.click("knob." + knob)
        session.click(f"option.{knob}.auto")
        return session.wait_for_line(r"auto (.*)", since)[1]

    def test_5_auto_measures_sets_and_saves_a_method_by_its_name_and_is_a_step(self):
        said = self.choose("lights.method")
        method = re.fullmatch(r"lights\.method: (\w+) is the fastest.*; .* \(FLIP .*, .* ms at \d+×\d+\)", said)
        self.assertIsNotNone(method, said)
        self.rest()
        self.assertEqual(self.saved().get("knobs", {}).get("lights.method", "clustered"), method[1])

    def test_6_where_nothing_can_be_measured_it_says_why_and_changes_nothing(self):
        before = self.saved()
        self.assertRegex(self.choose("shadow.method"), r"shadow\.method: its reference, .*rays.*, exists in chapter 05 only")
        self.assertEqual(self.choose("picker.method"), "picker.method: its study measures wrong_picks, not the picture")
        self.rest()
        self.assertEqual(self.saved(), before)

    def facet_menu(self, facet: str, knob: str):
        """Of a knob in the properties, which the panel on the right has, too: there it is filtered away."""
        session = self.session
        session.click("filter")
        session.key("ctrl+a")
        session.xdotool("type", "no such knob")
        self.rest()
        session.places.pop("knob." + knob, None)
        session.click("entry." + facet)
        session.wait(lambda: "knob." + knob in session.places, knob)
        session.click("knob." + knob)

    def test_7_what_the_scene_has_once_offers_auto_in_its_own_fields_or_says_that_there_is_none(self):
        session = self.session
        self.facet_menu("fog", "fog.method")
        session.wait(lambda: "no auto.fog.method" in session.places, "why there is none")
        self.assertNotIn("option.fog.method.auto", session.places)
        session.key("Escape")
        self.facet_menu("sky", "atmosphere.method")
        since = session.said()
        session.click("option.atmosphere.method.auto")
        self.assertRegex(session.wait_for_line(r"auto (.*)", since)[1], r"atmosphere\.method: .*")

    def title(self) -> str:
        return self.session.xdotool("getwindowname", self.session.window).strip()

    def test_8_the_title_counts_what_is_measured_and_escape_ends_it(self):
        session, before = self.session, self.title()
        session.click("filter")
        session.key("ctrl+a")
        session.xdotool("type", "bloom.method")
        session.wait(lambda: "knob.bloom.method" in session.places, "bloom")
        self.rest()
        since = session.said()
        session.click("knob.bloom.method")
        session.tap("option.bloom.method.auto")
        session.wait(lambda: re.search(r"measuring bloom\.method: [1-9]\d* pictures", self.title()), "a count")
        session.key("Escape")
        session.wait_for_line(r"auto bloom\.method: not measured, cancelled by Esc", since)
        self.assertEqual(self.title(), before)

    def test_9_it_ends_with_nothing_to_say(self):
        self.session.click("entry.scene")
        self.session.key("ctrl+s")
        self.rest()
        self.session.key("Escape", "Escape", "Escape")
        self.assertEqual(self.session.end(), 0)
        self.assertEqual([line for line in self.session.errors if line], [])


if __name__ == "__main__":
    unittest.main()
