"""Tests of a chapter's --pictures, as pages ask for them: a picture equals the command line's, and failures are reported."""
# Builds: 02_lambert_phong

import io
import subprocess
import tempfile
import unittest
from pathlib import Path

from PIL import Image, ImageChops

from folder_case import FolderCase
from shots.rendering import Drawing, render, render_many
from tree import BUILD, ROOT, Failure

PROGRAM = BUILD / "chapters" / "02_lambert_phong"
SHOT, SMALL = ["--shot", "teapot"], ["--size", "48x27"]


class Stream(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.program = cls.enterClassContext(Drawing(PROGRAM.name))

    def ask(self, **request) -> tuple[dict, bytes]:
        return self.asked({"words": SHOT, "size": [160, 90]} | request)

    def asked(self, question) -> tuple[dict, bytes]:
        return self.program.ask(question)[0], self.program.picture

    def picture(self, **request) -> Image.Image:
        answer, picture = self.ask(still=True, **request)
        self.assertEqual((answer["code"], answer["error"], answer["errors"]), (0, "", []))
        return Image.open(io.BytesIO(picture)).convert("RGB")

    def assert_same(self, one: Image.Image, other: Image.Image):
        self.assertIsNone(ImageChops.difference(one, other).getbbox())

    def test_a_picture_is_what_the_command_line_draws(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder, "a.png")
            for words, request in (([], {}), (["--set", "method=phong"], {"set": {"method": "phong"}}),
                                   (["--use", "exercise"], {"use": "exercise"}), (["--look", "encode_srgb"], {"look": "encode_srgb"})):
                subprocess.run([PROGRAM, *SHOT, *words, "--size", "160x90", "--screenshot", file], cwd=ROOT, check=True)
                self.assert_same(self.picture(**request), Image.open(file).convert("RGB"))

    def test_a_request_says_all_there_is_to_know(self):
        first = self.picture()
        for change in ({"turn_rad": 0.5}, {"tilt_rad": 0.3}, {"notches": 4}, {"pan": [0.2, 0]}, {"set": {"method": "phong"}}):
            self.assertIsNotNone(ImageChops.difference(first, self.picture(**change)).getbbox(), change)
            self.assert_same(first, self.picture())

    def test_the_first_request_with_words_names_exercises_too(self):
        words = [*SHOT, "--seed", "7"]
        first = self.picture(words=words, use="exercise")
        self.assert_same(first, self.picture(words=words, use="exercise"))
        self.assertIsNotNone(ImageChops.difference(first, self.picture(words=words)).getbbox())

    def test_what_moves_is_a_jpeg_and_tells_its_passes(self):
        answer, picture = self.ask()
        self.assertEqual((picture[:3], answer["format"], answer["size"]), (b"\xff\xd8\xff", "jpeg", [160, 90]))
        self.assertIn("encode_srgb", [name for name, _, _ in answer["passes"]])
        self.assertTrue(answer["looks"] and answer["device"])

    def test_what_is_wrong_is_said_and_the_next_one_drawn(self):
        for line, says in (("{", 'a line is no request: "{"'), ([1], "a line is no request: [1]"), ({"words": 1}, "a line is no request")):
            answer, picture = self.asked(line)
            self.assertEqual((answer["code"], picture), (2, b""))
            self.assertIn(says, answer["error"])
        for request, says in (({"set": {"nope": "1"}}, "unknown knob 'nope'"), ({"size": [4, 4]}, '"size": expected two numbers'),
                              ({"words": ["--shot", "nope"]}, "nope"), ({"use": "nope"}, "neither 'solution' nor 'exercise'"),
                              ({"look": "nope"}, "--look: no pass 'nope'"), ({"words": [*SHOT, "--screenshot", "/tmp/x.png"]}, '"words" name')):
            answer, picture = self.ask(**request)
            self.assertEqual((answer["code"], picture), (2, b""), request)
            self.assertIn(says, answer["error"])
        self.picture()


class Many(FolderCase):
    """Pictures of one process: a failure affects one of them alone. test_warm.py compares them with those of a cold start."""

    def setUp(self):
        self.chapter = PROGRAM.name

    def test_what_is_wrong_with_one(self):
        wanted = [(["--shot", "none"], self.folder / "a.png"), (SMALL, self.folder / "b.png"),
                  (["--method", "auto"], self.folder / "c.png")]
        found = render_many(self.chapter, wanted)
        self.assertRegex(found[0], "ended with 2: unknown shot 'none'")
        self.assertEqual(found[1], "")
        self.assertRegex(found[2], "ended with 2: .*--budget")
        self.assertTrue((self.folder / "b.png").exists())

    def test_one_that_ends_the_program(self):
        """The others are drawn by another."""
        wanted = [(SMALL, self.folder / f"{i}.png") for i in range(3)]
        found = render_many(self.chapter, [wanted[0], ([*SMALL, "--frames", "100000"], self.folder / "x.png"), wanted[2]],
                            LIGHTWALK_TIMEOUT_S="0.000001")
        self.assertTrue(all(found), found)  # none is in time, and each is said to be so
        with self.assertRaises(Failure):
            render(self.chapter, SMALL, self.folder / "y.png", LIGHTWALK_TIMEOUT_S="0.000001")
