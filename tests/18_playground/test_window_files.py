"""Files of the editor in its window: autosaves after a crash, thumbnails, typed paths. Under Xvfb, validated."""
import json
import os
import time

from editor_case import ROOT, EditorTest

SCENE = {"camera": {"position": [0, 0.8, 4], "target": [0, 0, 0], "fov_deg": 40}, "ambient": [0.25, 0.25, 0.3],
         "lights": [{"type": "directional", "direction": [-0.4, -0.8, -0.5], "intensity": 1.5}],
         "objects": [{"name": "cube", "model": "models/cube.obj"}]}


class Files(EditorTest):
    built, size, has_own_cache = SCENE, (720, 700), True  # the browser's files stand beside the panel

    @classmethod
    def add_files(cls):
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

    def find_file(self, name: str):
        """By the field that searches: its thumbnail is there."""
        session = self.session
        session.tap("field.file filter")
        session.type(name.split(".")[0] + ".")
        session.wait(lambda: "thumbnail." + name in session.places, "a thumbnail")
        session.read_all()

    def test_93_a_model_is_dragged_into_the_picture(self):
        session, since = self.session, self.session.said()
        session.tap("tool.open")
        session.tap("tool.models")
        self.find_file("sphere.obj")
        # On the cube's side, above the plane that another test has added.
        session.drag(session.places["file.sphere.obj"], self.in_window(SCENE["camera"], [0.2, 0.3, 0.5]))
        self.wait_for(r"added sphere\.obj", since)
        x, y, z = self.saved()["objects"][-1]["position"]
        self.assertLess(abs(x - 0.2) + abs(y - 0.3), 0.03)  # before the cube's side
        self.assertGreater(z, 0.7)
        session.tap("tool.open")

    def test_x_it_ends_with_nothing_to_say(self):
        self.leave()
