#!/usr/bin/env python3
"""A window at rest: its picture gathers sixteen samples, says how many, and shows one sample as soon as something moves."""
import subprocess
import unittest

from window_case import CHAPTER, HEIGHT, WIDTH, WindowTest, read_png


class Refining(WindowTest):
    refine = "on"

    def title(self) -> str:
        return self.session.xdotool("getwindowname", self.session.window).strip()

    def headless(self, samples: int) -> bytes:
        file = self.folder / "headless.png"
        subprocess.run([CHAPTER, "--screenshot", file, "--size", f"{WIDTH}x{HEIGHT}", "--scene", self.scene, "--samples", str(samples)], check=True)
        return read_png(file)[2]

    def whole(self) -> bytes:
        self.session.wait(lambda: self.title().endswith("16 of 16 samples"), "sixteen samples")
        return self.picture()

    def assert_nearly(self, picture: bytes, expected: bytes):
        """The order of sums may round one step of 1/255 away."""
        worst = max(abs(a - b) for a, b in zip(picture, expected, strict=True))
        self.assertLessEqual(worst, 1)

    def test_it_gathers_what_samples_gathers_and_then_rests(self):
        self.assert_nearly(self.whole(), self.headless(16))
        self.assert_rests()


if __name__ == "__main__":
    unittest.main()
