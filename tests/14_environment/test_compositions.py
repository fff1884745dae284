"""Drawings of many chapters in one frame (compositions/everything.cpp), at the first try: a cold start, an odd size,
validation. The picture is the same for any order, drawn twice, on a screen within the picture or into a cube."""
# Builds: 14_environment everything everything_deferred compare
import tempfile
import unittest
from pathlib import Path

from picture_drawing import BUILD, BUILT, HAS_SOLUTION, Drawing, sets, steps
from window_session import Session, XServer

SCENES = Path(__file__).resolve().parent / "compositions"
PROGRAMS = ("everything", "everything_deferred")
# Reduces one-time work before the first frame, unrelated to the comparison.
CHEAP = ("shadow.resolution=256", "environment.prefilter.samples=4", "atmosphere.table_scale=0.25")
# The set draws its surroundings only where it is the first drawing.
NO_SURROUNDINGS = ("bloom.method=none", "around.intensity=0")


@unittest.skipUnless(BUILT and HAS_SOLUTION, "needs the programs and the reference solutions")
class Compositions(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(cls.enterClassContext(tempfile.TemporaryDirectory(prefix="lightwalk_compositions_")))
        cls.drawings = {program: Drawing(BUILD / "tests" / program) for program in PROGRAMS}
        for drawing in cls.drawings.values():
            cls.addClassCleanup(drawing.close)
        cls.pictures = {}  # by subject: each once

    def draw(self, program: str, scene: str, *options) -> Path:
        key = (program, scene, *options)
        if key not in self.pictures:
            picture = self.folder / f"{len(self.pictures)}.png"
            words = ["--scene", SCENES / f"{scene}.json", "--size", "127x71", *sets(*CHEAP), *options]
            code, wrong, said = self.drawings[program].draw(words, picture)
            said = [line for line in said.splitlines() if line.strip() and not line.startswith("drawing: ")]
            self.assertEqual((code, wrong, said), (0, "", []), key)
            self.pictures[key] = picture
        return self.pictures[key]

    def test_the_order_of_opaque_drawings_does_not_matter(self):
        for program in PROGRAMS:
            with self.subTest(program=program):
                behind, before = (self.draw(program, "everything", *sets(f"order={order}")) for order in ("behind", "before"))
                self.assertEqual(steps(behind, before), 0)

    def test_a_set_and_objects_hide_each_other_in_any_order(self):
        for program in PROGRAMS:
            with self.subTest(program=program):
                behind, before = (self.draw(program, "julia", *sets(f"order={order}", *NO_SURROUNDINGS))
                                  for order in ("behind", "before"))
                alone = self.draw(program, "julia", *sets("julia.iterations=1", *NO_SURROUNDINGS))
                self.assertLessEqual(steps(behind, before), 1)
                self.assertGreater(steps(behind, alone), 50)

    def test_drawn_twice_in_a_frame_it_is_the_same(self):
        for program in PROGRAMS:
            for frames in ("1", "2"):
                with self.subTest(program=program, frames=frames):
                    once, twice = (self.draw(program, "everything", "--frames", frames, *sets(f"show={show}"))
                                   for show in ("picture", "again"))
                    self.assertEqual(steps(once, twice), 0)

    def test_a_screen_shows_it_again(self):
        """A camera with the picture camera's view: nothing else of the picture changes with the screen's size."""
        small, large = (self.draw("everything", "everything", *sets("bloom.method=none", f"screens.width={width}"))
                        for width in (64, 480))
        self.assertGreater(steps(small, large), 5)

    def test_it_lights_itself_from_six_sides(self):
        off = self.draw("everything", "everything")
        for when in ("always", "moved"):
            lit = self.draw("everything", "everything", *sets(f"probe.update={when}", "probe.center=0,60,-9"))
            self.assertGreater(steps(lit, off), 20)

    def test_in_a_window(self):
        server = XServer()
        self.addCleanup(server.close)
        for program in PROGRAMS:
            with self.subTest(program=program):
                session = Session(server, BUILD / "tests" / program,
                                  ["--validate", "on", "--scene", str(SCENES / "everything.json"), "--size", "640x360"],
                                  self.folder)
                session.key("Escape")
                self.assertEqual((session.end(), session.errors), (0, []))
