#!/usr/bin/env python3
"""Files of the editor in its window: what a crash has left, and thumbnails. Under Xvfb, validated."""
import json
import os
import re
import shutil
import sys
import tempfile
import time
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "common"))

from window_session import BUILD, ROOT, Session, XServer  # noqa: E402

SCENE = {"camera": {"position": [0, 0.8, 4], "target": [0, 0, 0], "fov_deg": 40},
         "objects": [{"name": "cube", "model": "models/cube.obj"}]}


class Files(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp(prefix="lightwalk_editor_"))
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.scene = cls.folder / "built.json"
        cls.scene.write_text(json.dumps(SCENE))
        # What the editor wrote by itself before it was killed: newer, with an object more.
        cls.left = cls.folder / "built.json.unsaved"
        ghost = {**SCENE, "objects": [*SCENE["objects"], {"name": "ghost", "model": "models/cube.obj", "position": [1, 0, 0]}]}
        cls.left.write_text(json.dumps(ghost))
        os.utime(cls.left, (time.time() + 5, time.time() + 5))
        cls.server = XServer()
        cls.addClassCleanup(cls.server.close)
        cls.session = Session(cls.server, BUILD / "chapters" / "18_playground",
                              ["--validate", "on", "--size", "720x700", "--scene", str(cls.scene)], cls.folder,
                              LIGHTWALK_ROOT=str(ROOT), XDG_CACHE_HOME=str(cls.folder / "cache"))
        cls.addClassCleanup(cls.session.close)

    def wait_for(self, pattern: str, since: int):
        return self.session.wait_for_line(pattern, since)

    def saved(self) -> dict:
        since = self.session.said()
        self.session.key("ctrl+s")
        self.wait_for(r"saved .*", since)
        return json.loads(self.scene.read_text())

    def test_1_what_a_crash_has_left_is_offered_and_restored(self):
        self.session.click("answer.restore")
        names = [one["name"] for one in self.saved()["objects"]]
        self.assertEqual(names, ["cube", "ghost"])
        self.assertFalse(self.left.exists())

    def test_2_files_have_thumbnails_which_are_kept(self):
        session = self.session
        session.click("tool.open")
        session.click("field.file filter")
        session.xdotool("type", "cube.")
        session.wait(lambda: "thumbnail.cube.obj" in session.places, "a thumbnail")
        kept = list((self.folder / "cache" / "lightwalk" / "thumbnails").glob("*.png"))
        self.assertTrue(kept and all(re.fullmatch(r"[0-9a-f]{16}\.png", one.name) for one in kept), kept)
        session.click("tool.open")
        self.saved()
        session.key("Escape")
        session.key("Escape")
        self.assertEqual(session.end(), 0)
        self.assertEqual([line for line in session.errors if line], [])


if __name__ == "__main__":
    unittest.main()
