#!/usr/bin/python3
"""Makes the pictures of this folder that show a window: docs/images/windows.py [NAME...], after ./course run and with Xvfb.

A function of the picture's name clicks and types as a person would; then the screen is saved as NAME.jpg.
"""

import shutil
import sys
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from PIL import Image

ROOT = Path(__file__).resolve().parents[2]
DOCK = 310  # pixels of the editor's panels on the left
sys.path.insert(0, str(ROOT / "tests/common"))
from window_session import BUILD, Session, XServer  # noqa: E402


def editor(session: Session):
    """The workbench: its statue moved by an arrow, and its material."""
    since = session.said()
    session.move(DOCK + 539, 248)
    session.press()
    session.release()
    session.wait_for_line("picked statue", since)
    session.drag((DOCK + 589, 308), (DOCK + 636, 310))  # by its arrow along x
    session.click("section.Material")
    session.wait(lambda: "ball" in session.places, "the ball of its material")
    session.click("section.Exercises")  # folded, so that knobs and their times come up


def timeline(session: Session):
    """The film, stopped and set by its bar to a time after sunset."""
    session.click("strip.play", says="film stands")
    left, top, right, bottom = session.areas["strip.bar"]
    session.drag((left + 2, bottom - 8), (round(left + 126 / 212 * (right - left)), bottom - 8), says=r"film at 12\d.* harbour")


@dataclass
class Window:
    chapter: str
    scene: str
    size: tuple[int, int]  # of the picture; the panel stands beside it
    has_panel: bool
    act: Callable[[Session], None]


WINDOWS = {"18_editor": Window("18_playground", "scenes/workbench.json", (790, 814), True, editor),
           "19_timeline": Window("19_ambiance", "films/ambiance.film", (960, 540), False, timeline)}


def make(name: str):
    window = WINDOWS[name]
    width, height = window.size
    with tempfile.TemporaryDirectory() as folder:
        scene = window.scene
        if scene.endswith(".json"):  # a copy: an editor writes beside its file
            scene = shutil.copy(ROOT / "assets" / scene, folder)
        server = XServer(width + 340 + DOCK + 60, height + 90)  # the mouse may leave the window
        try:
            session = Session(server, BUILD / "chapters" / window.chapter, ["--size", f"{width}x{height}", "--scene", scene],
                              Path(folder), LIGHTWALK_ROOT=str(ROOT), XDG_CACHE_HOME=folder)
            try:
                window.act(session)
                size = session.geometry()[2:] if window.has_panel else window.size
                shown = session.settled(0, 0, *size)
            finally:
                session.close()
        finally:
            server.close()
    Image.frombytes("RGB", size, shown).save(ROOT / "docs/images" / f"{name}.jpg", quality=88, optimize=True)


if __name__ == "__main__":
    unknown = [one for one in sys.argv[1:] if one not in WINDOWS]
    if unknown:
        print(f"no picture {unknown[0]}; there are: {', '.join(WINDOWS)}", file=sys.stderr)
        sys.exit(2)
    for one in sys.argv[1:] or WINDOWS:
        make(one)
