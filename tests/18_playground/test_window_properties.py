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

    def test_2b_a_property_is_reset_in_all_and_an_eye_hides(self):
        self.select("one", "two")
        self.session.tap("reset.position")
        places = [one.get("position", [0, 0, 0]) for one in self.saved()["objects"]]
        self.assertEqual(places, [[0, 0, 0], [0, 0, 0]])
        self.undo_step("reset position of 2 entries")
        self.session.tap("eye.one")
        self.assertTrue(self.objects()["one"]["hidden"])
        self.session.tap("eye.one")
        self.assertEqual(self.saved(), self.before)

    def test_2d_a_thin_fog_is_set_with_the_mouse(self):
        session = self.session
        session.tap("entry.fog")
        session.read_all()
        left, top, right, bottom = session.areas["knob.fog.density"]
        session.drag((left + 10, (top + bottom) // 2), (left + (right - left) // 5, (top + bottom) // 2))
        density = float(self.saved()["knobs"]["fog.density"])
        self.assertTrue(1e-4 < density < 1e-2, density)  # of 0 to 10
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

    def test_6_where_nothing_can_be_measured_it_says_why_and_changes_nothing(self):
        before = self.saved()
        self.assertRegex(self.choose("shadow.method"), r"shadow\.method: its reference, .*rays.*, exists in chapter 05 only")
        self.assertEqual(self.choose("picker.method"), "picker.method: its study measures wrong_picks, not the picture")
        self.assertEqual(self.saved(), before)

    def facet_menu(self, facet: str, knob: str):
        """Of a knob in the properties, which the panel on the right has, too: there it is filtered away."""
        session = self.session
        self.filter("no such knob")
        session.read_all()
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
        self.show_knob("bloom.method")
        since = session.said()
        session.click("knob.bloom.method")
        session.wait(lambda: "option.bloom.method.auto" in session.places, "auto")
        session.move(*session.places["option.bloom.method.auto"])
        session.xdotool("click", "1")  # and does not wait for the window's next read after the measurement
        session.wait(lambda: re.search(r"measuring bloom\.method: [1-9]\d* pictures", self.title()), "a count")
        session.key("Escape")
        session.wait_for_line(r"auto bloom\.method: not measured, cancelled by Esc", since)
        self.assertEqual(self.title(), before)

    def test_9_it_ends_with_nothing_to_say(self):
        self.saved()
        self.leave()


if __name__ == "__main__":
    unittest.main()
