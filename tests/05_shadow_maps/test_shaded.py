"""Pictures of chapter 05 shaded in compute over a visibility buffer, beside those of fragment shaders."""
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "common"))
from pictures import ChapterPictures  # noqa: E402


class ShadedTest(ChapterPictures):
    chapter = "05_shadow_maps"

    def test_a_visibility_buffer_draws_the_same_picture(self):
        # At the edges of triangles a fragment shader takes differences across the edge, and so another mip level.
        for scene, options in (("colonnade", ()), ("stage", ()), ("meadow", ())):
            far, mean = self.shaded_otherwise("objects.shaded", scene, *options)
            self.assertLess(far, 0.004, scene)
            self.assertLess(mean, 0.08, scene)


if __name__ == "__main__":
    unittest.main()
