#!/usr/bin/env python3
"""Files of the editor in its window: autosaves after a crash, thumbnails, typed paths, dropped files.
Under Xvfb, validated."""
import json
import os
import re
import time
import unittest

from editor_case import ROOT, EditorTest

SCENE = {"camera": {"position": [0, 0.8, 4], "target": [0, 0, 0], "fov_deg": 40}, "ambient": [0.25, 0.25, 0.3],
         "lights": [{"type": "directional", "direction": [-0.4, -0.8, -0.5], "intensity": 1.5}],
         "objects": [{"name": "cube", "model": "models/cube.obj"}]}


def grid(side: int) -> str:
    """A square of quads as an OBJ file."""
    rows = range(side + 1)
    corners = "".join(f"v {x / side} 0 {y / side}\n" for y in rows for x in rows)
    first = [y * (side + 1) + x + 1 for y in range(side) for x in range(side)]
    return corners + "".join(f"f {a} {a + 1} {a + side + 2} {a + side + 1}\n" for a in first)


class Files(EditorTest):
    built, size, has_own_cache = SCENE, (720, 700), True  # the browser's files stand beside the panel

    @classmethod
    def add_files(cls):
        (cls.folder / "bad.obj").write_text("v 0 0 0\nf 1 2 3\n")
        (cls.folder / "one more.obj").write_text(grid(40))  # a name that is escaped where it is dropped
        (cls.folder / "slow.obj").write_text(grid(600))  # takes longer than a window goes on drawing after a key
        # The editor's autosave before it was killed: newer, with an object more.
        cls.left = cls.folder / "built.json.unsaved"
        ghost = {**SCENE, "objects": [*SCENE["objects"], {"name": "ghost", "model": "models/cube.obj", "position": [1, 0, 0],
                                                          "rotation_deg": [0, 30, 0], "scale": [0.5, 0.5, 0.5]}]}
        cls.left.write_text(json.dumps(ghost))
        os.utime(cls.left, (time.time() + 5, time.time() + 5))

    def wait_for(self, pattern: str, since: int):
        return self.session.wait_for_line(pattern, since)

    def test_1_what_a_crash_has_left_is_offered_and_restored(self):
        self.session.tap("answer.restore")
        names = [one["name"] for one in self.saved()["objects"]]
        self.assertEqual(names, ["cube", "ghost"])
        self.assertFalse(self.left.exists())

    def test_2_files_have_thumbnails_which_are_kept(self):
        session = self.session
        session.tap("tool.open")
        session.tap("field.file filter")
        session.type("cube.")
        session.wait(lambda: "thumbnail.cube.obj" in session.places, "a thumbnail")
        kept = list((self.folder / "cache" / "lightwalk" / "thumbnails").glob("*.png"))
        self.assertTrue(kept and all(re.fullmatch(r"[0-9a-f]{16}\.png", one.name) for one in kept), kept)
        session.tap("tool.open")

    def type_path(self, path: str):
        """Into the browser, replacing its text, without waiting for a frame in between; ended with Return."""
        self.session.tap("tool.open")
        self.session.tap("field.path")
        self.session.key("ctrl+a")
        self.session.type(path)
        self.session.key("Return")

    def names(self) -> list:
        return [one["name"] for one in self.saved()["objects"]]

    def test_4_a_path_that_is_typed_and_ended_with_return_is_added(self):
        since = self.session.said()
        self.type_path(str(ROOT / "assets/models/plane.obj"))
        self.wait_for(r"added plane\.obj", since)
        self.assertEqual(self.names(), ["cube", "ghost", "plane"])

    def picture(self) -> bytes:
        """Below the text over it."""
        return self.session.settled(self.left_px, 120, 440, 580)

    def assert_nearly(self, expected: bytes):
        """Where places are rounded: but for a few pixels."""
        def differ() -> int:
            return sum(abs(a - b) > 2 for a, b in zip(self.picture(), expected, strict=True))

        self.session.wait(lambda: differ() < 100, "nearly the picture as it was")

    def test_6_files_that_are_dropped_are_added_in_turn_but_for_one_that_is_bad(self):
        since = self.session.said()
        self.session.drop(self.folder / "bad.obj", ROOT / "assets/models/sphere.obj", self.folder / "one more.obj")
        self.wait_for(r"notice .*bad\.obj:2: .*", since)
        self.wait_for(r"added sphere\.obj", since)
        self.wait_for(r"added one more\.obj", since)
        self.assertEqual(self.names(), ["cube", "ghost", "plane", "sphere", "one more"])

    def parents(self) -> dict:
        return {name: one.get("parent") for name, one in self.objects().items()}

    def test_7_the_tree_by_the_mouse_dragged_onto_a_parent_ranges_toggles_and_groups(self):
        session, before = self.session, self.parents()
        session.tap("entry.sphere")
        picture = self.picture()
        session.drag(session.places["entry.sphere"], session.places["entry.ghost"])
        self.assertEqual(self.parents(), {**before, "sphere": "ghost"})
        self.assert_nearly(picture)  # it has kept its place, below a parent that is turned and half as large
        self.undo()
        session.tap("entry.plane")
        session.tap("entry.one more", held="shift")
        session.tap("entry.cube", held="shift")  # from where no Shift was held
        self.assert_grouped(["cube", "ghost", "plane"])
        session.tap("entry.cube")
        for name in ("ghost", "sphere", "ghost"):
            session.tap("entry." + name, held="ctrl")
        self.assert_grouped(["cube", "sphere"])
        self.assertEqual(self.parents(), before)

    def assert_grouped(self, chosen: list):
        """These are selected; nothing has changed in the end."""
        self.session.key("ctrl+g")
        self.assertEqual([name for name, parent in self.parents().items() if parent == "group"], chosen)
        self.undo()

    def test_90_what_a_crash_has_left_of_a_scene_that_is_opened_later_is_offered_too(self):
        self.saved()
        session, other = self.session, self.folder / "other.json"
        other.write_text(json.dumps({**SCENE, "objects": [{"name": "second", "model": "models/cube.obj"}]}))
        left = self.folder / "other.json.unsaved"
        left.write_text(other.read_text().replace("second", "rescued"))
        os.utime(left, (time.time() + 5, time.time() + 5))
        self.type_path(str(other))
        session.wait(lambda: "entry.second" in session.places, "the scene")
        session.read_all()
        session.key("Return")
        session.read_all()
        type(self).scene = other
        self.assertEqual(list(self.objects()), ["rescued"])

    def find_file(self, name: str):
        """By the field that searches: its thumbnail is there."""
        session = self.session
        session.tap("field.file filter")
        session.type(name.split(".")[0] + ".")
        session.wait(lambda: "thumbnail." + name in session.places, "a thumbnail")
        session.read_all()

    def test_92_a_map_is_chosen_from_pictures_and_an_escape_chooses_none(self):
        session = self.session
        session.tap("entry.rescued")
        session.tap("section.Material")
        for chosen in ({}, {"diffuse": "textures/checker.png"}):
            self.scroll_to("pick.diffuse map")
            session.tap("pick.diffuse map")
            self.find_file("checker.png")
            if chosen:
                session.tap("file.checker.png")
            else:
                session.key("Escape", "Escape")  # the field's, the list's
            session.read_all()
            self.assertEqual(self.saved()["objects"][0].get("material", {}).get("maps", {}), chosen)

    def test_93_a_model_is_dragged_into_the_picture(self):
        session, since = self.session, self.session.said()
        session.tap("tool.open")
        session.tap("tool.models")
        self.find_file("sphere.obj")
        session.drag(session.places["file.sphere.obj"], self.in_window(SCENE["camera"], [0.2, 0.1, 0.5]))
        self.wait_for(r"added sphere\.obj", since)
        x, y, z = self.saved()["objects"][-1]["position"]
        self.assertLess(abs(x - 0.2) + abs(y - 0.1), 0.03)  # before the cube's side
        self.assertGreater(z, 0.7)
        session.tap("tool.open")

    def test_94_a_texture_is_dragged_onto_an_object_and_an_environment_into_the_picture(self):
        session = self.session
        sphere = self.in_window(SCENE["camera"], self.saved()["objects"][-1]["position"])
        for folder, file in (("images", "checker.png"), ("environments", "sunset_1k.hdr")):
            session.tap("tool.open")
            session.tap("tool." + folder)
            self.find_file(file)
            session.drag(session.places["file." + file], sphere)
            session.read_all()
            session.tap("tool.open")
        scene = self.saved()
        self.assertEqual([one.get("material", {}).get("maps") for one in scene["objects"]],
                         [{"diffuse": "textures/checker.png"}] * 2)  # the first one has it already
        self.assertEqual(scene["environment"]["image"], "environments/sunset_1k.hdr")

    def test_9_what_took_long_is_in_the_tree_though_nobody_moves_the_mouse(self):
        since = self.session.said()
        self.type_path(str(self.folder / "slow.obj"))
        self.wait_for(r"added slow\.obj", since)
        self.session.wait(lambda: "entry.slow" in self.session.areas, "its line in the tree")
        self.wait_for(r"loading took [\d.]+ s: \d+ frames, .*", since)
        self.assertEqual(self.names()[-1], "slow")

    def test_x_it_ends_with_nothing_to_say(self):
        self.leave()


if __name__ == "__main__":
    unittest.main()
