"""A driver that crashes with a right shader is no mistake of the student's, and is not kept quiet."""

import contextlib
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import grading  # noqa: F401  which makes the course's modules importable
from grade import table
from judge import Judge
from judge_picture import DriverEnded, Pictures
from sandbox import Done

EXERCISE = "04.parallax_occlusion"


class Crash(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)

    def drawn(self, code: int, name: str) -> str | None:
        """What Pictures says of a source whose drawing ended so."""
        pictures = Pictures.__new__(Pictures)
        pictures.wanted, pictures.link = {EXERCISE: "04_surface_maps"}, lambda *_: ""
        pictures.reference, pictures.drawing_mounts = lambda _: ("relief", self.folder / "relief.png"), lambda *_: None
        running = mock.Mock(finish=lambda: Done(code, "", False, False))
        judge = mock.Mock(started=lambda *_: contextlib.nullcontext(running))
        with tempfile.TemporaryDirectory(dir=self.folder) as folder:
            return pictures.wrong(EXERCISE, Path(folder) / name, judge)

    def test_which_end_is_the_drivers(self):
        with self.assertRaisesRegex(DriverEnded, "relief"):
            self.drawn(139, "a.glsl")
        self.assertRegex(self.drawn(1, "a.glsl"), "the picture of relief is not: it ended with 1")
        self.assertRegex(self.drawn(134, "a.glsl"), "it ended with 134")
        self.assertRegex(self.drawn(139, "a.cpp"), "it ended with 139")  # C++ of a student's crashes by itself

    def test_the_verdict_is_that_of_the_numbers_and_says_so(self):
        judge = Judge.__new__(Judge)
        judge.paths, judge.seed = {EXERCISE: Path("a.glsl")}, 0
        judge.numbers = lambda *_: {"ok": True, "passed": 7, "failed": 0}
        judge.pictures = mock.Mock(wrong=mock.Mock(side_effect=DriverEnded("relief")))
        found = judge.judge(EXERCISE, b"")
        self.assertEqual((found["ok"], found["passed"]), (True, 7))
        result = {"exercise": EXERCISE, "chapter": "04_surface_maps", "state": "judged", **found}
        lines = table([{"student": "ann", "error": None, "right": 1, "of": 1, "alike": [], "results": [result]}],
                      ["04_surface_maps"])
        self.assertRegex("\n".join(lines), r"look at: ann, 04\.parallax_occlusion: judged by its numbers alone: .* relief")


if __name__ == "__main__":
    unittest.main()
