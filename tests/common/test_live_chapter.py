"""Chapter 05 studied in the browser alone, as a new student would: each exercise from its starter, which is wrong, to an
answer that is typed and right, the one in C++ built meanwhile. The server runs on a copy of the tree that is made as it
writes (an overlay), so that nothing here is edited."""

import os
import subprocess
import tempfile
import unittest
from pathlib import Path

from browser import WHY_NONE, Browser
from live_server import Server
from small_course import REAL
from live_page import has_pages

CHAPTER = "05_shadow_maps"
BY_KEYS = "05.light_clip_position"  # typed key by key, with all that the editor adds
CHECK_S = 600  # with its build, on a machine that does other things
# The pages count as new: an overlay cannot rename their folder, as writing them would.
OVERLAY = ('mount -t overlay overlay -o "lowerdir=$1,upperdir=$2/upper,workdir=$2/work" "$1" && cd "$1" && shift 2 && '
           '{ [ ! -e build/docs/index.html ] || touch build/docs/index.html; } && exec "$@"')


def overlay(folder: Path) -> list[str]:
    for name in ("upper", "work"):
        (folder / name).mkdir()
    return ["unshare", "-m" if os.geteuid() == 0 else "-rm", "sh", "-c", OVERLAY, "sh", str(REAL), str(folder)]


def has_overlays() -> bool:
    with tempfile.TemporaryDirectory(dir="/var/tmp") as folder:
        try:
            return subprocess.run([*overlay(Path(folder)), "true"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode == 0
        except FileNotFoundError:
            return False


def answer_of(file: str) -> str:
    return (REAL / file.replace("/exercise/", "/solution/")).read_text().replace("lightwalk::solution", "lightwalk::exercise")


@unittest.skipIf(WHY_NONE, WHY_NONE)
@unittest.skipUnless(any((REAL / "shaders" / CHAPTER).glob("solution/*")), "a handout has no answer to type")
@unittest.skipUnless(has_overlays(), "this user may not mount an overlay")
class AChapterInTheBrowser(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        has_pages()
        made = tempfile.TemporaryDirectory(dir="/var/tmp")
        cls.addClassCleanup(made.cleanup)
        cls.edited = Path(made.name) / "upper"
        cls.server = Server(REAL, within=overlay(Path(made.name)), build=True)
        cls.addClassCleanup(cls.server.__exit__)
        cls.browser = Browser(1400, 1000, server=cls.server.base)
        cls.addClassCleanup(cls.browser.__exit__)
        cls.browser.open(cls.server.address)
        cls.browser.open(f"{cls.server.base}{CHAPTER}.html")
        cls.browser.wait("document.body.classList.contains('live-ready')")

    def test_from_the_first_exercise_to_the_last(self):
        listed = self.browser.evaluate("Live.course.chapters[Lesson.chapter].exercises")
        order = self.browser.evaluate("[...document.querySelectorAll('.run-open')].map(b => b.dataset.exercise)")
        self.assertEqual(order, [one["id"] for one in listed])
        for number, one in enumerate(listed):
            starter = (REAL / one["file"]).read_text()
            if starter == answer_of(one["file"]):
                self.skipTest(f"{one['id']} is being worked at")
            with self.subTest(one["id"]):
                self.solve(one["id"], one["file"], starter)
                solved = self.browser.evaluate("Live.progress[Lesson.chapter].solved.length")
                self.assertEqual(solved, number + 1)
        self.assertEqual(self.browser.complaints, [])
        self.browser.call("reload")
        self.browser.wait(f"document.querySelector('.live-progress')?.textContent.startsWith('{len(listed)} of ')")

    def solve(self, exercise: str, file: str, starter: str):
        page, heading = f"Exercise.all.get('{exercise}')", f"Exercise.section(document.getElementById('{exercise}'))[0]"
        self.assertTrue(self.browser.evaluate(f"{heading}.classList.contains('run-untouched')"))
        self.browser.evaluate(f"document.querySelector('.run-open[data-exercise=\"{exercise}\"]').click()")
        self.browser.wait(f"Boolean({page}?.editor && {page}.status.textContent)")
        self.assertEqual(self.browser.evaluate(f"{page}.editor.getValue()"), starter)
        self.assertIn("open", self.check(page))
        self.assertTrue(self.browser.evaluate(f"Boolean({page}.verdict.querySelector('p'))"), "it says what is wrong")
        self.browser.evaluate(f"window.said = []; new MutationObserver(() => window.said.push({page}.status.textContent))"
                              f".observe({page}.status, {{childList: true, characterData: true, subtree: true}})")
        if file.endswith(".cpp"):
            self.write(page, starter.replace("{\n", "{\n    oops\n", 1), by_keys=False)
            self.assertIn("open", self.check(page))
            line = starter.replace("{\n", "{\n    oops\n", 1).split("\n").index("    oops")
            self.assertLessEqual(abs(self.browser.evaluate(f"{page}.editor.marks[0].line.lineNo()") - line), 1)
        answer = answer_of(file)
        self.write(page, answer, exercise == BY_KEYS)
        self.assertIn("ok", self.check(page), self.browser.evaluate(f"{page}.verdict.textContent"))
        written = (self.edited / file).read_text()
        self.assertEqual("".join(written.split()), "".join(answer.split()))
        self.assertEqual(self.browser.evaluate(f"[...{heading}.classList].filter(c => c.startsWith('run-'))"), ["run-solved"])
        self.assertFalse(self.browser.evaluate(f"{page}.frame?.classList.contains('live-wrong') ?? false"))

    def check(self, page: str) -> str:
        """The class of the verdict that a check by its button leaves."""
        self.browser.evaluate(f"{page}.verdict.className = ''; {page}.check(), 0")
        return self.browser.wait(f"{page}.verdict.className", CHECK_S)

    def write(self, page: str, text: str, by_keys: bool):
        self.browser.evaluate(f"window.said.length = 0; {page}.editor.focus(); {page}.editor.execCommand('selectAll')")
        if by_keys:
            for i, line in enumerate(line.strip() for line in text.strip().split("\n")):
                if line == "}":  # the editor has put it there, one line further down
                    self.browser.press("ArrowDown")
                    self.browser.press("End")
                    continue
                if i:
                    self.browser.press("Enter")
                self.browser.call("keyboard.type", line)
        else:
            self.browser.call("keyboard.insertText", text)
        # It is saved as one types; one in C++ is built then.
        self.browser.wait(f"{page}.editor.getValue() === {page}.saved")
        if "cpp" in self.browser.evaluate(f"{page}.file"):
            self.browser.wait("window.said.includes('built')", CHECK_S)  # without being asked
            self.assertTrue(self.browser.evaluate("window.said.some(words => words.startsWith('building'))"))


if __name__ == "__main__":
    unittest.main()
