"""Tests of ./course new: refusals on the small course; in a copy of this one, a new chapter builds, draws and passes its tests."""
# Builds: nothing
import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

from small_course import REAL, Course, clean_environment

from tree import chapters, files, walk  # noqa: E402


class Refusals(Course):
    def test_one_line_and_nothing_written(self):
        before = walk(self.root)
        for name, said in (("caustics", "'caustics' is not a chapter's name; expected two digits, _ and lower-case letters, such as "
                                        "03_caustics"),
                           ("3_caustics", "is not a chapter's name"), ("03_Caustics", "is not a chapter's name"),
                           ("03_", "is not a chapter's name"), ("03_a/b", "is not a chapter's name"),
                           ("../03_a", "is not a chapter's name"), ("02_caustics", "there is a chapter 02_lambert already"),
                           ("03_lambert", "there is a chapter 02_lambert already"),
                           ("00_caustics", "chapter 00 would come before the last one, 02_lambert")):
            with self.subTest(name=name):
                self.assertRegex(self.course("new", name, code=2), rf"\Acourse: [^\n]*{said}[^\n]*\n\Z")
        self.assertRegex(self.course("new", code=2), r"\Acourse: [^\n]*NN_name[^\n]*\n\Z")
        self.put("docs/03_caustics.md", "mine")
        self.assertEqual(self.course("new", "03_caustics", code=2), "course: docs/03_caustics.md exists already; nothing was written\n")
        self.assertEqual(walk(self.root), sorted([*before, Path("docs/03_caustics.md")]))


@unittest.skipUnless(any(REAL.glob("shaders/*/solution")), "needs the reference solutions")
class Scaffold(unittest.TestCase):
    def test_it_builds_draws_and_passes(self):
        """With the checks of the whole tree's text, once its picture is accepted; before that a test names the next command."""
        name = f"{int(chapters()[-1][:2]) + 1:02}_caustics"
        number = name[:2]
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder) / "course"
            for path in files():
                (root / path).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(REAL / path, root / path)
            environment = clean_environment() | {"LIGHTWALK_CACHE": os.environ.get("LIGHTWALK_CACHE", str(REAL / "build/shader_cache"))}

            def course(*words, code=0):
                done = subprocess.run([root / "course", *words], env=environment, stdin=subprocess.DEVNULL, text=True,
                                      stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
                self.assertEqual(done.returncode, code, done.stdout[-4000:])
                return done.stdout

            self.assertIn(f"./course accept {number}.corners", course("new", name))
            self.assertIn(f"./course accept {number}.corners", course("test", rf"shots\.{number}", code=1))
            course("accept", f"{number}.corners", "--yes")
            said = course("test", rf"^(check|shots|unsolved|wrong_picture)\.{number}|text\.tree")
            self.assertIn("100% tests passed, 0 tests failed out of 5", said)


if __name__ == "__main__":
    unittest.main()
