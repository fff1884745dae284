"""A driver that crashes with a shader with correct numbers: its own fault or the student's purpose, so the grader is told,
and there is no mark until then."""

import contextlib
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from graded_class import right, why_not
from grading.grade import table, write_files
from grading.judge import Judge
from grading.judge_picture import DriverEnded, Pictures, ToolFailed
from grading.sandbox import Done
from tree import ROOT

EXERCISE = "04.parallax_occlusion"


@unittest.skipIf(why_not(), why_not())
class Crash(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)

    def drawn(self, codes, name: str) -> str | None:
        """Pictures' verdict on a source for which drawing one shot after the other ended so."""
        pictures = Pictures.__new__(Pictures)
        pictures.wanted, pictures.link = {EXERCISE: "04_surface_maps"}, lambda *_: ""
        shots = [(shot, self.folder / f"{shot}.png") for shot in ("relief", "wall")]
        pictures.references, pictures.drawing_mounts = lambda _: shots[:len(codes)], lambda *_: None
        ends = iter(codes)
        running = mock.Mock(finish=lambda: Done(next(ends), "", False, False))
        judge = mock.Mock(started=lambda *_, **__: contextlib.nullcontext(running))
        with tempfile.TemporaryDirectory(dir=self.folder) as folder:
            return pictures.wrong(EXERCISE, Path(folder) / name, judge)

    def test_which_end_is_the_drivers(self):
        with self.assertRaisesRegex(DriverEnded, "relief, wall"):
            self.drawn((139, 139), "a.glsl")
        for code, name in ((1, "a.glsl"), (134, "a.glsl"), (139, "a.cpp")):  # C++ of a student's crashes by itself
            with self.assertRaisesRegex(ToolFailed, f"the program that draws it ended with {code}"):
                self.drawn((code,), name)
        # One picture without a crash is enough to judge by.
        with self.assertRaisesRegex(ToolFailed, "ended with 1"):
            self.drawn((139, 1), "a.glsl")
        self.assertIsNone(self.drawn((), "a.glsl"))

    def test_the_students_object_is_linked_last(self):
        """Its toggles have no references. Before those of the chapter they would be used, and the chapter's other exercises
        would be starters in its picture."""
        place = "chapters/17_planets/exercise/camera_relative.cpp"
        pictures = Pictures.__new__(Pictures)
        pictures.wanted = {"17.camera_relative": "17_planets"}
        pictures.links = {"17_planets": ["c++", "main.o", f"CMakeFiles/e.dir/./{place}.o", "-o", "program", "libchapter.a"]}
        judge = mock.Mock(paths={"17.camera_relative": ROOT / place})
        judge.started.return_value = contextlib.nullcontext(mock.Mock(finish=lambda: Done(0, "", False, False)))
        pictures.link("17.camera_relative", self.folder, judge)
        words = judge.started.call_args.args[0][-1].split()
        self.assertEqual(words[-6:], ["c++", "main.o", "-o", "/grade/program", "libchapter.a", "/grade/student.o"])

    def test_there_is_no_mark_and_it_is_said(self):
        judge = Judge.__new__(Judge)
        judge.paths, judge.seed = {EXERCISE: Path("04_surface_maps/exercise/a.glsl")}, 0
        judge.numbers = lambda *_: {"ok": True, "passed": 7, "failed": 0}
        judge.pictures = mock.Mock(wrong=mock.Mock(side_effect=DriverEnded("relief")))
        found = judge.judge(EXERCISE, b"")
        self.assertEqual((found["ok"], found["state"], found["passed"]), (False, "undecided", 7))
        result = {"exercise": EXERCISE, "chapter": "04_surface_maps", **found}
        grades = [{"student": "ann", "error": None, "right": 0, "of": 1, "alike": [], "results": [result]}]
        self.assertRegex("\n".join(table(grades, ["04_surface_maps"])),
                         r"look at: ann, 04\.parallax_occlusion, which has no mark yet: its numbers are right, .* relief")
        write_files(self.folder, grades, {EXERCISE: "04_surface_maps"})
        self.assertIn('"ann","0","1","?"', (self.folder / "grades.csv").read_text())

    def test_it_is_said_of_a_verdict_that_was_kept(self):
        with Judge({"02.lambert": "02_lambert_phong"}, 2, False) as judge:
            judge.verdicts = self.folder
            judge.pictures = mock.Mock(wrong=mock.Mock(side_effect=DriverEnded("bunny")))
            states = {judge.verdict("02.lambert", right("02.lambert").encode() + b"// crash")["state"] for _ in range(2)}
        self.assertEqual(states, {"undecided"})


if __name__ == "__main__":
    unittest.main()
