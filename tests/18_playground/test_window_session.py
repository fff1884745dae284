#!/usr/bin/env python3
"""A scene built from nothing by clicks and keys, saved, and opened by five other chapters. Under Xvfb, validated."""
import json
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "common"))

from window_case import PictureTest, read_png  # noqa: E402
from window_session import BUILD, ROOT, Session, XServer  # noqa: E402

WIDTH, HEIGHT = 720, 860
OTHERS = ("03_attenuation", "04_surface_maps", "05_shadow_maps", "06_deferred", "14_environment")
EMPTY = """{"camera": {"position": [0, 0.8, 4], "target": [0, 0, 0], "fov_deg": 40}, "ambient": [0.2, 0.2, 0.2],
"lights": [{"type": "directional", "direction": [-0.4, -0.8, -0.5], "intensity": 1.5, "shadow": true}]}"""


class Building(PictureTest):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp(prefix="lightwalk_editor_"))
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.scene = cls.folder / "built.json"
        cls.scene.write_text(EMPTY)
        cls.server = XServer()
        cls.addClassCleanup(cls.server.close)
        cls.session = Session(cls.server, BUILD / "chapters" / "18_playground",
                              ["--validate", "on", "--size", f"{WIDTH}x{HEIGHT}", "--scene", str(cls.scene)], cls.folder,
                              LIGHTWALK_ROOT=str(ROOT))
        cls.addClassCleanup(cls.session.close)

    def say(self, pattern, since):
        return self.session.wait_for_line(pattern, since)

    def add(self, name: str):
        """A model through the file browser, found by its filter."""
        since = self.session.said()
        self.session.click("tool.open")
        self.session.click("field.file filter")
        self.session.xdotool("type", name.split(".")[0] + ".")
        first_row = 185  # it stands there once the filter has been read
        self.session.wait(lambda: self.session.areas.get("file." + name, (0, first_row))[1] < first_row, "the filtered list")
        self.session.click("file." + name)
        self.say("added " + re.escape(name), since)
        self.session.settled(0, 0, WIDTH, HEIGHT)

    def saved(self) -> dict:
        since = self.session.said()
        self.session.key("ctrl+s")
        self.say(r"saved .*", since)
        return json.loads(self.scene.read_text())

    def test_a_scene_is_built_saved_and_opened_by_others(self):
        session, center = self.session, (WIDTH // 2, HEIGHT // 2)
        start = session.pixels(280, 0, WIDTH - 280, HEIGHT)

        # Two models; the second is dragged along x by the gizmo's arrow.
        self.add("cube.obj")
        self.add("teapot.obj")
        self.assert_other(session.pixels(280, 0, WIDTH - 280, HEIGHT), start)
        since = session.said()
        session.drag((center[0] + 60, center[1]), (center[0] + 150, center[1]))
        words = self.say(r"dragged (.*) m along x", since)[1]
        self.assertGreater(float(words), 0.2)

        # A click on the teapot's new place picks it; one on the background nothing.
        since = session.said()
        session.move(center[0] + 90, center[1])
        session.press()
        session.release()
        self.say("picked teapot", since)
        since = session.said()
        session.move(WIDTH - 20, 20)
        session.press()
        session.release()
        self.say("picked nothing", since)

        # A light, a texture, an effect.
        session.click("tool.lamp")
        session.click("entry.cube")
        session.click("section.Material")
        session.click("field.diffuse map")
        field = session.pixels(20, 460, 240, HEIGHT - 470)
        session.xdotool("type", "textures/wood_albedo.jpg")
        session.wait(lambda: session.pixels(20, 460, 240, HEIGHT - 470) != field, "the typed name")
        session.settled(0, 0, WIDTH, HEIGHT)
        plain = session.pixels(280, 0, WIDTH - 280, HEIGHT)
        session.key("Return")
        session.wait(lambda: session.pixels(280, 0, WIDTH - 280, HEIGHT) != plain, "the texture")
        session.settled(0, 0, WIDTH, HEIGHT)
        scene = self.saved()
        self.assertEqual([o["name"] for o in scene["objects"]], ["cube", "teapot"])
        self.assertEqual(scene["objects"][0]["material"]["maps"], {"diffuse": "textures/wood_albedo.jpg"})
        self.assertAlmostEqual(scene["objects"][1]["position"][0], float(words), places=3)
        self.assertEqual(len(scene["lights"]), 2)

        # Three steps back: the texture, the light, the drag; and forward again.
        for _ in range(3):
            since = session.said()
            session.key("ctrl+z")
            self.say(r"notice undone: .*", since)
        back = self.saved()
        self.assertEqual(len(back["lights"]), 1)
        self.assertNotIn("material", back["objects"][0])
        for _ in range(3):
            since = session.said()
            session.key("ctrl+y")
            self.say(r"notice done again: .*", since)
        self.assertEqual(self.saved(), scene)

        # What is not saved is asked for; then it ends, with nothing on its lips.
        session.key("Escape")
        session.key("Escape")
        self.assertEqual(session.end(), 0)
        self.assertEqual([line for line in session.errors if line], [])

        for chapter in OTHERS:
            if not (BUILD / "chapters" / chapter).exists():
                self.fail(f"{chapter} is not built")
            picture = self.folder / f"{chapter}.png"
            subprocess.run([BUILD / "chapters" / chapter, "--scene", self.scene, "--size", "160x120", "--screenshot",
                            picture], check=True, env={**session.environment})
            self.assertGreater(len(set(read_png(picture)[2])), 40, chapter)


if __name__ == "__main__":
    unittest.main()
