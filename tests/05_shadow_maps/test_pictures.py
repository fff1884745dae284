"""Pictures of the scene on which chapter 05's window opens: its sky is one, wherever the camera turns."""
import json
import math
import pathlib
import sys
import unittest

from PIL import Image

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "common"))
from pictures import ROOT, ChapterPictures  # noqa: E402

SCENE = ROOT / "assets/scenes/colonnade_evening.json"
SIDES = 5  # pictures of 80 degrees each
BARE = (255, 0, 255)


class SkyTest(ChapterPictures):
    chapter = "05_shadow_maps"

    def test_no_turn_of_the_camera_shows_a_gap_above_the_horizon(self):
        scene, file, picture = json.loads(SCENE.read_text()), self.folder / "scene.json", self.folder / "picture.png"
        x, y, z = scene["camera"]["position"]
        for side in range(SIDES):
            turn, rise = 2 * math.pi * side / SIDES, math.tan(math.radians(8.5))  # from half a degree above the horizon on
            camera = scene["camera"] | {"fov_deg": 16, "target": [x + math.sin(turn), y + rise, z + math.cos(turn)]}
            file.write_text(json.dumps(scene | {"camera": camera, "background": [1, 0, 1]}))
            self.run_program("--scene", file, "--set", "shadow.method=none", "--size", "144x24", "--screenshot", picture)
            found = {color: count for count, color in Image.open(picture).convert("RGB").getcolors(144 * 24)}
            self.assertGreater(len(found), 100)
            self.assertNotIn(BARE, found, f"{found.get(BARE)} pixels, {360 * side / SIDES:.0f} degrees around")


if __name__ == "__main__":
    unittest.main()
