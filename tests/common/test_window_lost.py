"""A display that goes away, and a window of hardly any size: a line or nothing, never a hang. Under Xvfb."""
import tempfile
import unittest
from pathlib import Path

from window_case import CHAPTER
from window_session import PATIENCE_S, Session, XServer


class Lost(unittest.TestCase):
    def test_a_window_of_no_size_and_a_display_that_goes_away(self):
        with tempfile.TemporaryDirectory() as folder:
            server = XServer()
            try:
                session = Session(server, CHAPTER, ["--size", "64x48"], Path(folder))
                for width, height in (("1", "1"), ("700", "1"), ("600", "300")):
                    session.xdotool("windowsize", "--sync", session.window, width, height)
                    session.key("F12")  # something to do
                self.assertIsNone(session.process.poll(), session.errors)
            finally:
                server.process.kill()
                server.close()
            self.assertEqual(session.process.wait(PATIENCE_S), 1)
            for reader in session.readers:
                reader.join(PATIENCE_S)
            session.process.stdout.close(), session.process.stderr.close()
            self.assertEqual(session.errors, ["error: the display went away"])


if __name__ == "__main__":
    unittest.main()
