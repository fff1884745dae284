"""Tests of ./course new: refusals on the small course; over this one, a new chapter builds, draws and passes its tests."""
# Builds: nothing
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from small_course import REAL, Course, clean_environment

from build.build import included, is_linked  # noqa: E402
from build.options import check_options  # noqa: E402
from test.lesson_commands import printed  # noqa: E402
from tree import UsageError, chapters, walk  # noqa: E402


class Refusals(Course):
    def test_one_line_and_nothing_written(self):
        before = walk(self.root)
        for name, said in (("caustics", "'caustics' is not a chapter's name; expected two digits, _ and lower-case letters, such as "
                                        "03_caustics"),
                           ("3_caustics", "is not a chapter's name"), ("03_Caustics", "is not a chapter's name"),
                           ("03_", "is not a chapter's name"), ("03_a/b", "is not a chapter's name"),
                           ("../03_a", "is not a chapter's name"), ("02_caustics", "there is a chapter 02_lambert already"),
                           ("03_lambert", "there is a chapter 02_lambert already"),
                           ("00_caustics", "chapter 00 would come before the last one, 02_lambert"),
                           ("05_caustics", "chapter 05 would leave a gap after the last one, 02_lambert; the next is 03_caustics")):
            with self.subTest(name=name):
                self.assertRegex(self.course("new", name, code=2), rf"\Acourse: [^\n]*{said}[^\n]*\n\Z")
        self.assertRegex(self.course("new", code=2), r"\Acourse: [^\n]*NN_name[^\n]*\n\Z")
        self.put("docs/03_caustics.md", "mine")
        self.assertEqual(self.course("new", "03_caustics", code=2), "course: docs/03_caustics.md exists already; nothing was written\n")
        self.assertEqual(walk(self.root), sorted([*before, Path("docs/03_caustics.md")]))
        (self.root / "docs/03_caustics.md").unlink()
        self.put("tests/03_caustics", "a file where a folder has to be")
        listed = (self.root / "tests/starters.txt").read_text()
        self.assertRegex(self.course("new", "03_caustics", code=2), r"\n?course: [^\n]*tests/03_caustics[^\n]*\n\Z")
        self.assertEqual(walk(self.root), sorted([*before, Path("tests/03_caustics")]))
        self.assertEqual((self.root / "tests/starters.txt").read_text(), listed)
        self.assertFalse((self.root / "chapters/03_caustics").exists())


# Each word of the scaffold's example, in files and in their names.
RENAMED = {"vignette": "halo", "Vignette": "Halo", "VIGNETTE": "HALO", "falloff": "decay", "corners": "edges", "shares": "ratios",
           "strength": "width"}


def rename_example(root: Path, name: str):
    """Replaces the example's words, as somebody does who begins a chapter of their own."""
    def renamed(text: str) -> str:
        return re.sub(r"[A-Za-z]+", lambda word: RENAMED.get(word[0], word[0]), text)
    for path in [path for folder in ("chapters", "shaders", "tests", "docs") for path in (root / folder).rglob("*")
                 if path.is_file() and name in path.relative_to(root).as_posix()]:
        text = renamed(path.read_text())
        path.unlink()
        path.with_name(renamed(path.name)).write_text(text)
    index = root / "docs/index.md"
    index.write_text("".join(renamed(line) if name in line else line for line in index.read_text().splitlines(keepends=True)))


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


class Links(unittest.TestCase):
    def test_a_file_that_includes_a_further_chapter_makes_cmake_run_again(self):
        links = {chapter: included(chapter) for chapter in chapters()}
        self.assertIn("05_shadow_maps", links["06_deferred"])
        with tempfile.TemporaryDirectory() as folder:
            def is_linked_as(links: dict) -> bool:
                Path(folder, "chapters.links").write_text("".join(" ".join([name, *sorted(others)]) + "\n" for name, others in links.items()))
                return is_linked(Path(folder))
            self.assertTrue(is_linked_as(links))
            self.assertFalse(is_linked_as(links | {"06_deferred": links["06_deferred"] - {"05_shadow_maps"}}))


# The arguments after it run with a layer over the course's folder ($0), kept in a folder ($1): the build of this tree goes on from
# where it is, and neither tree nor build is changed.
LAYERED = """set -e
mkdir "$1/changes" "$1/work"
mount -t overlay overlay -o "userxattr,lowerdir=$0,upperdir=$1/changes,workdir=$1/work" "$0"
cd "$0"
shift
exec "$@"
"""


def layered(*words, folder: str) -> list[str]:
    return ["unshare", "--map-root-user", "--mount", "sh", "-c", LAYERED, str(REAL), folder, *map(str, words)]


def can_be_layered() -> bool:
    with tempfile.TemporaryDirectory() as folder:
        replaces = ("sh", "-c", "rm -r docs/figures && mkdir docs/figures")
        return shutil.which("unshare") is not None and subprocess.run(layered(*replaces, folder=folder), stderr=subprocess.DEVNULL).returncode == 0


@unittest.skipUnless(any(REAL.glob("shaders/*/solution")), "needs the reference solutions")
@unittest.skipUnless((REAL / ".git").exists(), "git says what has changed")
@unittest.skipUnless(can_be_layered(), "this system mounts no layer over a folder for a user (unshare, overlay)")
class Scaffold(unittest.TestCase):
    def test_it_builds_draws_and_passes(self):
        """With the checks of the whole tree's text, once its picture is accepted; before that a test names the next command. A second
        chapter can follow it."""
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run(layered(sys.executable, __file__, "LAYERED", folder=folder), stdin=subprocess.DEVNULL, text=True,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, env=clean_environment())
        self.assertEqual(done.returncode, 0, done.stdout[-6000:])
        self.assertFalse([path for path in REAL.glob("chapters/*_caustics")])


def commands_of_framework(number: str, name: str) -> list[list[str]]:
    """The words behind ./course of the commands in docs/framework.md, for a chapter."""
    text = (REAL / "docs/framework.md").read_text().partition("## A chapter of your own")[2].partition("\n## ")[0]
    text = text.replace("20_caustics", name).replace("course run 20", f"course run {number}").replace("accept 20", f"accept {number}")
    return [line.split()[1:] for line in text.splitlines() if line.startswith("    ./course ")]


def write_two_chapters():
    """Within the layer: what docs/framework.md tells, for a chapter with names of its own."""
    def git(*words) -> str:
        return subprocess.run(["git", *words], cwd=REAL, check=True, stdout=subprocess.PIPE, text=True).stdout.strip()

    def course(*words, code=0):
        done = subprocess.run([REAL / "course", *words], stdin=subprocess.DEVNULL, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        expect(done.returncode == code, done.stdout)
        return done.stdout

    def expect(right: bool, said: str):
        if not right:
            sys.exit(said)
    last = int(chapters()[-1][:2])
    number, name = f"{last + 1:02}", f"{last + 1:02}_caustics"
    # Where files are edited, theirs is not the chapter's change.
    before = git("stash", "create") if git("status", "--porcelain", "--untracked-files=no") else "HEAD"
    new, run, accept, test = commands_of_framework(number, name)
    expect(f"./course accept {number}.corners" in (said := course(*new)), said)
    rename_example(REAL, name)
    course("docs", "--quote")
    course(*run)
    expect(f"./course accept {number}.edges" in (said := course("test", rf"^shots\.{number}$", code=1)), said)
    course(*(word.replace("corners", "edges") for word in accept), "--yes")
    said = course(*(word.replace("HEAD", before) for word in test))
    expect("100% tests passed" in said and f"shots.{number}" in said and "text.tree" in said, said)
    expect(not re.search(r"knobs|equal_methods .* Passed|text\.pages.* Passed", said), said)
    course("new", f"{last + 2:02}_second")
    course("study", number, "--size", "96x54", "--rounds", "1", "--out", "build/study/scaffold")
    said = course("test", rf"^(wrong_picture|tenth)\.{number}|^text\.tree$")
    expect("100% tests passed, 0 tests failed out of 3" in said, said)


if __name__ == "__main__":
    if sys.argv[1:] == ["LAYERED"]:
        write_two_chapters()
    else:
        unittest.main()
