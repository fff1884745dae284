"""The conformance set: each property that a model file can state is drawn, named as left out, or refused."""
# Builds: 04_surface_maps
import os
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "common" / "course"))
import models  # noqa: E402
from tree import chapter_program  # noqa: E402


class Conformance(unittest.TestCase):
    def test_all(self):
        self.assertTrue(chapter_program(models.CHAPTER).exists(), "build it first")
        with tempfile.TemporaryDirectory() as folder:
            for result in models.verdicts([], pathlib.Path(folder)):
                with self.subTest(result["name"], says=result["says"]):
                    self.assertEqual(result["wrong"], "")


if __name__ == "__main__":
    os.environ.setdefault("GALLIVM_PERF", "nopt")
    unittest.main()
