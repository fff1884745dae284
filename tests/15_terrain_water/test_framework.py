"""The chapter that docs/framework.md shows (compositions/glass_valley.cpp) draws at the first try, and each of its parts is in
the picture."""
# Builds: glass_valley compare
import tempfile
import unittest
from pathlib import Path

from picture_drawing import BUILD, BUILT, HAS_SOLUTION, Drawing, sets, steps

SCENE = Path(__file__).resolve().parent / "compositions" / "glass_valley.json"
CHEAP = ("shadow.resolution=256", "atmosphere.table_scale=0.25")
# A setting that leaves a part out or changes it, and the difference that must show, in steps of 1/255.
PARTS = {"fog.method=none": 3, "bloom.method=none": 3, "antialias.method=none": 10, "post.tone=neutral": 10,
         "glass.method=sorted": 1, "atmosphere.sun_elevation_deg=8": 20, "terrain.start_x_km=35": 20}


@unittest.skipUnless(BUILT and HAS_SOLUTION, "needs the programs and the reference solutions")
class Framework(unittest.TestCase):
    def test_every_part_is_in_the_picture(self):
        with tempfile.TemporaryDirectory() as folder:
            drawing = Drawing(BUILD / "tests" / "glass_valley")
            self.addCleanup(drawing.close)

            def draw(*settings):
                picture = Path(folder, f"{'_'.join(settings) or 'whole'}.png")
                code, wrong, _ = drawing.draw(["--scene", SCENE, "--size", "160x90", *sets(*CHEAP, *settings)], picture)
                self.assertEqual((code, wrong), (0, ""), settings)
                return picture

            whole = draw()
            for setting, least in PARTS.items():
                with self.subTest(set=setting):
                    self.assertGreaterEqual(steps(whole, draw(setting)), least)
