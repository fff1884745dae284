"""The real course's pages for tests of live lessons in a browser, served from a copy with exercises that may be edited."""

import fcntl
import functools
import shutil
import tempfile
import unittest
from pathlib import Path

from browser import WHY_NONE
from live_server import Server
from small_course import REAL

from live.serve import is_old
from pages import docs
from tree import BUILD


def copy_of_course(root: Path):
    """The server's inputs, and an editable exercise; the build is the course's own."""
    for name in ("common/course", "shaders"):
        shutil.copytree(REAL / name, root / name, ignore=shutil.ignore_patterns("__pycache__", "*.cpp"))
    for path in [*REAL.glob("docs/*.md"), *REAL.glob("docs/images/*.json"), *REAL.glob("docs/studies/*.json"),
                 *REAL.glob("chapters/*/exercise/*.cpp"), REAL / "course"]:
        (root / path.relative_to(REAL)).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(path, root / path.relative_to(REAL))
    for name in ("assets", "tests"):
        (root / name).symlink_to(REAL / name)
    for path in REAL.glob("chapters/*/"):  # a chapter need not have exercises in C++
        (root / "chapters" / path.name).mkdir(exist_ok=True)
    (root / "build").mkdir()
    for name in ("chapters", "tests", "shader_cache", "docs", "compare"):
        (root / "build" / name).symlink_to(BUILD / name)


@functools.cache
def has_pages():
    """The pages in the build folder: the first test that asks writes them, and others wait for it."""
    with (BUILD / "docs.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if is_old(BUILD / "docs"):
            docs.make(BUILD / "docs")


@unittest.skipIf(WHY_NONE, WHY_NONE)
class LivePage(unittest.TestCase):
    """A server of the course's own pages."""

    refine = "off"

    @classmethod
    def setUpClass(cls):
        has_pages()
        cls.root = Path(cls.enterClassContext(tempfile.TemporaryDirectory())).resolve() / "course"
        copy_of_course(cls.root)
        cls.server = Server(cls.root, refine=cls.refine, LIGHTWALK_ROOT=str(cls.root))
        cls.addClassCleanup(cls.server.__exit__)

    def opened(self, browser, lesson: str):
        browser.open(f"{self.server.base}{lesson}.html")
        browser.wait("document.body.classList.contains('live-ready')")
