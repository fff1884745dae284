"""The film in a window: it plays, is set back, and ends without a word from validation."""

import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "common"))
from picture_drawing import BUILD, BUILT, HAS_SOLUTION  # noqa: E402
from window_session import Session, XServer  # noqa: E402

FILM = Path(__file__).resolve().parent / "short.film"


@unittest.skipUnless(BUILT and HAS_SOLUTION, "needs the programs and the reference solutions")
class FilmWindow(unittest.TestCase):
    def test_in_a_window(self):
        server = XServer()
        self.addCleanup(server.close)
        with tempfile.TemporaryDirectory(prefix="lightwalk_film_window_") as folder:
            session = Session(server, BUILD / "chapters" / "19_ambiance",
                              ["--validate", "on", "--scene", str(FILM), "--size", "320x180"], Path(folder))
            session.key("F5")
            session.key("Escape")
            self.assertEqual((session.end(), session.errors), (0, []))


if __name__ == "__main__":
    unittest.main()
