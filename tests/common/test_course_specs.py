"""Specifications of exercises: no long line, and each sentence is tested by variants that break it (check/spec.py)."""
# Builds: nothing

import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "common" / "course"))

import tree  # noqa: E402
from check import spec, variants  # noqa: E402

LONGEST = 100

STARTER = """// Exercise 02.sum: a title. It is no sentence of the specification.

// [sum]
// The sum of `count` numbers, by F. Gauss. An empty
// sum is 0:
// - `count` may be 0. sum() is 0 then.
// - order is
//   free.
//
// With
//
//     a = b. Never = 1.
//
// it is done. (Right to 1e-5.) More.
// [/sum]
// A comment.
float sum(int count) { return 1.0; }
"""
SENTENCES = ["The sum of `count` numbers, by F. Gauss.", "An empty sum is 0:", "`count` may be 0.", "sum() is 0 then.",
             "order is free.", "it is done.", "(Right to 1e-5.)"]
TABLE = """> The sum of `count` numbers = half other
> An empty sum = -
> `count` may be 0. = -
> sum() is = half
> order is free = other
> it is = -
> (Right = half
"""
ENTRIES = "== half: wrong: expected 1\n- return 1.0;\n+ return 0.5;\n== other: right\n- return 1.0;\n+ return 2.0 - 1.0;\n"


class Sentences(unittest.TestCase):
    def test_a_specification_is_cut_into_its_sentences(self):
        self.assertEqual(spec.sentences(STARTER), SENTENCES)

    def test_no_line_is_long(self):
        for chapter in tree.chapters():
            for exercise, starter in tree.exercises(chapter).items():
                inside = False
                for number, line in enumerate(starter.read_text().splitlines(), 1):
                    if line.startswith("// [") and line.endswith("]"):
                        inside = "[/" not in line
                    if inside and line.startswith("//"):
                        self.assertLessEqual(len(line), LONGEST, f"{tree.relative(starter)}:{number}: {exercise}")

    def test_six_have_a_fault_to_find_and_six_a_choice_to_defend(self):
        titles = [starter.read_text().partition("\n")[0] for chapter in tree.chapters() for starter in tree.exercises(chapter).values()]
        for kind in (": find the fault in ", ": choose and defend: "):
            self.assertGreaterEqual(sum(kind in title for title in titles), 6, kind)

    def test_each_sentence_is_tested(self):
        for chapter in tree.chapters():
            self.assertEqual(spec.untested(chapter), [])


class Tables(unittest.TestCase):
    def setUp(self):
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        for module in (tree, variants, spec):
            self.enterContext(mock.patch.object(module, "ROOT", self.folder))
        for name, text in (("shaders/02_sums/exercise/sum.glsl", STARTER), ("tests/02_sums/variants/sum.changes", ""),
                           ("shaders/02_sums/solution/sum.glsl", "float sum(int count) {\n    return 1.0;\n}\n")):
            (self.folder / name).parent.mkdir(parents=True)
            (self.folder / name).write_text(text)

    def untested(self, table: str) -> list[str]:
        (self.folder / "tests/02_sums/variants/sum.changes").write_text(table + ENTRIES)
        return spec.untested("02_sums")

    def test_a_whole_table(self):
        self.assertEqual(self.untested(TABLE), [])
        self.assertEqual([one.name for one in variants.variants("02_sums")[0]], ["sum.half.glsl", "sum.other.glsl"])

    def test_what_is_missing_is_named_by_its_line(self):
        file = "tests/02_sums/variants/sum.changes"
        self.assertEqual(self.untested(""), [f"{file}:1: no table of the sentences of 02.sum"])
        self.assertEqual(self.untested(TABLE.replace("> sum() is = half\n", "")),
                         [f"{file}:4: no row here for: sum() is 0 then."])
        self.assertEqual(self.untested(TABLE.replace("= half other", "= hal")), [f"{file}:1: there is no variant hal"])
        self.assertEqual(self.untested(TABLE + "> And so on = half\n"),
                         [f"{file}:8: no sentence of 02.sum begins with: And so on"])


if __name__ == "__main__":
    unittest.main()
