"""Submissions in later chapters that attack their grading (hostile_grade.py), and answers from a table."""

import subprocess
import unittest

from graded_class import OF, Class, right, why_not
from build.build import build
from hostile_grade import ATTACKS, TABLES
from grading.judge import Judge, targets
from grading.judge_compile import parts
from tree import BUILD, chapters



class Later(Class):
    wanted = sorted({exercise for exercise, _, _ in ATTACKS.values()})

    @classmethod
    def fill(cls):
        for name, (exercise, text, _) in ATTACKS.items():
            cls.student(name, {exercise: text})
        cls.student("honest", {exercise: right(exercise) for exercise in cls.wanted})

    def test_attacks_get_no_mark_and_are_told_why(self):
        for name, (exercise, _, words) in ATTACKS.items():
            with self.subTest(name):
                result = self.result(name, exercise)
                self.assertFalse(result["ok"], result)
                self.assertRegex(result["first_failure"], words)

    def test_the_honest_lose_nothing(self):
        self.assertEqual([one for one in self.grades["honest"]["results"] if not one["ok"]], [])


@unittest.skipIf(why_not(), why_not())
class Tables(unittest.TestCase):
    def test_a_table_of_what_everybody_can_see_is_wrong(self):
        with Judge({exercise: OF[exercise] for exercise in TABLES}, 2, False) as judge:
            for exercise, text in TABLES.items():
                for seed in (1, 2):
                    with self.subTest(exercise):
                        found = judge.judge(exercise, text.encode(), seed)
                        self.assertFalse(found["ok"], found)
                        self.assertNotRegex(found["first_failure"], "compile|link|error")
                        right_one = judge.judge(exercise, right(exercise).encode(), seed)
                        self.assertTrue(right_one["ok"], right_one)


class Built(unittest.TestCase):
    def test_a_tree_that_was_only_cloned_is_built_as_far_as_judging_needs(self):
        build(["serve_main"])
        made = set(subprocess.run(["ninja", "-C", BUILD, "-t", "commands", *targets(chapters())], check=True,
                                  stdout=subprocess.PIPE, text=True).stdout.split())
        for chapter in chapters():
            named = [str(path.relative_to(BUILD)) for path in parts(chapter)]
            self.assertEqual([name for name in named if name not in made], [])
            trials = [name for name in named if "checks_trial_" in name]
            self.assertEqual(bool(trials), chapter[:2] in ("02", "11", "12", "14"))


if __name__ == "__main__":
    unittest.main()
