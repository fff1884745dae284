"""The panel's *lesson* and *check* of an exercise. Under Xvfb, validated; ./course is a script that does as told."""
import json
import os
import tempfile
import unittest
from pathlib import Path

from small_course import until, write
from window_case import CHAPTER, HEIGHT, PANEL, WIDTH, StartedTest, WindowTest
from window_session import BUILD, PATIENCE_S, ROOT, Session, XServer

# Prints the contents of "says", after waiting for "go" if there is a "wait"; its process is in "pid", that of its own
# child, which ignores signals, in "child".
COURSE = """#!/bin/sh
cd "$(dirname "$0")"
echo "$@" > asked
if [ -e wait ]; then
    sh -c 'trap "" TERM; echo $$ > child; while sleep 0.1; do :; done' &
    echo $$ > pid
    while ! [ -e go ]; do sleep 0.05; done
    kill -9 $(cat child)
fi
cat says
exit $(cat code)
"""
OPENER = """#!/bin/sh
echo "$1" > "$(dirname "$0")/opened"
exit $(cat "$(dirname "$0")/opener_code")
"""


def is_alive(pid: int) -> bool:
    try:
        return Path(f"/proc/{pid}/stat").read_text().split()[2] != "Z"
    except OSError:
        return False


def has_text(file: Path) -> bool:
    return file.exists() and file.read_text() != ""


class Exercises(WindowTest):
    @classmethod
    def setUpClass(cls):
        cls.bin = Path(cls.enterClassContext(tempfile.TemporaryDirectory(prefix="lightwalk_bin_")))
        for name, text in (("xdg-open", OPENER), ("opener_code", "0")):
            write(cls.bin / name, text)
        cls.environment = {"PATH": f"{cls.bin}:{os.environ['PATH']}"}
        super().setUpClass()
        write(cls.course / "course", COURSE)

    def says(self, code: int, text: str):
        (self.course / "says").write_text(text)
        (self.course / "code").write_text(str(code))

    def verdict(self, code: int, exercise: str = "01.transform", **keys):
        self.says(code, "waiting for another\n" + json.dumps({"exercise": exercise} | keys) + "\nbye\n")

    def check(self, ending: str, exercise: str = "01.transform"):
        self.session.click(f"check.{exercise}", says=f"check {exercise} {ending}")

    def panel(self) -> bytes:
        return self.session.settled(WIDTH, 0, PANEL, HEIGHT)

    def assert_color(self, color: tuple[int, int, int], seen: bool):
        panel = self.panel()
        found = any(all(abs(panel[i + k] - color[k]) < 12 for k in range(3)) for i in range(0, len(panel), 3))
        self.assertEqual(found, seen, color)

    def test_a_check_that_passes_is_green_and_one_that_does_not_says_why(self):
        self.verdict(0, "01.triangulate", ok=True, passed=12, failed=0)
        self.check("passed", "01.triangulate")
        self.assertEqual((self.course / "asked").read_text(), "check 01.triangulate --json\n")
        self.assert_color((87, 212, 156), True)
        self.assertNotIn("words.01.triangulate", self.session.places)
        self.verdict(1, "01.triangulate", ok=False, passed=11, failed=1)
        self.check("open", "01.triangulate")
        self.verdict(1, "01.triangulate", ok=False, passed=0, failed=1, first_failure="it does not compile: line 3: error")
        self.check("invalid", "01.triangulate")
        self.verdict(1, ok=False, passed=3, failed=9, first_failure="a long sentence " * 60, hint="think of it")
        self.check("open")
        self.assert_color((87, 212, 156), False)
        self.assert_color((255, 115, 102), True)
        self.session.wait(lambda: "words.01.transform" in self.session.places, "its words")
        x, y = self.session.places["words.01.transform"]

        def words():
            return self.session.settled(WIDTH, round(y) + 12, PANEL, 140)
        whole = words()
        self.session.click("words.01.transform")  # folds them
        self.assertTrue(words() != whole)
        self.session.click("words.01.transform")
        self.assertTrue(words() == whole)
        # Longer than its box: the wheel turns it.
        self.session.move(x, y + 60)
        self.session.turn(-2)
        self.session.park()
        self.assertTrue(words() != whole)
        self.assert_as_at_the_start()

    def test_the_window_goes_on_while_a_check_runs(self):
        self.wait_for_a_check()
        since = self.session.said()
        self.session.key("F2")
        self.session.wait_for_line("toggle all mine", since)
        self.session.wait(lambda: self.session.pixels(0, 60, WIDTH, 500) != self.start[60 * 3 * WIDTH:560 * 3 * WIDTH],
                          "another picture")
        self.session.key("F2")
        self.assert_as_at_the_start()
        self.assert_rests()
        self.verdict(0, ok=True, passed=1, failed=0)
        (self.course / "go").touch()
        self.session.wait_for_line("check 01.transform passed", since)

    def wait_for_a_check(self):
        for name in ("go", "pid", "child"):
            (self.course / name).unlink(missing_ok=True)
        (self.course / "wait").touch()
        self.addCleanup((self.course / "wait").unlink)
        self.check("running")
        self.session.wait(lambda: has_text(self.course / "pid") and has_text(self.course / "child"), "the check")

    def test_closing_ends_what_the_check_has_started(self):
        server = XServer()
        self.addCleanup(server.close)
        session = Session(server, CHAPTER, ["--size", f"{WIDTH}x{HEIGHT}", "--scene", str(self.scene)], self.folder,
                          LIGHTWALK_ROOT=str(self.course))
        own, type(self).session = self.session, session
        try:
            self.wait_for_a_check()
            pids = [int((self.course / name).read_text()) for name in ("pid", "child")]
            self.assertTrue(all(map(is_alive, pids)))
            session.key("Escape")
            self.assertEqual(session.end(), 0)
            until(lambda: not any(map(is_alive, pids)), PATIENCE_S)
        finally:
            type(self).session = own
            session.close()

    def test_lessons(self):
        pages = self.course / "build" / "docs"
        self.session.click("lesson.01.transform", says="no page 01.transform")
        for name in ("01_obj.html", "open/01.transform.html"):
            (pages / name).parent.mkdir(parents=True, exist_ok=True)
            (pages / name).write_text("<p>")
        for place, page in (("lesson.01.transform", pages / "open/01.transform.html"), ("lesson", pages / "01_obj.html")):
            self.session.click(place, says=f"lesson {page}")
            self.session.wait(lambda: has_text(self.bin / "opened"), "the opener")
            self.assertEqual((self.bin / "opened").read_text().strip(), str(page))
            (self.bin / "opened").unlink()
        (self.bin / "opener_code").write_text("3")
        self.session.click("lesson", says="opener failed 3")
        (self.bin / "opener_code").write_text("0")
        (self.bin / "xdg-open").rename(self.bin / "gone")
        self.addCleanup((self.bin / "gone").rename, self.bin / "xdg-open")
        if not Path("/usr/bin/xdg-open").exists():
            self.session.click("lesson", says=f"no opener {pages}/01_obj.html")
        self.assert_as_at_the_start()


@unittest.skipUnless((ROOT / ".git").exists(), "the starters may have been edited")
class TheRealCheck(StartedTest):
    def test_a_starter_is_open(self):
        session = self.start(CHAPTER, "--size", f"{WIDTH}x{HEIGHT}", "--scene", str(ROOT / "assets/scenes/bunny.json"), LIGHTWALK_BUILD=str(BUILD))
        session.click("check.01.transform", says="check 01.transform open")
        self.end(session)
