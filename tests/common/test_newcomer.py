# Builds: nothing
"""A newcomer's steps, in a clone in an empty folder, with the build that each command makes: the menu, the gallery, a
chapter, a check, the pages, live pages, one test. In the end the clone is as it was."""

import os
import re
import shutil
import signal
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

import window_session
from small_course import INTERRUPTIBLE, REAL
from window_session import Session, own_cache
from x_server import XServer

PATIENCE_S = 900  # ccache knows the machine's earlier compilations; an empty one takes minutes


def clone(to: Path):
    """The tree as it is here, including uncommitted files, by a git that is set to give texts the line ends of Windows."""
    subprocess.run(["git", "clone", "--quiet", "--no-hardlinks", "-c", "core.autocrlf=true", REAL, to], check=True)
    for command in (["diff", "--name-only", "--diff-filter=d", "-z", "HEAD"], ["ls-files", "-z", "--others", "--exclude-standard"],
                    ["diff", "--name-only", "--diff-filter=D", "-z", "HEAD"]):
        listed = subprocess.run(["git", "-C", REAL, *command], check=True, stdout=subprocess.PIPE, text=True).stdout
        for name in filter(None, listed.split("\0")):
            if (REAL / name).exists():
                (to / name).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(REAL / name, to / name)
            else:
                (to / name).unlink(missing_ok=True)
    subprocess.run(["git", "-C", to, "add", "-A"], check=True)


@unittest.skipUnless((REAL / ".git").exists(), "a newcomer clones")
class Newcomer(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(cls.enterClassContext(tempfile.TemporaryDirectory(prefix="lightwalk."))).resolve()
        cls.root = cls.folder / "lightwalk"
        clone(cls.root)
        cls.before = cls.status()
        cls.home = {"HOME": str(cls.folder / "home"), "CCACHE_DIR": os.environ.get("CCACHE_DIR", str(Path.home() / ".cache/ccache"))}
        (cls.folder / "home").mkdir()

    @classmethod
    def status(cls) -> str:
        return subprocess.run(["git", "-C", cls.root, "status", "--porcelain"], check=True, stdout=subprocess.PIPE, text=True).stdout

    def environment(self, **more) -> dict:
        outer = ("DISPLAY", "WAYLAND_DISPLAY", "LIGHTWALK_BUILD", "LIGHTWALK_CACHE", "CI", "XDG_STATE_HOME")
        return {name: value for name, value in os.environ.items() if name not in outer} | self.home | more

    def start(self, *words, **more) -> subprocess.Popen:
        process = subprocess.Popen([self.root / "course", *words], cwd=self.root, env=self.environment(**more), text=True,
                                   stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, **INTERRUPTIBLE)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.wait)
        self.addCleanup(lambda: process.poll() is None and os.killpg(process.pid, signal.SIGKILL))
        return process

    def course(self, *words, code=0) -> str:
        process = self.start(*words)
        said, _ = process.communicate(timeout=PATIENCE_S)
        self.assertIn(process.returncode, code if isinstance(code, tuple) else (code,), said)
        return said

    def test_1_with_a_display_the_menu_opens_and_shows_what_is_still_built(self):
        server = XServer()
        self.addCleanup(server.close)
        window_session.PATIENCE_S = PATIENCE_S
        began = time.monotonic()
        inside = self.environment()
        menu = Session(server, self.root / "course", ["run", "--menu"], self.folder,
                       LIGHTWALK_BUILD=str(self.root / "build"),  # a test's own is another
                       **{name: inside[name] for name in ("HOME", "CCACHE_DIR")}, **own_cache(self.folder))
        self.addCleanup(menu.close)
        print(f"the menu, after {time.monotonic() - began:.0f} s")
        self.assertEqual(menu.xdotool("getwindowname", menu.window).strip(), "Lightwalk")
        self.assertIn("chapter.19_ambiance", menu.places, "chapters that are not built are shown")
        states = (self.root / "build/menu_of_chapters/states").read_text()
        self.assertRegex(states, r"01_obj ready")
        if re.search(r"^19_ambiance waiting", states, re.M):
            since = menu.said()
            menu.tap("chapter.03_attenuation")
            menu.wait(lambda: any(line in ("wanted 03_attenuation", "started 03_attenuation") for line in menu.lines[since:]), "a click")
        menu.key("Escape")
        self.assertEqual(menu.end(60), 0)

    def test_2_without_a_display_the_gallery_grows(self):
        began = time.monotonic()
        course, page = self.start("run"), self.root / "build/gallery/index.html"
        while not page.exists():
            self.assertIsNone(course.poll(), "it ended without a page")
            self.assertLess(time.monotonic() - began, PATIENCE_S)
            time.sleep(0.2)
        print(f"the first picture, after {time.monotonic() - began:.0f} s")
        html = page.read_text()
        self.assertIn('<meta http-equiv="refresh"', html)
        self.assertRegex(html, r"waits for the compiler|compiling|pictures to come")
        self.assertTrue(list((self.root / "build/gallery").glob("*/*.png")))
        os.killpg(course.pid, signal.SIGINT)
        self.assertEqual(course.wait(30), 130)

    def test_3_a_chapter_a_check_the_pages_and_one_test(self):
        picture = self.folder / "05.png"
        self.course("run", "05", "--size", "160x90", "--screenshot", picture)
        self.assertGreater(picture.stat().st_size, 1000)
        self.assertIn("01.transform", self.course("check", "01", code=1))
        self.assertIn("build/docs/index.html", self.course("docs"))
        serve = self.start("serve", "--no-build", "--port", "0")
        self.assertRegex(serve.stdout.readline(), r"^http://127\.0\.0\.1:\d+/\?token=")
        os.killpg(serve.pid, signal.SIGTERM)
        self.assertIn("100% tests passed", self.course("test", "^python.common.(suites|compare)$"))

    @unittest.skipUnless(shutil.which("clang++"), "there is no clang, which builds fuzz targets")
    def test_3_the_readers_hold(self):
        self.assertRegex(self.course("fuzz", "8"), r"(\d+) of \1 targets held")

    def test_4_nothing_of_it_has_changed_the_tree(self):
        self.assertEqual(self.status(), self.before)
