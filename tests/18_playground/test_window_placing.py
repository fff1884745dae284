#!/usr/bin/env python3
"""Models and lights land where the pointer shows, the sun is turned, and a German keyboard undoes with Ctrl+Z. Under Xvfb,
validated."""
import math
import re
import subprocess
import unittest

from editor_case import EditorTest, ROOT

CAMERA = {"position": [0, 3, 6], "target": [0, 0, 0], "fov_deg": 40}
# A floor whose surface is at 0.25 m, and a sun.
SCENE = {"camera": CAMERA, "ambient": [0.3, 0.3, 0.3],
         "lights": [{"type": "directional", "direction": [-0.4, -0.8, -0.5], "name": "sun"}],
         "objects": [{"name": "floor", "model": "models/cube.obj", "position": [0, 0.125, 0], "scale": [8, 0.25, 8]}]}


class Placing(EditorTest):
    built = SCENE

    @classmethod
    def prepare(cls, server):
        subprocess.run(["setxkbmap", "-display", server.display, "de"], check=True)

    def point_at(self, point: list):
        self.session.move(*self.in_window(CAMERA, point))

    def assert_near(self, place: list, expected: list, within: float = 0.03):
        self.assertLess(math.dist(place, expected), within, (place, expected))

    def test_1_a_lamp_lands_above_what_the_pointer_shows(self):
        self.point_at([1, 0.25, 0.5])
        self.session.key("shift+2")
        self.session.read_all()
        self.session.park()
        x, y, z = self.saved()["lights"][1]["position"]
        self.assert_near([x, 0.25, z], [1, 0.25, 0.5])
        self.assertTrue(0.3 < y < 1.5, y)

    def test_2_a_german_keyboard_undoes_with_ctrl_z(self):
        for key in ("ctrl+y", "ctrl+shift+z"):
            self.undo()
            self.assertEqual(len(self.saved()["lights"]), 1)
            self.undo(key=key, words="done again")
            self.assertEqual(len(self.saved()["lights"]), 2)
        self.undo()

    def test_3_a_file_that_is_dropped_stands_where_it_was_dropped(self):
        since = self.session.said()
        self.session.drop(ROOT / "assets/models/sphere.obj")
        self.session.wait_for_line(r"added sphere\.obj", since)
        self.rest()
        self.session.park()
        sphere = self.objects()["sphere"]
        self.assertEqual(sphere.get("scale", [1, 1, 1]), [1, 1, 1])
        x, y, z = sphere["position"]
        width, height = self.session.geometry()[2:]  # drops come to the middle of the window
        self.assertLess(math.dist(self.in_window(CAMERA, [x, 0.25, z]), (width / 2, height / 2)), 4)
        self.assertGreater(y, 0.25)
        self.undo()

    def test_4_the_handle_of_the_sun_turns_it_and_does_not_move_it(self):
        session, before = self.session, self.saved()
        session.tap("entry.sun")
        session.read_all()
        x, y = self.in_window(CAMERA, [0, 0, 0])
        radius = round(1.15 * 90)  # of the ring about the direction of view
        since = session.said()
        session.drag((x + radius, y), (x, y + radius))
        session.wait_for_line(r"dragged -?90\.0°.*", since)
        sun = self.saved()["lights"][0]
        self.assertEqual(sun.get("position"), before["lights"][0].get("position"))
        forward = [-p / math.dist(CAMERA["position"], (0, 0, 0)) for p in CAMERA["position"]]
        length = math.dist(SCENE["lights"][0]["direction"], (0, 0, 0))

        def along(direction):
            return sum(a * b for a, b in zip(direction, forward))

        self.assertAlmostEqual(along(sun["direction"]), along(SCENE["lights"][0]["direction"]) / length, places=3)
        self.assertGreater(math.dist(sun["direction"], before["lights"][0]["direction"]), 0.3)
        self.undo()
        self.assertEqual(self.saved(), before)

    def test_5_the_line_below_the_picture_says_what_a_drag_does(self):
        session = self.session
        session.tap("entry.floor")
        x, y = self.in_window(CAMERA, [0, 0.125, 0])
        session.move(x + 60, y)
        session.wait(lambda: "status.drag: move along x" in session.areas, "what a drag would do")
        session.press()
        session.move(x + 90, y)
        session.wait(lambda: any(re.fullmatch(r"status\.0\.\d+ m along x.*", one) for one in session.areas), "how far it goes")
        session.release()
        session.park()
        self.undo()

    def taken_view(self) -> dict:
        self.session.tap("entry.camera")
        self.session.tap("tool.take this view")
        return self.saved()["camera"]

    def test_6_f_brings_what_is_selected_into_the_middle_and_home_the_scenes_own_view(self):
        session, before = self.session, self.saved()
        self.point_at([1, 0.25, 0.5])
        session.key("shift+2")
        session.read_all()
        session.key("f")
        session.park()
        camera = self.taken_view()
        lamp = self.saved()["lights"][1]["position"]
        self.assertLess(math.dist(self.in_window(camera, lamp), self.middle()), 2)
        self.assertGreater(math.dist(camera["position"], CAMERA["position"]), 0.5)
        self.undo(2)
        x, y = self.middle()
        session.drag((x, y + 100), (x + 80, y + 60))
        session.key("Home")
        session.read_all()
        self.assertEqual(self.taken_view(), before["camera"])

    def test_x_it_ends_with_nothing_to_say(self):
        self.saved()
        self.leave()


if __name__ == "__main__":
    unittest.main()
