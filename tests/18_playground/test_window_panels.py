#!/usr/bin/env python3
"""Every panel of the editor, of a chapter and of the menu at three sizes: no text is cut, nothing lies on anything else or
reaches beyond its panel, fields stand in one column, and no part of a window is left empty. Under Xvfb."""
# Builds: 05_shadow_maps 18_playground menu
import json
import re
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "common"))

from window_session import BUILD, ROOT, Session, XServer, own_cache  # noqa: E402
from window_widgets import faults  # noqa: E402

SIZES = ((1280, 720, 1.0), (3840, 2160, 2.0))
# Far away: frames in which little is drawn take less time.
SCENE = {"camera": {"position": [0, 20, 80], "target": [0, 0, 0], "fov_deg": 30, "far_m": 1e9},
         "ambient": [0.3, 0.3, 0.3],
         "lights": [{"type": "directional", "direction": [-0.4, -0.8, -0.5], "name": "sun"},
                    {"type": "point", "position": [-12.5, 102.25, 1], "name": "lamp"},
                    {"type": "spot", "position": [-1, 2, 1], "name": "spot over a long table in the large hall"}],
         "objects": [{"name": "group"},
                     {"name": "box", "model": "models/cube.obj", "position": [-1234.5, 0.03125, 17]}]}
ENTRIES = ("scene", "camera", "environment", "sky", "terrain", "water", "fog", "effects", "group", "box", "sun", "lamp",
           "spot over a long table in the large hall")
SECTIONS = ("maps", "lights", "shadow", "rays", "sphere_shadow", "objects", "surface", "lamps")
FIELDS = ("number", "numbers", "choice", "field", "knob")


class Panels(unittest.TestCase):
    def start(self, program: str, size: tuple, *options: str, tour: bool = False, **environment: str) -> Session:
        width, height, self.scale = size
        server = XServer(width + 100, height + 100)
        self.addCleanup(server.close)
        server.set_text_scale(self.scale)
        folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        scene = folder / "panels.json"
        scene.write_text(json.dumps(SCENE))
        memory = folder / "state" / "lightwalk"
        memory.mkdir(parents=True)
        (memory / "05_shadow_maps.panel.json").write_text(json.dumps(dict.fromkeys(SECTIONS, True)))
        options = ("--scene", str(scene), "--size", "300x200", *options) if program != "menu" else ()
        session = Session(server, BUILD / program, list(options), folder,
                          events="layout", tour=tour, LIGHTWALK_ROOT=str(ROOT), **own_cache(folder), **environment)
        self.addCleanup(session.close)
        session.xdotool("windowmove", session.window, "0", "0")
        session.resize(width, height)
        if program != "menu":
            session.read_all()
        return session

    def check(self, session: Session, panel: str):
        session.read_all()
        with self.subTest(panel=panel):
            self.assertEqual(faults(session.layout, self.scale), [])
            fields = [one for one in session.layout if one.kind in FIELDS and one.panel.startswith("editor/properties")]
            ends = {one.right for one in fields if one.right - one.left > 2 * (one.bottom - one.top)}  # no checkboxes
            self.assertLessEqual(max(ends, default=0) - min(ends, default=0), 1, "right ends of fields")
            status = [one for one in session.layout if one.panel == "status"]
            if status:  # as wide as the picture, and below it
                for one in session.layout:
                    if not one.panel.startswith(("status", "passes", "question", "##")):
                        self.assertTrue(one.right <= status[0].room_left or one.left >= status[0].room_right,
                                        f"{one.name} lies over the picture")
            lines = {one.top for one in status}
            if not any(one.name == "notice" for one in session.layout):
                self.assertEqual(len(lines), 2, "lines of the status")

    def middle(self, session: Session, panel: str) -> float:
        """Of a panel, across."""
        one = next(one for one in session.layout if one.panel == panel)
        return (one.room_left + one.room_right) / 2

    def test_the_editor(self):
        for size in SIZES:
            session = self.start("chapters/18_playground", size, tour=True)
            self.check(session, "tour")
            session.tap("tool.leave the tour")
            for entry in ENTRIES:
                session.tap("entry." + entry)
                self.check(session, entry)
                if entry == "environment":
                    self.check_column(session)
                if entry == "camera":
                    self.assertEqual(next(one.text for one in session.layout if one.name == "number.far"), "none")
                if entry == "box":
                    session.tap("section.Material")
                    self.check(session, "material")
            for key in ("F1", "F4", "ctrl+o", "F6"):
                session.key(key)
                self.check(session, key)
                session.key(key)
            session.tap("entry.environment")
            session.tap("pick.environment")
            self.check(session, "picker")
            session.key("Escape")
            middle = 0.0
            for key in ("ctrl+shift+s", "ctrl+e"):
                session.key(key)
                self.check(session, key)
                middle = self.middle(session, "question") if key == "ctrl+shift+s" else middle
                session.key("Escape")
            session.tap("entry.box")
            session.key("Delete", "Escape")
            session.wait(lambda: "answer.stay" in session.places, "the question whether to save")
            self.check(session, "question")
            self.assertAlmostEqual(self.middle(session, "question"), middle, delta=2)
            session.close()

    def check_column(self, session: Session):
        """The scene's own fields and knobs begin in one column."""
        lefts = {one.left for one in session.layout
                 if one.kind in FIELDS and one.panel.startswith("editor/properties")}
        self.assertEqual(len(lefts), 1, lefts)

    def test_a_chapter(self):
        for size in SIZES:
            session = self.start("chapters/05_shadow_maps", size)
            self.check(session, "all sections")
            own = [area for name, area in session.areas.items() if re.fullmatch(r"knob\.\w+", name)]
            self.assertTrue(own and max(area[3] for area in own) <= size[1], "the chapter's own knobs are in view")
            session.tap("exercise." + next(name for name in session.areas if name.startswith("exercise."))[9:])
            self.check(session, "an exercise")
            session.key("F6")
            self.check(session, "passes")
            images = [one.bottom for one in session.layout if one.kind == "pass"]
            self.assertGreater(max(images), size[1] - 80 * self.scale, "images of passes leave room below")
            session.close()

    def test_the_menu(self):
        for size in SIZES:
            width = size[0]
            session = self.start("menu", size)
            session.wait(lambda: session.layout and session.layout[0].room_right > width - 60 * self.scale, "its tiles")
            self.assertEqual(faults(session.layout, self.scale), [])
            tiles = [one for one in session.layout if one.kind == "chapter"]
            if len({one.top for one in tiles}) > 1:
                self.assertGreater(max(one.right for one in tiles), width - 60 * self.scale, "tiles leave room on the right")
            session.close()


if __name__ == "__main__":
    unittest.main()
