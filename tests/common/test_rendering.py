"""Many pictures by one process equal those of separate processes, and a failure affects one picture only."""
import json
import subprocess
import unittest

from pictures import ROOT, ChapterPictures

from shots.rendering import render, render_many  # which pictures.py has made importable
from tree import Failure

SMALL = ["--size", "48x27"]


class Many(ChapterPictures):
    chapter = "04_surface_maps"

    def test_they_are_the_same(self):
        """By turns: other knobs, other answers, another scene, another time; and the first once more."""
        shots = [shot["name"] for shot in json.loads((ROOT / "tests" / self.chapter / "shots.json").read_text())["shots"]]
        wanted = [[*SMALL, "--shot", shots[0]], [*SMALL, "--shot", shots[0], "--set", "maps.normal=off"],
                  [*SMALL, "--shot", shots[0], "--use", "exercise"], [*SMALL, "--shot", shots[1]],
                  [*SMALL, "--shot", shots[0], "--use", "04.unpack_normal=exercise"],
                  [*SMALL, "--shot", shots[0], "--use", "02.lambert=exercise"],
                  [*SMALL, "--scene", "models/suzanne_family.glb", "--time", "0.5"], [*SMALL, "--shot", shots[0]]]
        many = [self.folder / f"many{i}.png" for i in range(len(wanted))]
        self.assertEqual(render_many(self.chapter, list(zip(wanted, many))), [""] * len(wanted))
        for i, options in enumerate(wanted):
            render(self.chapter, options, self.folder / f"own{i}.png")
            self.assertEqual(many[i].read_bytes(), (self.folder / f"own{i}.png").read_bytes(), options)
        self.assertEqual(many[0].read_bytes(), many[-1].read_bytes())
        self.assertEqual(len({picture.read_bytes() for picture in many}), len(many) - 1)

    def test_what_is_wrong_with_one(self):
        wanted = [(["--shot", "none"], self.folder / "a.png"), (SMALL, self.folder / "b.png"),
                  (["--method", "auto"], self.folder / "c.png")]
        found = render_many(self.chapter, wanted)
        self.assertRegex(found[0], "ended with 2: unknown shot 'none'")
        self.assertEqual(found[1], "")
        self.assertRegex(found[2], "ended with 2: .*--budget")
        self.assertTrue((self.folder / "b.png").exists())

    def test_what_is_no_command_line(self):
        lines = ["{", "[1]", '["--size", "48x27"]', "[]"]
        done = subprocess.run([self.program, "--pictures"], input="\n".join(lines) + "\n", capture_output=True, text=True,
                              timeout=120, cwd=ROOT)
        answers = [json.loads(line) for line in done.stdout.splitlines()]
        self.assertEqual([answer["code"] for answer in answers], [2] * len(lines))
        self.assertIn("a line is no request", answers[0]["error"])
        self.assertIn("--screenshot", answers[2]["error"])
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_one_that_ends_the_program(self):
        """The others are drawn by another."""
        wanted = [(SMALL, self.folder / f"{i}.png") for i in range(3)]
        found = render_many(self.chapter, [wanted[0], ([*SMALL, "--frames", "100000"], self.folder / "x.png"), wanted[2]],
                            LIGHTWALK_TIMEOUT_S="0.000001")
        self.assertTrue(all(found), found)  # none is in time, and each is said to be so
        with self.assertRaises(Failure):
            render(self.chapter, SMALL, self.folder / "y.png", LIGHTWALK_TIMEOUT_S="0.000001")


if __name__ == "__main__":
    unittest.main()
