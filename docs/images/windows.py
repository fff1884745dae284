#!/usr/bin/python3
"""Makes the pictures of this folder that show a window: docs/images/windows.py [NAME...], after ./course run and with Xvfb.

A function of the picture's name clicks and types as a person would; then the screen is saved as NAME.jpg.
"""

import shutil
import sys
import tempfile
from pathlib import Path

from PIL import Image

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/common"))
from window_session import BUILD, Session, XServer  # noqa: E402

SIZE = (1060, 860)  # of the picture; the panel stands beside it


def editor(session: Session):
    """The workbench: its statue moved by an arrow, and what it is made of."""
    since = session.said()
    session.move(682, 262)
    session.press()
    session.release()
    session.wait_for_line("picked statue", since)
    session.drag((735, 325), (785, 327))  # by its arrow along x
    session.click("section.Material")
    session.wait(lambda: "ball" in session.places, "the ball of its material")
    session.click("section.Exercises")  # folded, so that knobs and their times come up


WINDOWS = {"18_editor": ("18_playground", "workbench", editor)}  # of a copy of the scene: an editor writes beside its file


def make(name: str):
    chapter, scene, act = WINDOWS[name]
    with tempfile.TemporaryDirectory() as folder:
        shutil.copy(ROOT / "assets/scenes" / f"{scene}.json", folder)
        server = XServer(SIZE[0] + 400, SIZE[1] + 40)  # the mouse may leave the window
        try:
            session = Session(server, BUILD / "chapters" / chapter, ["--size", "{}x{}".format(*SIZE), "--scene", f"{scene}.json"], Path(folder),
                              LIGHTWALK_ROOT=str(ROOT), XDG_CACHE_HOME=folder)
            try:
                act(session)
                size = session.geometry()[2:]
                shown = session.settled(0, 0, *size)
            finally:
                session.close()
        finally:
            server.close()
    Image.frombytes("RGB", size, shown).save(ROOT / "docs/images" / f"{name}.jpg", quality=88, optimize=True)


if __name__ == "__main__":
    for one in sys.argv[1:] or WINDOWS:
        make(one)
