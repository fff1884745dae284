"""The suites of the tests (tests/suites.txt), and the tests of platform that a change concerns."""
# Builds: nothing

import tempfile
import unittest
from pathlib import Path
from unittest import mock

from test import suites
from test.reached import is_of_chapters, reached
from tree import ROOT, Failure

JUNIT = """<testsuite><testcase name="shots.01" time="2.4"/><testcase name="unit.common" time="1"/>
<testcase name="text.grade_book" time="70"/></testsuite>"""


class Suites(unittest.TestCase):
    def test_each_line_is_of_a_suite_and_its_paths_are_there(self):
        for suite, pattern, paths in suites.lines():
            with self.subTest(pattern):
                self.assertIn(suite, suites.SUITES)
                self.assertEqual(bool(paths), suite == "platform")
                self.assertEqual([path for path in paths if not list(ROOT.glob(f"{path}*"))], [])

    def test_the_first_line_that_matches_holds(self):
        for test, suite in (("shots.04", "first"), ("text.tree", "first"), ("variants.04", "engine"), ("window.common.window", "platform"),
                            ("python.common.knobs.04", "field"), ("text.grade_slurm", "field"), ("text.grade", "platform")):
            self.assertEqual(suites.line_of(test)[0], suite, test)

    def test_a_change_concerns_the_tests_of_its_part(self):
        tests = ["text.grade_book", "text.live", "window.common.window", "window.18_playground.window_tour"]
        self.assertEqual(suites.concerned(tests, ["common/course/live/files.py", "README.md"]), ["text.live"])
        self.assertEqual(suites.concerned(tests, ["chapters/18_playground/main.cpp"]), ["window.18_playground.window_tour"])
        self.assertEqual(suites.concerned(tests, ["common/judge/wire.h", "common/window/run.cpp"]), [tests[0], *tests[2:]])
        self.assertEqual(suites.concerned(tests, ["chapters/04_surface_maps/main.cpp"]), [])
        self.assertEqual(suites.concerned(tests, None), tests)

    def test_a_change_reaches_what_includes_or_draws_it(self):
        equal = "python.common.equal_methods"
        tests = ["check.08", "shots.02", "shots.05", "shots.06", "shots.08", "shots.19", "unit.08_bloom", "unit.common", "figures.08", "text.tree",
                 equal]
        for changed, expected in (
                ("chapters/08_bloom/exercises.h", ["check.08", "shots.08", "shots.19", "unit.08_bloom", "figures.08", "text.tree", equal]),
                ("chapters/19_ambiance/main.cpp", ["shots.19", "text.tree"]),
                ("shaders/05_shadow_maps/shadow.glsl", ["shots.05", "shots.06", "shots.19", "text.tree", equal]),
                ("chapters/04_surface_maps/maps.cpp", [test for test in tests if test not in ("shots.02", "unit.common")]),
                ("tests/05_shadow_maps/shots.json", ["shots.05", "text.tree", equal]),
                ("assets/scenes/colonnade.json", ["shots.05", "text.tree", equal]),
                ("docs/08_bloom.md", ["figures.08", "text.tree"]),
                ("common/window/panel.cpp", ["unit.common", "text.tree"]),
                ("tests/common/test_flip.cpp", ["unit.common", "text.tree"]),
                ("common/gpu/frame.h", tests)):
            with self.subTest(changed):
                self.assertEqual(reached(tests, [changed]), expected)

    def test_a_change_of_chapters_alone_is_known(self):
        chapter = ["chapters/08_bloom/main.cpp", "shaders/08_bloom/bright.comp", "tests/08_bloom/shots.json", "docs/08_bloom.md", "tests/starters.txt", ""]
        self.assertTrue(is_of_chapters(chapter))
        for more in ("common/app/knob.h", "common/course/new.py", "shaders/common/srgb.glsl", "tests/common/test_flip.cpp", "tests/build.cmake"):
            self.assertFalse(is_of_chapters([*chapter, more]), more)

    def test_a_change_begins_where_the_branch_left_the_main_one(self):
        def base(head: str, **merge_bases: str) -> str:
            def git(*words):
                found = merge_bases.get(words[2].replace("/", "_")) if words[0] == "merge-base" else head
                if not found:
                    raise Failure("no such branch")
                return f"{found}\n".encode()
            with mock.patch.object(suites, "git", git):
                return suites.branch_base()
        self.assertEqual(base("new", origin_HEAD="old"), "old")
        self.assertEqual(base("new", origin_main="old"), "old")
        self.assertEqual(base("same", origin_HEAD="same"), "HEAD~1")
        self.assertEqual(base("new"), "HEAD~1")

    def test_times_are_told_by_suite(self):
        with tempfile.NamedTemporaryFile("w", suffix=".xml") as file:
            file.write(JUNIT)
            file.flush()
            said = ["time of tests, some at once: first 2 s in 1 tests, engine 1 s in 1 tests, platform 70 s in 1 tests",
                    "slowest: text.grade_book 70 s, shots.01 2 s, unit.common 1 s"]
            self.assertEqual(suites.times(Path(file.name), with_reasons=False), said)
            self.assertEqual(suites.times(Path(file.name), with_reasons=True),
                             [*said, "above 60 s without a reason in tests/suites.txt: text.grade_book"])
