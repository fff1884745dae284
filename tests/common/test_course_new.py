"""Tests of ./course new: refusals on the small course; in a copy of this one, a new chapter builds, draws and passes its tests."""
# Builds: nothing
import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

from small_course import REAL, Course, clean_environment

from build.options import check_options  # noqa: E402
from test.lesson_commands import printed  # noqa: E402
from tree import UsageError, chapters, files, walk  # noqa: E402


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


class Options(unittest.TestCase):
    """Options of a program, before it is built."""

    def test_a_wrong_one_is_refused_and_no_printed_one(self):
        for words, said in ((["--sho", "forge"], "unrecognised option '--sho' of chapter 08_bloom; the nearest are --shot"),
                            (["--shot", "forg"], "chapter 08_bloom has no shot 'forg'; the nearest are forge"),
                            (["--set", "bloom.methd=window"], "no knob of chapter 08_bloom is called 'methd'")):
            with self.assertRaisesRegex(UsageError, re.escape(said)):
                check_options("08_bloom", words)
        check_options("08_bloom", ["--set", "bloom.method=window", "--shot=forge", "--bloom.sigma_px", "4", "--help"])
        commands = printed()
        self.assertGreater(len(commands), 100)
        for one in commands:
            with self.subTest(str(one)):
                check_options(one.chapter, list(one.words))


@unittest.skipUnless(any(REAL.glob("shaders/*/solution")), "needs the reference solutions")
class Scaffold(unittest.TestCase):
    def test_it_builds_draws_and_passes(self):
        """With the checks of the whole tree's text, once its picture is accepted; before that a test names the next command. A second
        chapter can follow it."""
        last = int(chapters()[-1][:2])
        number, name = f"{last + 1:02}", f"{last + 1:02}_caustics"
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
            self.assertIn(f"./course accept {number}.corners", course("test", rf"^shots\.{number}$", code=1))
            course("accept", f"{number}.corners", "--yes")
            said = course("test", rf"^(check|shots|wrong_picture|unit|study)\.{number}|^unsolved\.{number}|text\.tree")
            self.assertIn("100% tests passed, 0 tests failed out of 7", said)
            course("new", f"{last + 2:02}_second")
            self.assertIn(f"./course accept {last + 2:02}.corners", course("test", "text.tree", code=1))


if __name__ == "__main__":
    unittest.main()
