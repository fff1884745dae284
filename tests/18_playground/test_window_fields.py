#!/usr/bin/env python3
"""Typing into the editor's fields, its menus and keys, its messages, and windows that become small in the middle of
something. Under Xvfb, validated."""
import json
import shutil
import unittest

from editor_case import ROOT, EditorTest

# Seen from far away: frames in which little is drawn take less time.
SCENE = {"camera": {"position": [0, 5, 25], "target": [0, 0, 0], "fov_deg": 40}, "ambient": [0.25, 0.25, 0.3],
         "lights": [{"type": "spot", "position": [0, 3, 0], "intensity": 2, "size_m": 0}],
         "objects": [{"name": "cube", "model": "models/cube.obj"},
                     {"name": "two\nlines \"quoted\"", "model": "models/sphere.obj", "position": [9, 0, 0]}]}
RAW, ODD = SCENE["objects"][1]["name"], 'two lines "quoted"'  # in the file, which keeps it, and as a line of the tree


class Fields(EditorTest):
    built = SCENE

    @classmethod
    def add_files(cls):
        shutil.copy(ROOT / "assets/models/plane.obj", bytes(cls.folder) + b"/na\xffme.obj")

    def test_1_an_environment_is_typed_and_refused_where_it_is_none(self):
        session = self.session
        session.tap("entry.environment")
        self.type_into("field.image", "environments/interior.hdr")
        self.assertEqual(self.saved()["environment"]["image"], "environments/interior.hdr")
        for path, why in (("environments/none.hdr", r"notice .*none\.hdr.*"),
                          ("models/cube.obj", r"notice key 'image' is .*expected an \.hdr or \.pfm file"),
                          ("planets_2k/earth.jpg", r"notice .*(no file|expected an \.hdr).*")):
            since = session.said()
            self.type_into("field.image", path)
            session.wait_for_line(why, since)
            self.assertEqual(self.saved()["environment"]["image"], "environments/interior.hdr")
        self.type_into("field.image", "")
        self.assertNotIn("environment", self.saved())

    def test_2a_what_is_typed_counts_once_and_what_is_refused_was_never_there(self):
        session, before = self.session, self.saved()
        session.tap("entry.cube")
        session.key("shift+h")
        self.undo()  # and it can be done again after all of them
        cases = {"entry.spot light": [("number.intensity", "1e39", "notice intensity: inf is out of range.*"),
                                      ("color.color", "0.9e9", "notice color: 9e\\+08 is out of range.*")],
                 "entry.cube": [("numbers.scale", "1e-9", "notice a scale of 1e-09 is not possible.*")],
                 "entry.camera": [("numbers.target", "1e12", r"notice target: 1e\+12 is out of range.*")]}
        for entry, typed in cases.items():
            session.tap(entry)
            for place, text, why in typed:
                with self.subTest(place=place, text=text):
                    since = session.said()
                    self.type_slowly(place, text, "Return")
                    session.wait_for_line(why, since)
                    self.assertEqual(self.saved(), before)
        session.tap("entry.cube")
        self.type_slowly("numbers.position", "12", "Escape")
        self.assertEqual(self.saved(), before)
        self.undo(key="ctrl+y", words="done again")  # hidden objects
        self.undo()
        for key in ("Return", "Tab"):
            with self.subTest(key=key):
                self.type_slowly("numbers.position", "1.25", key)
                if key == "Tab":
                    session.key("Return")  # in the field that it has led to, or still in this one
                    session.read_all()
                self.assertEqual(self.saved()["objects"][0]["position"], [1.25, 0, 0])
                self.undo()  # one step
                self.assertEqual(self.saved(), before)

    def test_2b_a_camera_that_would_look_along_its_up_keeps_the_place_it_had(self):
        session, before = self.session, self.saved()
        session.tap("entry.camera")
        session.wait(lambda: "numbers.position" in session.areas, "a position")
        left, top, right, bottom = session.areas["numbers.position"]
        z = left + (right - left) * 5 // 6  # the third of its numbers
        since = session.said()
        self.open_number(z, (top + bottom) // 2)
        self.type_letters("1e-99", "Return")
        session.wait_for_line("notice .*up.*", since)
        self.assertEqual(self.saved(), before)

    def test_2c_a_knob_never_leaves_its_range(self):
        session = self.session
        session.tap("entry.fog")
        self.type_number("knob.fog.density", "*1e39")  # 0 times infinity is no number; Dear ImGui 1.90 multiplies no more
        density = float(self.saved().get("knobs", {}).get("fog.density", 0))
        self.assertTrue(0 <= density < 1e9, density)

    def test_2d_escape_takes_back_what_the_mouse_drags_over_a_number_and_what_is_shown_short_is_whole(self):
        session = self.session
        session.tap("entry.cube")
        self.type_number("numbers.position", "-0.39036214")
        before = self.saved()
        self.assertEqual(before["objects"][0]["position"][0], -0.39036214)
        session.tap("entry.cube")
        session.key("Return", "Return")  # typed over and left as it is
        session.read_all()
        self.assertEqual(self.saved(), before)
        left, top, _, bottom = session.areas["numbers.position"]
        session.move(left + 8, (top + bottom) // 2)
        session.press()
        for x in (30, 60):
            session.move(left + x, (top + bottom) // 2)
        session.read_all()
        session.key("Escape")
        session.read_all()
        session.move(left + 90, (top + bottom) // 2)
        session.release()
        session.park()
        self.assertEqual(self.saved(), before)
        self.undo()  # the typed value; the entry is still selected
        self.assertEqual(self.saved()["objects"][0].get("position", [0, 0, 0]), [0, 0, 0])

    def rename(self, entry: str, name: str):
        """By Ctrl+R, or by a button. Of no entry: of the one that is selected."""
        if entry:
            self.session.tap("entry." + entry)
        if entry != ODD:
            self.session.key("ctrl+r")
        else:
            self.session.tap("tool.rename")
        self.session.replace(name)

    def names(self) -> list:
        return [one.get("name", "") for one in self.saved()["objects"]]

    def test_3_names_with_quotes_twice_the_same_empty_and_long(self):
        session, before = self.session, self.saved()
        self.assertEqual(self.names(), ["cube", RAW])
        top, bottom = session.areas["entry.cube"][1::2]
        self.assertEqual(session.areas["entry." + ODD][1::2], (bottom, 2 * bottom - top))  # a line like all others
        self.rename(ODD, 'a "b" \\ c')
        since = session.said()
        self.rename("cube", 'a "b" \\ c')
        session.wait_for_line("notice another object has that name; this is .*", since)
        self.assertEqual(self.names(), ['a "b" \\ c 2', 'a "b" \\ c'])
        long = "long" * 101  # a field of 400 bytes would cut it
        self.rename('a "b" \\ c 2', long)
        self.rename("", "")
        self.rename("cube.obj", "cube")
        self.assertEqual(self.names(), ["cube", 'a "b" \\ c'])
        self.rename("cube", "cube")  # an unchanged name is no step
        self.undo(5)
        self.assertEqual(self.saved(), before)

    def test_4_a_file_whose_name_is_not_utf_8_is_refused_since_no_scene_could_be_saved_with_it(self):
        session, before = self.session, self.saved()
        since = session.said()
        session.key("ctrl+o")
        session.tap("tool.here")
        session.tap("file.na\ufffdme.obj")
        session.wait_for_line("notice na\ufffdme.obj: the path is not UTF-8.*", since)
        self.assertEqual(self.saved(), before)

    def test_5_messages_stand_beside_the_tools_and_are_read(self):
        session = self.session
        since = session.said()
        session.tap("entry.scene")
        session.key("Delete")
        session.wait_for_line("notice camera, environment, sky, terrain, water, fog and effects belong to the scene.*", since)
        session.read_all()
        left = session.areas["notice"][0]
        for place, (_, top, right, _) in session.areas.items():
            if place.startswith(("tool.", "field.search", "entry.")) and top < 60:
                self.assertLess(right, left, place)

    def test_6_the_menu_of_an_entry_and_the_keyboard_alone(self):
        session = self.session
        session.tap("entry.cube", button=3)
        session.tap("menu.hide")
        self.assertTrue(self.saved()["objects"][0]["hidden"])
        session.key("shift+h")
        self.assertNotIn("hidden", self.saved()["objects"][0])
        session.tap("entry.cube", button=3)
        session.tap("menu.lock")
        since = session.said()
        session.key("Delete")
        session.wait_for_line("notice what is selected is locked", since)
        session.key("shift+l")
        session.key("Return")  # its first number
        session.replace("0.25")
        self.assertEqual(self.saved()["objects"][0]["position"], [0.25, 0, 0])
        self.undo()
        session.key("ctrl+f")
        session.wait(lambda: session.types, "the field")
        session.type("quoted")
        session.wait(lambda: session.areas["entry." + ODD][1] < session.areas["entry.effects"][3] + 8, "what was found")
        session.replace("")

    def test_7_a_question_is_answered_by_keys(self):
        session = self.session
        session.tap("entry.cube")
        session.key("shift+h")
        session.key("Escape", "Escape")
        session.wait(lambda: "answer.stay" in session.places, "the question")
        self.rest()
        before = session.pixels(0, 0, *session.geometry()[2:])
        session.key("ctrl+a", "Delete")  # no answers, and nothing is deleted
        self.rest()
        session.key("Escape")
        self.rest()
        self.assertNotEqual(session.pixels(0, 0, *session.geometry()[2:]), before)
        self.assertIsNone(session.process.poll())
        scene = self.saved()
        self.assertEqual((scene["objects"][0]["name"], scene["objects"][0]["hidden"]), ("cube", True))
        session.tap("entry.cube")
        session.key("shift+h")

    def test_8_save_as_asks_for_a_name_writes_another_file_and_asks_before_it_overwrites(self):
        self.saved()
        session, before = self.session, self.scene.read_text()
        (self.folder / "other.json").write_text("{}")
        files = sorted(self.folder.iterdir())
        since = session.said()
        self.ask_for_a_name("ctrl+shift+s")
        session.type("third")
        session.key("Escape")
        session.wait(lambda: not session.types, "the end of the field")
        session.read_all()
        self.assertIsNone(session.process.poll())
        self.ask_for_a_name("ctrl+shift+s")
        session.replace("other")
        session.wait(lambda: "answer.cancel" in session.places, "the question")
        session.read_all()
        session.key("Escape")
        session.read_all()
        self.assertEqual((self.folder / "other.json").read_text(), "{}")
        self.assertEqual((sorted(self.folder.iterdir()), self.scene.read_text()), (files, before))
        self.assertFalse([line for line in session.lines[since:] if line.startswith("saved")])
        self.ask_for_a_name()
        session.replace("other.json")
        session.read_all()
        session.key("Return")
        session.wait_for_line(r"saved .*/other\.json", since)
        self.assertEqual(json.loads((self.folder / "other.json").read_text()), json.loads(before))
        self.assertEqual(self.scene.read_text(), before)
        type(self).scene = self.folder / "other.json"
        self.saved()

    def test_9_the_window_becomes_small_while_something_is_dragged(self):
        session, before = self.session, self.saved()
        whole = session.geometry()[2:]
        session.tap("entry.cube")
        x, y = self.middle()
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
                    self.undo()
                self.assertEqual(self.saved(), before)

    def test_x_it_ends_with_nothing_to_say(self):
        self.saved()
        self.leave()


if __name__ == "__main__":
    unittest.main()
