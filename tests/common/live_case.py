"""Shared by the tests of the live pages: a small course with pages, and programs that echo their requests."""

from live_server import PROGRAM, Server
from small_course import Course

DRAW = {"do": "draw", "place": "a", "number": 1, "chapter": "01_obj", "shot": "bunny"}


class Live(Course):
    """A small course with a page, and programs that echo their requests."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        for name in ("01_obj", "02_lambert"):
            cls.write(f"build/chapters/{name}", PROGRAM)
        cls.write("build/docs/index.html", "<html><head></head><body>home</body></html>")
        cls.write("build/docs/source/a.html", "<html><head></head></html>")
        cls.write("build/secret", "hidden words")
        (cls.root / "build/docs/link.html").symlink_to(cls.root / "build/secret")
        cls.write("build/tests/check_01_obj", (cls.root / "programs/tests/check_01_obj").read_text())
        cls.server = Server(cls.root)
        cls.addClassCleanup(cls.server.__exit__)

    @classmethod
    def write(cls, name: str, text: str):
        path = cls.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        path.chmod(0o755 if text.startswith("#!") else 0o644)
