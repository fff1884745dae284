"""Comments name a thing by a noun and are short; C++ has one statement a line. Over common, chapters, shaders, tests, Python."""
# Builds: nothing

import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "common/course"))
from test.comments import comments, figures, is_clausal, python_comments  # noqa: E402
from test.statements import code, found, joined  # noqa: E402

MOST_CLAUSAL, MOST_WORDS = 0.03, 14
MOST_IN_A_FOLDER = 0.05
MOST_JOINED = 1  # statements in a thousand lines
FIGURES = figures()
FEW = 20  # comments of a folder that are too few for a share
# Folders with longer comments on average, each with its limit and the reason. At most 20 lines.
LONGER = {
    "chapters/01_obj": (16, "formats of files, with the cases that real files have"),
    "chapters/13_mlaa": (16, "states of a line's ends, as tables"),
    "common/base": (15, "guarantees of files and processes"),
    "common/course": (17, "formats of files that commands read"),
    "common/image": (15, "formats of files, with their sources"),
    "common/measure": (16, "sources of every measure, with section and equation"),
    "common/study": (16, "the rule's statistics, with sources"),
    "docs/minimal": (16, "a lesson's programs, which explain themselves"),
    "shaders/05_shadow_maps": (17, "sources of filters, with their formulas"),
    "shaders/10_atmosphere": (18, "sources of the sky's formulas, and the ranges of their fits"),
    "shaders/11_fractals": (16, "sources of distance bounds"),
    "shaders/13_mlaa": (19, "bits of words, and states of edges"),
    "shaders/14_environment": (16, "sources of filtered light"),
    "shaders/17_planets": (17, "sources of laws and of bodies"),
    "chapters/10_atmosphere": (15, "ranges of the air's tables"),
    "chapters/19_ambiance": (15, "formats of the film and its tracks"),
    "chapters/17_planets": (15, "sources of orbits and rings"),
}


class Comments(unittest.TestCase):
    def test_all_together_are_within_the_limits(self):
        count, clausal, words = (sum(values[i] for values in FIGURES.values()) for i in range(3))
        self.assertGreater(count, 9000)  # so they are found
        self.assertLessEqual(clausal / count, MOST_CLAUSAL)
        self.assertLessEqual(words / count, MOST_WORDS)

    def test_each_folder_is_within_the_limits(self):
        self.assertLessEqual(len(LONGER), 20)
        for folder, (count, clausal, words) in FIGURES.items():
            most, _ = LONGER.get(folder, (MOST_WORDS, ""))
            if count >= FEW:
                with self.subTest(folder):
                    again = f"python3 common/course test.comments {folder} lists them"
                    self.assertLessEqual(clausal / count, MOST_IN_A_FOLDER, again)
                    self.assertLessEqual(words / count, most, again)

    def test_no_folder_is_excused_without_need(self):
        for folder in LONGER:
            count, _, words = FIGURES[folder]
            self.assertGreater(words / count, MOST_WORDS - 1, f"{folder} needs no exception any more")

    def test_a_comment_is_lines_that_follow_one_another_or_stands_behind_code(self):
        got = comments("// One,\n// two.\nint a;  // what it is\n// [marker]\nurl(\"http://x\");\n/// Three words here\n\n// Four words more here\n")
        self.assertEqual(got, [(1, "One, two."), (3, "what it is"), (6, "Three words here"), (8, "Four words more here")])
        self.assertEqual([is_clausal(said) for _, said in got], [False, True, False, False])

    def test_python_has_docstrings_too_and_a_quoted_word_is_no_clause(self):
        got = python_comments('#!/usr/bin/env python3\n"""One module.\n\n    a format\n\nWhose it is."""\n# two\n# lines\nx = 1  # behind `what`\n')
        self.assertEqual(got, [(2, "One module."), (2, "Whose it is."), (7, "two lines"), (9, "behind `what`")])
        self.assertEqual([is_clausal(said) for _, said in got], [False, True, False, False])


class Statements(unittest.TestCase):
    def test_each_has_its_own_line(self):
        for top in ("chapters", "common", "shaders", "tests"):
            lines = sum((ROOT / name).read_text(encoding="utf-8").count("\n") for name in code(top))
            with self.subTest(top):
                self.assertLessEqual(1000 * len(found(top)) / lines, MOST_JOINED, "python3 common/course test.statements lists them")

    def test_joined_ones_are_told_from_others(self):
        for line in ("a = 1, b = 2;", "if (x) a(1, 2), ++b;", "return act(), true;", "else a.push_back(f(1, 2)), n += 1;"):
            self.assertEqual([number for number, _ in joined(line)], [1], line)
        self.assertEqual(joined("f([&] {\n    a(),\n        b();\n});\nint c[] = {1, 2};\nX() : a(1), b(2) {}\nvoid g();\n"), [(2, "a(), b()")])
        for line in ("int a = 1, b = 2;", "f(a, b);", "std::map<int, int> m;", "return {1, 2};", "for (i = 0, j = 1;; ++i) {}", "b, c);", "// a = 1, b = 2;",
                     "const auto [a, b] = f();",
                     "std::vector<std::complex<double>> a(n), b(n + 1);", "std::array<std::array<int, n + 1>, n> all{};", "return f<T, U..., V>();"):
            self.assertEqual(joined(line), [], line)


if __name__ == "__main__":
    unittest.main()
