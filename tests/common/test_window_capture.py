"""F11: the next frame for RenderDoc, where its library is loaded; elsewhere the window says how to load it."""

import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from played_renderdoc import play, why_not  # noqa: E402
from window_session import BUILD, Session, XServer  # noqa: E402

CHAPTER = BUILD / "chapters" / "01_obj"


@unittest.skipIf(why_not(BUILD / "liblightwalk.so"), why_not(BUILD / "liblightwalk.so"))
class Capture(unittest.TestCase):
    def test_f11(self):
        folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        environment = play(folder) | {"LD_PRELOAD": str(folder / "librenderdoc.so")}  # as RenderDoc starts a program
        server = XServer()
        self.addCleanup(server.close)
        session = Session(server, CHAPTER, ["--size", "64x48"], folder, **environment)
        since = session.said()
        session.key("F11")
        path = Path(session.wait_for_line(r"capture (.*)", since)[1])
        self.assertRegex(path.name, r"\Alightwalk_01_[\d_-]+\.rdc\Z")
        self.assertEqual(path.read_text(), "RDOC")
        self.assertEqual((folder / "said").read_text().split("\n")[2:-1], ["start", "end"])  # one frame, and no other
        session.key("Escape")
        self.assertEqual(session.end(), 0)


if __name__ == "__main__":
    unittest.main()
