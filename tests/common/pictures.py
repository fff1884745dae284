"""Shared by the tests of chapters' pictures: tests/NN_name/test_pictures.py. LIGHTWALK_BUILD names the build folder where
it is not build/ in the tree.
"""
import json
import os
import subprocess
from pathlib import Path

from folder_case import FolderCase
from shots.golden import compare
from shots.rendering import Drawing
from tree import BUILD, ROOT

# sRGB codes as linear light.
LINEAR = [code / 255 / 12.92 if code <= 10 else ((code / 255 + 0.055) / 1.055) ** 2.4 for code in range(256)]


def to_code(linear: float) -> float:
    """An sRGB code of linear light, clamped and not rounded."""
    linear = min(max(linear, 0), 1)
    return 255 * (12.92 * linear if linear <= 0.0031308 else 1.055 * linear ** (1 / 2.4) - 0.055)


class ChapterPictures(FolderCase):
    """A test with a folder of its own that runs one chapter."""
    chapter = ""
    drawing = None

    @classmethod
    def tearDownClass(cls):
        if cls.drawing:
            cls.drawing.close()

    def setUp(self):
        self.program = BUILD / "chapters" / self.chapter
        if not (ROOT / "shaders" / self.chapter / "solution").exists():
            self.skipTest("a handout has no reference")
        if not self.program.exists() and "LIGHTWALK_BUILD" not in os.environ:
            self.skipTest(f"{self.program} is not built")

    def draw(self, scene: dict | str | Path, *options, size="160x90", name="picture", silent=True) -> Path:
        """A picture of a scene: JSON, the name of one of the course's, or a file."""
        file = self.folder / "scene.json" if isinstance(scene, dict) else ROOT / "assets/scenes" / f"{scene}.json" if isinstance(scene, str) else scene
        if isinstance(scene, dict):
            file.write_text(json.dumps(scene))
        picture = self.folder / f"{name}.png"
        self.run_program("--scene", file, *options, "--size", size, "--screenshot", picture, silent=silent)
        return picture

    def flip(self, expected: Path, actual: Path) -> float:
        return compare(expected, actual)["flip"]["mean"]

    def run_program(self, *options, silent=True, **environment):
        """Runs the chapter; exit code 0 is expected and, where `silent`, nothing on stderr. One process draws all pictures
        that need no environment of their own."""
        if options[-2:-1] == ("--screenshot",) and not environment:
            return self.draw_picture(options[:-2], options[-1], silent)
        done = subprocess.run([str(word) for word in (self.program, *options)], capture_output=True, text=True,
                              timeout=120, cwd=ROOT, env=os.environ | environment)
        self.assertEqual(done.returncode, 0, done.stderr)
        if silent:
            self.assertEqual(done.stderr, "")
        return done

    def draw_picture(self, options, picture, silent):
        cls = type(self)
        cls.drawing = cls.drawing or Drawing(self.chapter)
        code, wrong, said = cls.drawing.draw(options, Path(picture))
        self.assertEqual(code, 0, wrong)
        if silent:  # Settings that make pictures of a chapter faster, unrelated to the comparison: most of a small picture's time goes into one-time work before its first frame.
            self.assertEqual([line for line in said.splitlines() if not line.startswith("drawing: ")], [])
