"""The film in a window: the strip of its timeline under the mouse, and keys of a camera that is flown by hand."""

import json
import math
import unittest
from pathlib import Path

from picture_drawing import BUILD, BUILT, HAS_SOLUTION
from window_case import StartedTest
from window_session import ROOT

FILM = Path(__file__).resolve().parent / "short.film"
WIDTH, HEIGHT = 600, 320
STRIP = 116  # pixels of the strip's height


@unittest.skipUnless(BUILT and HAS_SOLUTION, "needs the programs and the reference solutions")
class FilmWindow(StartedTest):
    def setUp(self):
        self.film = self.folder / "own.film"
        self.film.write_text(FILM.read_text())
        self.session = self.start(BUILD / "chapters" / "19_ambiance", "--validate", "on", "--scene", str(self.film),
                                  "--size", f"{WIDTH}x{HEIGHT}", LIGHTWALK_ROOT=str(ROOT))

    def bar_x(self, time_s: float) -> float:
        left, _, right, _ = self.session.areas["strip.bar"]
        return left + (right - left) * time_s / 5

    def scrub(self, from_s: float, to_s: float) -> float:
        """The time at which it was left."""
        y = self.session.places["strip.bar"][1]
        said = self.session.drag((round(self.bar_x(from_s)), y), (round(self.bar_x(to_s)), y), says=r"film at ([\d.]+) s (\w+)")
        return float(said[1])

    def picture(self) -> bytes:
        return self.session.settled(0, 0, WIDTH, HEIGHT - STRIP)

    def test_the_strip_scrubs_steps_loops_and_keys_are_placed_by_flying_there(self):
        session = self.session
        session.wait(lambda: "strip.bar" in session.areas, "the strip")

        # It plays from the start; a click stops it, the bar sets it, and the picture is another.
        session.click("strip.play", says="film stands")
        at_s = self.scrub(0.4, 1.0)
        self.assertAlmostEqual(at_s, 1.0, delta=0.02)
        set_ = self.picture()
        self.assertAlmostEqual(self.scrub(1.0, 2.75), 2.75, delta=0.02)
        statue = self.picture()
        self.assertNotEqual(set_, statue)

        # Set back to the same time it is the same picture to the bit.
        self.scrub(2.75, 0.5)
        back_s = self.scrub(0.5, at_s)
        if back_s == at_s:
            session.wait(lambda: self.picture() == set_, "the picture that was there")

        # A frame on and back, with keys and with buttons; frame n is at n / 30.
        stepped = float(session.key("Right", says=r"film at ([\d.]+) s set")[1])
        self.assertAlmostEqual(stepped * 30, round(back_s * 30) + 1, delta=0.02)
        self.assertAlmostEqual(float(session.click("strip.back", says=r"film at ([\d.]+) s set")[1]), stepped - 1 / 30, delta=0.002)
        self.assertEqual(session.key("Next", says=r"film at ([\d.]+) s (\w+)").groups(), ("1.500", "statue"))
        self.assertEqual(session.click("strip.next", says=r"film at ([\d.]+) s (\w+)").groups(), ("3.500", "street"))
        self.assertEqual(session.click("strip.previous", says=r"film at ([\d.]+) s (\w+)").groups(), ("1.500", "statue"))

        # A scene that is looped comes again.
        self.scrub(1.5, 2.6)
        session.click("strip.loop", says="loop statue")
        since = session.said()
        session.key("space", says="film plays")
        session.wait_for_line("loop again", since)
        session.key("space", says="film stands")
        session.key("l", says="loop off")

        # Flown by hand, and a key where one stands: one more line in the file, and the rest as it was.
        self.scrub(3.0, 1.25)
        before, text = self.picture(), self.film.read_text()
        session.key("c", says="fly set")
        session.drag((300, 110), (380, 124))
        flown = self.picture()
        self.assertNotEqual(flown, before)
        since = session.said()
        time_s = float(session.key("k", says=r"key placed at ([\d.]+) s")[1])
        session.wait_for_line("fly off", since)
        film = json.loads(self.film.read_text())
        keys = film["scenes"][0]["camera"]["keys"]
        self.assertEqual(len(keys), 3)
        self.assertAlmostEqual(keys[1]["time_s"], time_s + 3, delta=0.0011)  # the scene's clock begins at 3 s
        self.assertGreater(math.dist(keys[1]["position"], [1.6, 0.7, 2.1]), 0.05)
        added = self.film.read_text()
        begin = next(i for i, (a, b) in enumerate(zip(text, added)) if a != b)
        self.assertTrue(added.endswith(text[begin:]), "only one piece is new")
        session.wait(lambda: not self.difference(self.picture(), flown), "the picture of the place where the camera was")

        # And gone again, to the byte; another scene is left alone.
        session.key("Delete", says=r"key removed at .*")
        self.assertEqual(self.film.read_text(), text)
        self.assertNotEqual(self.picture(), flown)

        # Foreign edits of the file stay; a file that is no film is not overwritten.
        self.film.write_text(text.replace("{} frames", "{} pictures"))
        session.key("k", says=r"key placed at .*")
        self.assertIn("{} pictures", self.film.read_text())
        self.film.write_text("{")
        session.key("k", says="not written")
        self.assertEqual(self.film.read_text(), "{")
        name = "a street of many houses and lamps"
        self.film.write_text(text.replace('"name": "street"', f'"name": "{name}"'))
        session.key("F5", says="reloaded")

        # The whole name of a scene is under the pointer.
        self.assertNotIn(f"strip.name.{name}", session.places)
        session.move(self.bar_x(4.5), session.areas["strip.bar"][1] + 10)
        session.wait(lambda: f"strip.name.{name}" in session.places, "the whole name")

        self.end(session)

    @staticmethod
    def difference(a: bytes, b: bytes) -> list[int]:
        """Places where the two differ by more than rounding a key to millimetres can do; a few at edges are left out."""
        far = [i for i in range(0, len(a), 3) if max(abs(x - y) for x, y in zip(a[i:i + 3], b[i:i + 3])) > 40]
        return far if len(far) > len(a) // 300 else []
