#!/usr/bin/env python3
"""Temporal anti-aliasing from a cold start: a picture depends on its time alone. Builds: 13_mlaa"""
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "common"))
from pictures import ChapterPictures  # noqa: E402


class ColdStart(ChapterPictures):
    chapter = "13_mlaa"

    def picture(self, name, *options):
        file = self.folder / f"{name}.png"
        self.run_program("--scene", "scenes/passing.json", "--method", "taa", "--set", "mlaa.taa.warm_up=6", "--size", "96x54",
                         *options, "--screenshot", file)
        return file.read_bytes()

    def test_frames(self):
        """The third of three frames and a single one at its time are equal to the bit, and no other time's is."""
        third = self.picture("third", "--frames", "3")
        self.assertEqual(third, self.picture("alone", "--time", str(2 / 60)))
        self.assertNotEqual(third, self.picture("first"))

    def test_gathers(self):
        """More frames make another picture, and samples gather further shifts."""
        six = self.picture("six")
        self.assertNotEqual(six, self.picture("one", "--set", "mlaa.taa.warm_up=1"))
        self.assertNotEqual(six, self.picture("samples", "--samples", "2"))


if __name__ == "__main__":
    unittest.main()
