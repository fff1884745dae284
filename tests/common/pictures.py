"""What the tests of chapters' pictures share: tests/NN_name/test_pictures.py. LIGHTWALK_BUILD names the build folder where
it is not build/ in the tree.
"""
import os
import pathlib
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(os.environ.get("LIGHTWALK_BUILD", ROOT / "build"))
# sRGB codes as linear light.
LINEAR = [code / 255 / 12.92 if code <= 10 else ((code / 255 + 0.055) / 1.055) ** 2.4 for code in range(256)]


def to_code(linear: float) -> float:
    """An sRGB code of linear light, clamped and not rounded."""
    linear = min(max(linear, 0), 1)
    return 255 * (12.92 * linear if linear <= 0.0031308 else 1.055 * linear ** (1 / 2.4) - 0.055)


class ChapterPictures(unittest.TestCase):
    """A test with a folder of its own that runs one chapter."""
    chapter = ""

    def setUp(self):
        self.program = BUILD / "chapters" / self.chapter
        if not (ROOT / "shaders" / self.chapter / "solution").exists():
            self.skipTest("a handout has no reference")
        if not self.program.exists() and "LIGHTWALK_BUILD" not in os.environ:
            self.skipTest(f"{self.program} is not built")
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def run_program(self, *options, silent=True, **environment):
        """Runs the chapter; exit code 0 is expected and, where `silent`, nothing on stderr."""
        done = subprocess.run([str(word) for word in (self.program, *options)], capture_output=True, text=True,
                              timeout=120, cwd=ROOT, env=os.environ | environment)
        self.assertEqual(done.returncode, 0, done.stderr)
        if silent:
            self.assertEqual(done.stderr, "")
        return done
