"""Portraits shaded in compute over a visibility buffer, against fragment shaders."""
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "common"))
from pictures import ChapterPictures  # noqa: E402


class ShadedTest(ChapterPictures):
    chapter = "12_skin"

    def test_a_visibility_buffer_draws_the_same_portrait(self):
        for method in ("preintegrated", "gaussians_6"):
            far, mean = self.shaded_otherwise("skin.shaded", "portrait", "--method", method)
            self.assertLess(far, 0.001, method)
            self.assertLess(mean, 0.05, method)


if __name__ == "__main__":
    unittest.main()
