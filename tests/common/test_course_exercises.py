"""Tests of ./course where exercises are checked, handed out and graded."""
# Builds: nothing

import json
import shutil
import unittest
from unittest import mock

from small_course import Course

from check import check
from shots.rendering import Crashed


class StillOpen(unittest.TestCase):
    def test_what_was_right_is_not_checked_again(self):
        with mock.patch.object(check.Verdicts, "is_solved", lambda _, name, path: name != "01.triangulate"), \
                mock.patch.object(check, "build") as build, mock.patch.object(check, "numbers_are_right", return_value=False) as asked:
            self.assertEqual(check.still_open("02_lambert_phong", "02.lambert"), ["01.triangulate"])
            build.assert_called_once_with(["check_01_obj"])
            asked.assert_called_once_with("01_obj", "01.triangulate")


class Exercises(Course):
    def test_check_says_what_is_wrong(self):
        self.put("chapters/02_lambert/exercise/one.cpp", "right")
        self.put("starter_is_right")
        self.accept()
        printed = self.course("check", "01", code=1)
        self.assertIn("open  01.one  0 of 3 checks  chapters/01_obj/exercise/one.cpp\n"
                      "      one(0) gave 1, expected 0", printed)
        self.assertNotIn("think", printed)
        self.assertIn("hint: think", self.course("check", "01.one", "--hint", code=1))
        self.assertIn("1 of 2 exercises are solved; next: 01.one", self.course("check", code=1))
        lines = self.course("check", "--json", code=1).splitlines()
        self.assertEqual([json.loads(line)["ok"] for line in lines if line[0] == "{"], [False, True])
        self.assertIn("02_lambert               [#] 1 of 1", self.course("check", "--progress", code=1))

    def test_the_picture_comes_last(self):
        self.put("chapters/02_lambert/exercise/one.cpp", "right")
        self.accept()
        self.assertIn("the numbers are right, the picture of bunny is not", self.course("check", "02", code=1))
        self.put("starter_is_right")
        self.assertIn("ok    02.one", self.course("check", "02"))

    def test_a_picture_is_compared_with_the_reference_drawn_here(self):
        self.put("chapters/02_lambert/exercise/one.cpp", "right")
        self.put("starter_is_right")
        self.accept()
        self.put("drift", "as this processor draws it")  # unlike the golden, but like the reference
        self.assertIn("ok    02.one", self.course("check", "02"))

    def test_in_a_handout_the_picture_waits_for_what_else_it_shows(self):
        self.put("starter_is_right")
        self.accept()
        folder = self.outside / "waiting"
        self.course("handout", str(folder))
        self.addCleanup(shutil.rmtree, folder)
        (folder / "chapters/02_lambert/exercise/one.cpp").write_text("right")
        check = [folder / "course", "check", "02"]
        self.assertIn("compared once the numbers of 01.one are right", self.run_program(check))
        (folder / "chapters/01_obj/exercise/one.cpp").write_text("right")
        self.assertNotIn("compared once", self.run_program(check))
        (folder / "starter_is_right").unlink()
        self.assertIn("the picture of bunny is not: 3 pixels differ", self.run_program(check, code=1))

    def test_exercises_come_in_the_lessons_order(self):
        self.put("chapters/01_obj/exercise/and.cpp", "right")
        listed = (self.root / "tests/starters.txt").read_text()
        self.put("tests/starters.txt", f"{listed}{0:016x} chapters/01_obj/exercise/and.cpp\n")
        self.put("docs/01_obj.md", "# One\n### 01.one (easy)\n### 01.and (hard)\n")
        printed = self.course("check", "01", code=1)
        self.assertLess(printed.index("01.one  0 of 3"), printed.index("01.and  3 of 3"))
        self.assertIn("one.cpp  (easy)", printed)

    def test_handout_of_a_tree_with_history(self):
        def git(*words):
            self.run_program(["git", "-C", self.root, "-c", "user.name=a", "-c", "user.email=a@b.c", *words])
        self.put("chapters/01_obj/exercise/one.cpp", "open")
        git("init", "-q")
        self.addCleanup(shutil.rmtree, self.root / ".git")
        git("add", "-A")
        git("commit", "-q", "-m", "all")
        self.put("grades.csv", "ann 2")
        self.put("chapters/01_obj/exercise/one.cpp", "right")
        folder = self.outside / "committed"
        self.assertIn("one.cpp: handed out as committed", self.course("handout", str(folder)))
        self.assertFalse((folder / "grades.csv").exists())
        self.assertEqual((folder / "chapters/01_obj/exercise/one.cpp").read_text(), "open")

    def test_handout_has_no_solution_and_works(self):
        self.accept()
        folder = self.outside / "handout"
        self.assertIn("2 exercises", self.course("handout", str(folder)))
        self.assertEqual(list(folder.rglob("solution")), [])
        self.assertTrue((folder / "chapters/01_obj/exercise/one.cpp").exists())
        self.assertIn("out of 2", self.run_program([folder / "course", "test"]).splitlines()[-1])
        self.course("handout", str(folder), code=2)

    def test_a_driver_that_crashes_is_no_mistake_of_the_students(self):
        def checked(exercise: str, chapter: str) -> dict:
            result = {"ok": True, "passed": 7, "failed": 0, "first_failure": None}
            shots = [{"name": "relief", "exercises": [exercise]}]
            with mock.patch.multiple(check, build=mock.DEFAULT, has_solutions=lambda: True, shots=lambda _: shots,
                                     wrong_picture=mock.Mock(side_effect=Crashed(f"{chapter} ended with -11"))):
                check.check_pictures(chapter, exercise, result)
            return result
        glsl = checked("04.parallax_occlusion", "04_surface_maps")
        self.assertEqual((glsl["ok"], glsl["passed"], glsl["first_failure"]), (True, 7, None))
        self.assertRegex(glsl["note"], "judged by its numbers alone: .* relief, with which the driver crashed")
        cpp = checked("04.tangent_frame", "04_surface_maps")  # C++ of a student's crashes by itself
        self.assertEqual((cpp["ok"], cpp["first_failure"]), (False, "04_surface_maps ended with -11"))
