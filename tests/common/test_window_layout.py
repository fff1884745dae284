"""Windows on keyboards and desktops of others: shortcuts by their letters, panels and window that scale together, the pixel
under the pointer, a display that goes away. Under Xvfb, validated."""
import subprocess

from window_case import CHAPTER, StartedTest
from window_session import PATIENCE_S, ROOT, Session

PANEL, STATUS = 340, 46
SCENE = {"camera": {"position": [0, 0, 4], "target": [0, 0, 0], "fov_deg": 40}, "ambient": [0.2, 0.2, 0.2],
         "lights": [{"type": "directional", "direction": [-0.4, -0.8, -0.5]}],
         "objects": [{"name": "box", "model": "models/cube.obj"}]}


class Layout(StartedTest):
    layout, scale = (), 1.0

    def prepare(self, server):
        if self.layout:
            subprocess.run(["setxkbmap", "-display", server.display, *self.layout], check=True)
        if self.scale != 1.0:
            server.set_text_scale(self.scale)

    def box(self, size: str, layout: tuple = (), scale: float = 1.0) -> Session:
        self.layout, self.scale = layout, scale
        session = self.start(CHAPTER, "--validate", "on", "--size", size, screen=(2000, 1500), scene=SCENE, LIGHTWALK_ROOT=str(ROOT))
        session.read_all()
        return session

    def test_keys_are_those_with_the_letter_on_them(self):
        session = self.box("360x300", ("us", "-variant", "dvorak"))  # H is where others have J
        before = session.settled(360, 0, PANEL, 300)
        session.key("h")
        session.wait(lambda: session.pixels(360, 0, PANEL, 300) != before, "the panel to go")
        session.key("h")
        session.wait(lambda: session.pixels(360, 0, PANEL, 300) == before, "the panel")
        self.end(session)

    def test_window_and_panels_scale_together_and_a_picture_of_a_given_size_does_not(self):
        for scale in (2, 3):
            with self.subTest(scale=scale):
                session = self.box("700x300", scale=scale)
                self.assertEqual(session.geometry()[2:], (700 + scale * PANEL, 300 + scale * STATUS))
                left, _, right, _ = session.areas["lesson"]
                self.assertGreater(left, 700)
                self.assertGreater(right - left, 0.85 * scale * PANEL)
                self.end(session)

    def pixel(self, session: Session, x: int, y: int) -> list:
        return session.move(x, y, says=rf"pixel \| {x}, {y}(.*)")[1].split(" | ")[1:]

    def test_the_pixel_under_the_pointer_says_value_depth_object_and_material(self):
        session = self.box("360x300")
        value, depth, *names = self.pixel(session, 180, 150)
        self.assertTrue(all(0 <= float(one) <= 1 for one in value.split()), value)
        self.assertEqual((depth, names[0]), ("3.5 m", "box"))  # its front is at 0.5 m
        self.assertEqual(len(self.pixel(session, 2, 2)), 1)  # the background has a value alone
        session.park()
        self.end(session)

    def test_a_window_of_no_size_and_a_display_that_goes_away(self):
        """A line or nothing, never a hang."""
        session = self.box("64x48")
        for width, height in (("1", "1"), ("700", "1"), ("600", "300")):
            session.xdotool("windowsize", "--sync", session.window, width, height)
            session.key("F12")  # something to do
        self.assertIsNone(session.process.poll(), session.errors)
        session.server.process.kill()
        self.assertEqual(session.process.wait(PATIENCE_S), 1)
        session.close()
        self.assertEqual(session.errors, ["error: the display went away"])
