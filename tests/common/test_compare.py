"""build/compare as its users meet it: figures, limits, and exit codes 0, 1, 2 with one line each.

LIGHTWALK_BUILD names the build folder where it is not build/ in the tree.
"""
# Builds: compare
import json
import os
import struct
import subprocess
import unittest

from PIL import Image

from folder_case import FolderCase
from tree import BUILD

COMPARE = BUILD / "compare"


@unittest.skipUnless(COMPARE.exists() or "LIGHTWALK_BUILD" in os.environ, f"{COMPARE} is not built")
class CompareTest(FolderCase):
    def setUp(self):
        self.a = self.picture("a.png", (64, 48), (100, 120, 140))
        moved = Image.open(self.a).copy()
        moved.putpixel((5, 7), (110, 120, 140))
        self.b = self.folder / "b.png"
        moved.save(self.b)

    def picture(self, name, size, colour):
        path = self.folder / name
        Image.new("RGB", size, colour).save(path)
        return path

    def compare(self, *arguments):
        return subprocess.run([COMPARE, *map(str, arguments)], capture_output=True, text=True, timeout=60)

    def assert_refused(self, result):
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertEqual(result.stdout, "")
        self.assertEqual(result.stderr.count("\n"), 1, result.stderr)

    def test_equal_pictures(self):
        result = self.compare(self.a, self.a, "--json", "--max-mean", 0, "--max-p99", 0, "--max-diff", 0)
        self.assertEqual(result.returncode, 0, result.stderr)
        figures = json.loads(result.stdout)
        self.assertEqual(figures["flip"]["mean"], 0)
        self.assertEqual(figures["rmse"], 0)
        self.assertIsNone(figures["psnr_db"])

    def test_figures_of_one_changed_pixel(self):
        figures = json.loads(self.compare(self.a, self.b, "--json").stdout)
        self.assertEqual(figures["max_diff"], {"steps": 10, "x": 5, "y": 7, "pixels": 1})
        linear = [((c / 255 + 0.055) / 1.055) ** 2.4 for c in (100, 110)]
        self.assertAlmostEqual(figures["max"], linear[1] - linear[0], places=6)
        self.assertAlmostEqual(figures["rmse"], (linear[1] - linear[0]) / (3 * 64 * 48) ** 0.5, places=7)
        self.assertEqual((figures["width"], figures["height"]), (64, 48))

    def test_a_local_error_is_caught_by_the_largest_step_where_the_mean_lets_it_pass(self):
        self.assertEqual(self.compare(self.a, self.b, "--max-mean", 0.01).returncode, 0)
        result = self.compare(self.a, self.b, "--max-mean", 0.01, "--max-diff", 3)
        self.assertEqual(result.returncode, 1)
        self.assertIn("largest step 10, at most 3", result.stderr)
        self.assertEqual(result.stderr.count("\n"), 1)

    def test_heat_map(self):
        out = self.folder / "heat.png"
        self.assertEqual(self.compare(self.a, self.b, "--heatmap", out).returncode, 0)
        heat = Image.open(out).convert("RGB")
        self.assertEqual(heat.size, (64, 48))
        self.assertEqual(heat.getpixel((60, 40)), (0, 0, 4))
        self.assertGreater(sum(heat.getpixel((5, 7))), 20)

    def test_hdr_with_nan(self):
        def pfm(name, values):
            return self.write(name, b"PF\n2 1\n-1.0\n" + struct.pack("<6f", *values))

        good = pfm("good.pfm", [1, 2, 3, 4, 5, 6])
        bad = pfm("bad.pfm", [1, 2, 3, float("nan"), 5, 6])
        result = self.compare(good, bad, "--json")
        self.assertEqual(result.returncode, 0, result.stderr)
        figures = json.loads(result.stdout)
        self.assertEqual((figures["nan"]["test"], figures["rmse"], figures["flip"]["kind"]), (1, 0, "hdr"))
        over = self.compare(good, bad, "--max-mean", 1)
        self.assertEqual(over.returncode, 1)
        self.assertIn("NaN or Inf", over.stderr)
        dark = pfm("dark.pfm", [0] * 6)
        self.assert_refused(self.compare(dark, good))
        self.assertEqual(self.compare(dark, good, "--exposures", -2, 3).returncode, 0)

    def test_bad_input_is_one_line_and_exit_code_2(self):
        small = self.picture("small.png", (10, 10), (0, 0, 0))
        text, cut = self.write("text.png", "no image"), self.write("cut.png", self.b.read_bytes()[:60])
        for arguments in ([self.a], [], [self.a, small], [self.a, self.folder / "missing.png"], [self.a, text],
                          [self.a, cut], [self.a, self.folder], [self.a, self.b, "--max-mean", "much"],
                          [self.a, self.b, "--max-mean", 7], [self.a, self.b, "--unknown"],
                          [self.a, self.b, "--ppd", 0], [self.a, self.b, "--heatmap", "/no/such/folder/h.png"]):
            with self.subTest(arguments=arguments):
                self.assert_refused(self.compare(*arguments))

    def test_nothing_is_left_behind_when_the_images_cannot_be_compared(self):
        small = self.picture("small.png", (10, 10), (0, 0, 0))
        before = sorted(self.folder.iterdir())
        self.compare(self.a, small, "--heatmap", self.folder / "heat.png")
        self.assertEqual(sorted(self.folder.iterdir()), before)
