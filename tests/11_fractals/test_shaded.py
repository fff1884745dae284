"""Landscapes shaded in compute over a visibility buffer, beside those of fragment shaders."""
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "common"))
from pictures import ChapterPictures  # noqa: E402


class ShadedTest(ChapterPictures):
    chapter = "11_fractals"

    def test_a_visibility_buffer_draws_the_same_landscape(self):
        for scene in ("terrain_noon", "terrain_sunset"):
            for options in ((), ("--set", "terrain.show=normals")):
                far, mean = self.shaded_otherwise("terrain.shaded", scene, *options)
                self.assertLess(far, 0.001, (scene, options))
                self.assertLess(mean, 0.05, (scene, options))


if __name__ == "__main__":
    unittest.main()
