"""The editor in a window, validated, with a scene of its own: the tests' actions on it."""
import json
import math
import tempfile
from pathlib import Path

from window_case import PictureTest
from window_session import BUILD, ROOT, Session, XServer, own_cache


class EditorTest(PictureTest):
    """One start, used by one test after the other."""

    size = (460, 700)  # of the picture; frames of a larger one take longer
    left_px = 310  # of the picture, beside the dock
    built: dict = {}  # the scene
    has_own_cache = False  # of thumbnails

    @classmethod
    def setUpClass(cls):
        cls.folder = Path(cls.enterClassContext(tempfile.TemporaryDirectory(prefix="lightwalk_editor_")))
        cls.scene = cls.folder / "built.json"
        cls.scene.write_text(json.dumps(cls.built))
        cls.add_files()
        cls.server = XServer()
        cls.addClassCleanup(cls.server.close)
        cls.session = cls.start(cls.scene)

    @classmethod
    def add_files(cls):
        """Beside the scene, before the start."""

    @classmethod
    def start(cls, scene: Path) -> Session:
        session = Session(cls.server, BUILD / "chapters" / "18_playground",
                          ["--validate", "on", "--size", "{}x{}".format(*cls.size), "--scene", str(scene)], cls.folder,
                          LIGHTWALK_ROOT=str(ROOT), **(own_cache(cls.folder) if cls.has_own_cache else {}))
        cls.addClassCleanup(session.close)
        return session

    def saved(self) -> dict:
        self.session.key("ctrl+s", says=r"saved .*")
        return json.loads(self.scene.read_text())

    def undo(self, times: int = 1, key: str = "ctrl+z", words: str = "undone"):
        for _ in range(times):
            self.session.key(key, says=f"notice {words}: .*")

    def middle(self) -> tuple[int, int]:
        """Of the picture, in the window."""
        return self.left_px + self.size[0] // 2, self.size[1] // 2

    def in_window(self, camera: dict, point: list) -> tuple[int, int]:
        """Where a point of the world is seen; a pinhole camera that stands upright."""
        def unit(v):
            return [one / math.dist(v, (0, 0, 0)) for one in v]

        def cross(a, b):
            return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]

        forward = unit([b - a for a, b in zip(camera["position"], camera["target"])])
        right = unit(cross(forward, [0, 1, 0]))
        away = [b - a for a, b in zip(camera["position"], point)]
        x, y, z = (sum(a * b for a, b in zip(away, axis)) for axis in (right, cross(right, forward), forward))
        pixels = self.size[1] / 2 / math.tan(math.radians(camera["fov_deg"]) / 2) / z
        return round(self.middle()[0] + pixels * x), round(self.middle()[1] - pixels * y)

    def scroll_to(self, place: str):
        """Turns the wheel over the properties until a widget of theirs is on the screen."""
        session = self.session
        session.wait(lambda: place in session.areas, f"a widget '{place}'")
        for _ in range(20):
            above = session.areas[place][1] < session.areas["properties"][1]
            if not above and session.areas[place][3] < self.size[1] - 10:
                return
            session.move(120, self.size[1] - 60)
            session.turn(3 if above else -3)
            session.park()
            session.read_all()
        self.fail(f"{place} does not come: {session.areas[place]}")

    def type_number(self, place: str, text: str):
        """Into the first number of a widget."""
        self.scroll_to(place)
        self.open_number(self.session.areas[place][0] + 8, self.session.places[place][1])
        self.session.replace(text)

    def open_number(self, x: float, y: float):
        """For typing, by Ctrl and a click."""
        session = self.session
        session.move(x, y)
        with session.holding("ctrl"):
            session.press()
            session.release()
        session.park()
        session.wait(lambda: session.types, "a field")

    def leave(self):
        """With nothing to say: what is open is closed, the selection goes, and the last one is asked for twice."""
        since = self.session.said()
        for _ in range(4):
            if not any("Esc again closes" in line for line in self.session.lines[since:]):
                self.session.key("Escape")
                self.session.read_all()
        self.session.key("Escape")
        self.assertEqual(self.session.end(), 0)
        self.assertEqual([line for line in self.session.errors if line], [])
