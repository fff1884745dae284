"""Variants of exercises: applying a list of changes to a solution, and the errors for lists that do not fit."""
# Builds: nothing

import re
import unittest
from unittest import mock

import tree
from check import variants
from folder_case import FolderCase
from tree import Failure

SOLUTION = """// Solution of 02.sum.
float sum(int count) {
    float all = 0.0;  // of none
    barrier();

    // From the first on.
    for (int i = 0; i < count; ++i)
        all += value(i);
    barrier();
    return all;
}
"""


def applied(text: str) -> str:
    [(_, _, _, changes)] = variants.entries(text, "sum.changes")
    return variants.changed(SOLUTION, changes, "sum.changes")


class Lists(unittest.TestCase):

    def test_what_does_not_fit_is_named_by_its_line(self):
        for text, said in (
                ("== a: right\n- return none;\n+ return 0;\n", "sum.changes:2: 'return none;' is in the solution nowhere"),
                ("== a: right\n\n- barrier();\n+\n", "sum.changes:3: 'barrier();' is in the solution 2 times"),
                ("== a: right\n- all;\n+ 0.0;\n", "sum.changes:2: 'all;' is in the solution nowhere"),  # part of a line
                ("== a: right\n- return all;\n+ return 0;\n- return all;\n+\n", "sum.changes:4: 'return all;' is changed already"),
                ("== a: right\n- return all;\n== b: right\n", "sum.changes:2: nothing replaces 'return all;'"),
                ("== a: right\n+ return 0;\n", "sum.changes:2: '+ return 0;' has no meaning here"), ("- return all;\n", "sum.changes:1:"),
                ("== a is right\n", "sum.changes:1: '== a is right' has no meaning here")):
            with self.subTest(text), self.assertRaisesRegex(Failure, re.escape(said)):
                applied(text)


class Chapter(FolderCase):
    """A whole chapter's, with a file beside a list."""

    def setUp(self):
        self.write("shaders/02_sums/exercise/sum.glsl", "float sum(int count) { return 0.0; }\n")
        self.write("shaders/02_sums/solution/sum.glsl", SOLUTION)
        for kind in ("exercise", "solution"):
            self.write(f"chapters/02_sums/{kind}/twice.cpp",
                       f"namespace lightwalk::{kind} {{\nint twice(int a) {{\n    return 2 * a;\n}}\n}}\n")
        for module in (tree, variants):
            self.enterContext(mock.patch.object(module, "ROOT", self.folder))

    def test_mistakes_are_lines_and_the_others_are_read(self):
        self.write("tests/02_sums/variants/sum.whole.glsl", "// perhaps\n")
        self.write("tests/02_sums/variants/other.changes", "== a: right\n")
        self.write("tests/02_sums/variants/sum.changes",
                   "== a: right\n- no such line\n+\n== b: wrong: \n== c: right\n== c: right\n")
        found, mistakes = variants.variants("02_sums")
        self.assertEqual([one.name for one in found], ["sum.c.glsl"])
        for line, words in zip(mistakes, ("other.changes:1: there is no exercise 02.other", "sum.changes:2: 'no such line'",
                                          "sum.changes:4: 'wrong: ' is no verdict", "sum.changes:6: sum.c.glsl is at",
                                          "sum.whole.glsl:1: 'perhaps' is no verdict"), strict=True):
            self.assertIn(words, line)
