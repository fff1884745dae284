#!/usr/bin/env python3
"""What is typed into the editor's fields, its menus and keys, its messages, and windows that become small in the middle of
something. Under Xvfb, validated."""
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
         "lights": [{"type": "spot", "position": [0, 3, 0], "intensity": 2, "size_m": 0}],
         "objects": [{"name": "cube", "model": "models/cube.obj"},
                     {"name": "two\nlines \"quoted\"", "model": "models/sphere.obj", "position": [9, 0, 0]}]}
RAW, ODD = SCENE["objects"][1]["name"], 'two lines "quoted"'  # in the file, which keeps it, and as a line of the tree


class Fields(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp(prefix="lightwalk_editor_"))
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.scene = cls.folder / "built.json"
        cls.scene.write_text(json.dumps(SCENE))
        shutil.copy(ROOT / "assets/models/plane.obj", bytes(cls.folder) + b"/na\xffme.obj")
        cls.server = XServer()
        cls.addClassCleanup(cls.server.close)
        cls.session = Session(cls.server, BUILD / "chapters" / "18_playground",
                              ["--validate", "on", "--size", f"{WIDTH}x{HEIGHT}", "--scene", str(cls.scene)], cls.folder,
                              LIGHTWALK_ROOT=str(ROOT), XDG_CACHE_HOME=str(cls.folder / "cache"))
        cls.addClassCleanup(cls.session.close)

    def saved(self) -> dict:
        since = self.session.said()
        self.session.key("ctrl+s")
        self.session.wait_for_line(r"saved .*", since)
        return json.loads(self.scene.read_text())

    def rest(self):
        self.session.settled(0, 0, *self.session.geometry()[2:])

    def replace(self, text: str):
        """What stands in the field that has the keyboard, ended with Return."""
        self.rest()
        self.session.key("ctrl+a")
        if text:
            self.session.xdotool("type", "--", text)
        else:
            self.session.key("BackSpace")
        self.rest()
        self.session.key("Return")
        self.rest()

    def scroll_to(self, place: str):
        for _ in range(8):
            if self.session.areas[place][3] < HEIGHT - 10:
                return
            self.session.move(120, HEIGHT - 60)
            self.session.turn(-3)
            self.session.park()
            self.rest()
        self.fail(f"{place} does not come")

    def type_number(self, place: str, text: str):
        """Into the first number of a widget, by Ctrl and a click."""
        session = self.session
        session.wait(lambda: place in session.places, place)
        self.scroll_to(place)
        session.move(session.areas[place][0] + 8, session.places[place][1])
        session.xdotool("keydown", "ctrl")
        session.press()
        session.release()
        session.xdotool("keyup", "ctrl")
        session.park()
        self.replace(text)

    def test_1_an_environment_is_typed_and_refused_where_it_is_none(self):
        session = self.session
        session.click("entry.environment")
        session.click("field.image")
        self.replace("environments/interior.hdr")
        self.assertEqual(self.saved()["environment"]["image"], "environments/interior.hdr")
        for path, why in (("environments/none.hdr", r"notice .*none\.hdr.*"),
                          ("models/cube.obj", r"notice key 'image' is .*expected an \.hdr or \.pfm file"),
                          ("planets_2k/earth.jpg", r"notice .*(no file|expected an \.hdr).*")):
            since = session.said()
            session.click("field.image")
            self.replace(path)
            session.wait_for_line(why, since)
            self.assertEqual(self.saved()["environment"]["image"], "environments/interior.hdr")
        session.click("field.image")
        self.replace("")
        self.assertNotIn("environment", self.saved())

    def test_2_numbers_that_are_too_large_or_none_are_refused_with_a_line(self):
        session, before = self.session, self.saved()
        cases = {"entry.spot light": [("number.intensity", "1e39", r"notice intensity: inf is out of range, 0 to 1e\+06"),
                                      ("number.intensity", "-1", "notice intensity: -1 is out of range.*"),
                                      ("number.lamp size", "*1e39", "notice lamp size: (-?nan|inf) is out of range.*"),
                                      ("numbers.position", "1e39", "notice position: inf is out of range.*"),
                                      ("numbers.position", "1e30", r"notice position: 1e\+30 is out of range.*"),
                                      ("number.outer angle", "200", "notice outer angle: 200 is out of range.*")],
                 "entry.cube": [("numbers.position", "1e39", "notice position: inf is out of range.*"),
                                ("numbers.rotation", "1e30", r"notice rotation: 1e\+30 is out of range.*"),
                                ("numbers.scale", "0", "notice a scale of 0 is not possible.*")],
                 "entry.camera": [("number.field of view", "180", "notice field of view: 180 is out of range.*"),
                                  ("number.far", "0.0001", "notice key 'far_m' must be above near_m")],
                 "entry.scene": [("color.ambient", "1e39", "notice ambient: inf is out of range.*")]}
        for entry, typed in cases.items():
            session.click(entry)
            for place, text, why in typed:
                with self.subTest(place=place, text=text):
                    since = session.said()
                    self.type_number(place, text)
                    session.wait_for_line(why, since)
        self.assertEqual(self.saved(), before)
        session.click("entry.cube")
        self.type_number("numbers.position", "0.5")
        self.assertEqual(self.saved()["objects"][0]["position"], [0.5, 0, 0])
        session.key("ctrl+z")
        self.assertEqual(self.saved(), before)

    def rename(self, entry: str, name: str):
        """By Ctrl+R, or by a button. Of no entry: of the one that is selected."""
        if entry:
            self.session.click("entry." + entry)
        if entry != ODD:
            self.session.key("ctrl+r")
        else:
            self.session.click("tool.rename")
        self.session.wait(lambda: "field.rename" in self.session.places, "a field for the name")
        self.replace(name)

    def names(self) -> list:
        return [one.get("name", "") for one in self.saved()["objects"]]

    def test_3_names_with_quotes_twice_the_same_empty_and_long(self):
        session, before = self.session, self.saved()
        self.assertEqual(self.names(), ["cube", RAW])
        top, bottom = session.areas["entry.cube"][1::2]
        self.assertEqual(session.areas["entry." + ODD][1::2], (bottom, 2 * bottom - top))  # a line like all others
        self.rename(ODD, 'a "b" \\ c')
        self.assertEqual(self.names(), ["cube", 'a "b" \\ c'])
        since = session.said()
        self.rename("cube", 'a "b" \\ c')
        session.wait_for_line("notice another object has that name; this is .*", since)
        self.assertEqual(self.names(), ['a "b" \\ c 2', 'a "b" \\ c'])
        long = "long" * 101  # a field of 400 bytes would cut it
        self.rename('a "b" \\ c 2', long)
        self.rename("", "")
        self.rename("cube.obj", "cube")
        self.assertEqual(self.names(), ["cube", 'a "b" \\ c'])
        self.rename("cube", "cube")  # what is called so already is no step
        for name in ("", long, 'a "b" \\ c 2', "cube"):
            session.key("ctrl+z")
            self.rest()
            self.assertEqual(self.names()[0], name)
        session.key("ctrl+z")
        self.rest()
        self.assertEqual(self.saved(), before)

    def test_4_a_file_whose_name_is_not_utf_8_is_refused_since_no_scene_could_be_saved_with_it(self):
        session, before = self.session, self.saved()
        since = session.said()
        session.key("ctrl+o")
        session.click("tool.here")
        session.click("file.na\ufffdme.obj")
        session.wait_for_line("notice na\ufffdme.obj: the path is not UTF-8.*", since)
        self.assertEqual(self.saved(), before)

    def test_5_messages_stand_beside_the_tools_and_are_read(self):
        session = self.session
        since = session.said()
        session.click("entry.scene")
        session.key("Delete")
        session.wait_for_line("notice camera, environment, sky, water and fog belong to the scene.*", since)
        self.rest()
        left = session.areas["notice"][0]
        for place, (_, top, right, _) in session.areas.items():
            if place.startswith(("tool.", "field.search", "entry.")) and top < 60:
                self.assertLess(right, left, place)

    def test_6_the_menu_of_an_entry_and_the_keyboard_alone(self):
        session = self.session
        session.click("entry.cube", button=3)
        session.click("menu.hide")
        self.assertTrue(self.saved()["objects"][0]["hidden"])
        session.key("shift+h")
        self.assertNotIn("hidden", self.saved()["objects"][0])
        session.click("entry.cube", button=3)
        session.click("menu.lock")
        since = session.said()
        session.key("Delete")
        session.wait_for_line("notice what is selected is locked", since)
        session.key("shift+l")
        session.key("Return")  # its first number
        self.replace("0.25")
        self.assertEqual(self.saved()["objects"][0]["position"], [0.25, 0, 0])
        session.key("ctrl+z")
        self.rest()
        session.key("ctrl+f")
        self.rest()
        session.xdotool("type", "quoted")
        session.wait(lambda: session.areas["entry." + ODD][1] < session.areas["entry.fog"][3] + 8, "what was found")
        session.key("ctrl+a")
        session.key("BackSpace")
        session.key("Return")
        self.rest()

    def test_7_a_question_is_answered_by_keys(self):
        session = self.session
        session.click("entry.cube")
        session.key("shift+h")
        self.rest()
        session.key("Escape", "Escape")
        session.wait(lambda: "answer.stay" in session.places, "the question")
        self.rest()
        before = session.pixels(0, 0, *session.geometry()[2:])
        session.key("Delete")  # no answer, and deletes nothing
        self.rest()
        session.key("Escape")
        self.rest()
        self.assertNotEqual(session.pixels(0, 0, *session.geometry()[2:]), before)
        self.assertIsNone(session.process.poll())
        scene = self.saved()
        self.assertEqual((scene["objects"][0]["name"], scene["objects"][0]["hidden"]), ("cube", True))
        session.click("entry.cube")
        session.key("shift+h")

    def test_8_save_as_writes_another_file_which_is_edited_from_then_on_and_asks_before_it_overwrites(self):
        self.saved()
        session, before = self.session, self.scene.read_text()
        (self.folder / "other.json").write_text("{}")
        session.click("entry.scene")
        session.click("field.save as")
        self.replace("other")
        since = session.said()
        session.key("ctrl+shift+s")
        session.wait(lambda: "answer.cancel" in session.places, "the question")
        self.rest()
        session.key("Escape")
        self.rest()
        self.assertEqual((self.folder / "other.json").read_text(), "{}")
        session.click("tool.save as")
        session.wait(lambda: "answer.overwrite" in session.places, "the question")
        self.rest()
        session.key("Return")
        session.wait_for_line(r"saved .*/other\.json", since)
        self.assertEqual(json.loads((self.folder / "other.json").read_text()), json.loads(before))
        self.assertEqual(self.scene.read_text(), before)
        type(self).scene = self.folder / "other.json"
        self.saved()

    def resize(self, width: int, height: int):
        self.session.xdotool("windowsize", "--sync", self.session.window, str(width), str(height))
        self.rest()

    def test_9_the_window_becomes_small_while_something_is_dragged(self):
        session, before = self.session, self.saved()
        whole = session.geometry()[2:]
        session.click("entry.cube")
        x, y = WIDTH // 2, HEIGHT // 2
        tree = session.places["entry." + ODD]
        number = (session.areas["numbers.scale"][0] + 8, session.places["numbers.scale"][1])
        for what, start in (("gizmo", (x + 60, y)), ("tree", tree), ("number", number)):
            with self.subTest(what=what):
                session.move(*start)
                session.press()
                session.move(start[0] + 6, start[1])
                session.move(start[0] + 15, start[1])
                self.resize(300, 200)
                session.move(150, 100)
                session.move(170, 110)
                session.release()
                session.park()
                self.assertEqual(session.geometry()[2:], (300, 200))
                self.resize(*whole)
                if what != "tree":  # there is nothing to drop it on
                    self.assertNotEqual(self.saved(), before)
                    since = session.said()
                    session.key("ctrl+z")
                    session.wait_for_line("notice undone: .*", since)
                self.assertEqual(self.saved(), before)

    def test_x_it_ends_with_nothing_to_say(self):
        self.session.key("ctrl+s")
        self.rest()
        self.session.key("Escape", "Escape", "Escape")
        self.assertEqual(self.session.end(), 0)
        self.assertEqual([line for line in self.session.errors if line], [])


if __name__ == "__main__":
    unittest.main()
