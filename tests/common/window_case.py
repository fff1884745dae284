"""A chapter's window to test: a copy of the course's shaders, a scene of one's own, and the picture at the start."""
import json
import os
import re
import shutil
import tempfile
import time
import unittest
from pathlib import Path

from PIL import Image

from folder_case import FolderCase
from window_session import BUILD, PATIENCE_S, ROOT, Session, XServer

CHAPTER = BUILD / "chapters" / "01_obj"
WIDTH, HEIGHT, PANEL = 360, 720, 340


def read_png(path: Path) -> tuple[int, int, bytes]:
    """Width, height and RGB."""
    with Image.open(path) as picture:
        return *picture.size, picture.convert("RGB").tobytes()


def copy_of_course(folder: Path) -> Path:
    """Shaders to edit; everything else is only linked."""
    root = folder / "course"
    root.mkdir()
    shutil.copytree(ROOT / "shaders", root / "shaders")
    for name in ("assets", "chapters", "tests", "docs"):
        if (ROOT / name).exists():
            (root / name).symlink_to(ROOT / name)
    return root


def own_scene(folder: Path) -> Path:
    scene = folder / "my_scene.json"
    scene.write_text((ROOT / "assets" / "scenes" / "bunny.json").read_text())
    return scene


class StartedTest(FolderCase):
    """A window for each test, on a screen of its own."""

    def start(self, program: Path, *options, screen=(1400, 900), scene: dict | None = None, **more) -> Session:
        if scene:
            (self.folder / "scene.json").write_text(json.dumps(scene))
            options = ("--scene", str(self.folder / "scene.json"), *options)
        server = XServer(*screen)
        self.addCleanup(server.close)
        self.prepare(server)
        session = Session(server, program, list(options), self.folder, **more)
        self.addCleanup(session.close)
        return session

    def prepare(self, server: XServer):
        """Before anything is started there."""

    def end(self, session: Session):
        session.key("Escape")
        self.assertEqual((session.end(), [line for line in session.errors if line]), (0, []))


class PictureTest(unittest.TestCase):
    """Pictures are megabytes: a message says where they differ, not how."""

    def assert_same(self, picture: bytes, expected: bytes, why: str = ""):
        if picture == expected:
            return
        self.assertEqual(len(picture), len(expected), why)
        places = [i // 3 for i in range(0, len(picture), 3) if picture[i:i + 3] != expected[i:i + 3]]
        self.fail(f"{len(places)} pixels differ, from ({places[0] % WIDTH}, {places[0] // WIDTH}) to "
                  f"({places[-1] % WIDTH}, {places[-1] // WIDTH}) {why}")

    def assert_other(self, picture: bytes, expected: bytes):
        self.assertTrue(picture != expected, "the picture is the same")


class WindowTest(PictureTest):
    """One window, used by one test after the other; each leaves it as it found it."""

    refine = "off"
    environment: dict[str, str] = {}

    @classmethod
    def setUpClass(cls):
        cls.folder = Path(cls.enterClassContext(tempfile.TemporaryDirectory(prefix="lightwalk_window_")))
        cls.course = copy_of_course(cls.folder)
        cls.scene = own_scene(cls.folder)
        cls.server = XServer()
        cls.addClassCleanup(cls.server.close)
        cls.session = Session(cls.server, CHAPTER,
                              ["--validate", "on", "--size", f"{WIDTH}x{HEIGHT}", "--scene", str(cls.scene)],
                              cls.folder, refine=cls.refine, LIGHTWALK_ROOT=str(cls.course), **cls.environment)
        cls.start = cls.picture()

    @classmethod
    def tearDownClass(cls):
        cls.session.key("Escape")
        code = cls.session.end()
        said = [line for line in cls.session.errors if not re.match(r"error: (shaders/|\S+: pass 'encode_srgb')", line)
                and "my_scene.json" not in line and not line.startswith("    ")]
        assert code == 0 and not said, f"exit code {code}, it said {said}"

    @classmethod
    def picture(cls) -> bytes:
        return cls.session.settled(0, 0, WIDTH, HEIGHT)

    def picture_after(self, before: bytes) -> bytes:
        """The next picture, at rest: on a busy machine a key takes a while to show."""
        self.session.wait(lambda: self.session.pixels(0, 0, WIDTH, HEIGHT) != before, "another picture")
        return self.picture()

    def screenshot(self) -> Path:
        return Path(self.session.key("F12", says=r"screenshot (.*)")[1])

    def assert_as_at_the_start(self):
        """Soon: a message over the picture goes away by itself."""
        until = time.monotonic() + PATIENCE_S
        while self.session.pixels(0, 0, WIDTH, HEIGHT) != self.start and time.monotonic() < until:
            time.sleep(0.1)
        self.assert_same(self.session.pixels(0, 0, WIDTH, HEIGHT), self.start)

    def assert_last_good_picture_stays(self):
        """Between the message at the top and the error at the bottom."""
        rows = slice(3 * WIDTH * 60, 3 * WIDTH * (HEIGHT // 2))
        self.assert_same(self.picture()[rows], self.start[rows], "the last good picture did not stay")

    def assert_rests(self):
        """In the least busy of up to three seconds: on a busy machine the end of what went before takes a while."""
        stat = Path(f"/proc/{self.session.process.pid}/stat")
        used = []
        while len(used) < 3 and min(used, default=1) >= 0.3:
            before = sum(map(int, stat.read_text().split()[13:15]))
            time.sleep(1.0)
            used.append((sum(map(int, stat.read_text().split()[13:15])) - before) / os.sysconf("SC_CLK_TCK"))
        self.assertLess(min(used), 0.3, "seconds of work in a second in which nothing changes")
