"""Comments name a thing by a noun and are short, in the folders that have been rewritten so; the others do not get worse."""
# Builds: nothing

import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "common/course"))
from test.comments import CLAUSE, comments, figures  # noqa: E402

MOST_CLAUSAL, MOST_WORDS = 0.03, 14
# Folders whose comments are not rewritten yet. It gets shorter, never longer.
WAITING = {"common": ["app", "base", "check", "gpu", "image", "judge", "measure", "scene", "study", "window"],
           "chapters": ["01", "05", "06", "10", "12", "13", "14", "15", "16", "17", "18", "19"],
           "shaders": ["05", "06", "10", "11", "12", "13", "14", "15", "17"]}
MOST_IN_ALL = 0.23  # clausal comments of everything, with some play above the state when it was measured


def waits(folder: str) -> bool:
    top, _, name = folder.partition("/")
    return name in WAITING[top] or name[:2] in WAITING[top]


class Comments(unittest.TestCase):
    def test_rewritten_folders_stay_so(self):
        for folder, (count, clausal, words) in figures().items():
            if waits(folder) or count < 5:
                continue
            with self.subTest(folder):
                self.assertLessEqual(clausal / count, MOST_CLAUSAL, f"python3 common/course test.comments {folder} lists them")
                self.assertLessEqual(words / count, MOST_WORDS)

    def test_the_others_do_not_get_worse(self):
        count, clausal = (sum(values[i] for values in figures().values()) for i in (0, 1))
        self.assertLessEqual(clausal / count, MOST_IN_ALL)

    def test_a_comment_is_lines_that_follow_one_another_or_stands_behind_code(self):
        found = comments("// One,\n// two.\nint a;  // what it is\n// [marker]\nurl(\"http://x\");\n/// Three words here\n\n// Four words more here\n")
        self.assertEqual(found, [(1, "One, two."), (3, "what it is"), (6, "Three words here"), (8, "Four words more here")])
        self.assertEqual([bool(CLAUSE.search(said)) for _, said in found], [False, True, False, False])


if __name__ == "__main__":
    unittest.main()
