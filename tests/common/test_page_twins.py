"""The twins of the smallest programs in C++ (docs/minimal/twins): short, and with the numbers that those print."""

import json
import math
import os
import re
import struct
import subprocess
import sys
import unittest
from pathlib import Path

from browser import CHROMIUM, Browser

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "common/course"))
from pages import running  # noqa: E402

BUILD = Path(os.environ.get("LIGHTWALK_BUILD", ROOT / "build"))
TWINS = running.MINIMAL / "twins"
# Numbers of a function, for each of `count` rows; `i` is the row's index.
NUMBERS = """(() => {
  const gl = Gl.context(), text = Gl.ported(%s).replace(/^in .*|^out .*|^layout.*|^uniform .*/gm, "").replace(/void main\\(\\)[^]*/, "");
  const main = `layout(location = 0) out uvec4 words;
    void main() { int i = int(gl_FragCoord.x) + 64 * int(gl_FragCoord.y); words = floatBitsToUint(vec4(0)); %s }`;
  const program = Gl.program(gl, Gl.TRIANGLE, Gl.HEAD + text + main);
  return Gl.table(gl, program, new Uint32Array(1), %d, %d).map(row => [...row]);
})()"""
POINTS = """
  float u = (float(i % 300) + 0.5) / 300.0, v = (float(i / 300) + 0.5) / 300.0, y = 2.0 * v - 1.0, r = sqrt(1.0 - y * y);
  vec3 normal = i % 2 == 1 ? vec3(r * cos(6.283185307 * u), y, r * sin(6.283185307 * u)) : vec3(0, 1, 0);
  vec3 point = i % 2 == 1 ? center + 0.6 * normal : 3.0 * vec3(u - 0.5, 0, v - 0.5);
  float seen = hit(point + 1e-4 * normal, to_sun) > 1e8 ? 1.0 : 0.0, texel_m = 2.0 * half_width_m / side;
  bool faces = dot(normal, to_sun) > 0.0;
  words = floatBitsToUint(faces ? vec4(abs(lit(point, normal, 0.0) - seen), abs(lit(point, normal, 2.0 * sqrt(2.0) * texel_m) - seen), 0, 0) : vec4(0));
"""
FLOOR = """
  vec2 pixel = vec2(i % 160, i / 160);
  float exact = 0.0;
  for (int k = 0; k < 1024; ++k) exact += level_at(0.0, floor_at(pixel + (vec2(k % 32, k / 32) + 0.5) / 32.0)) / 1024.0;
  pixel += 0.5;
  words = floatBitsToUint(vec4(level_at(0.0, floor_at(pixel)) - exact, mipmapped(floor_at(pixel), footprint_at(pixel)) - exact, 0, 0));
"""

# A row for each texel: red, green and blue of what one function gives.
SPREAD = "words = floatBitsToUint(vec4(spread(i), 0));"
LEAVING = "words = floatBitsToUint(vec4(leaving((float(i) - 999.5) * texel_mm, false), 0));"
# The middle 48 x 48 pixels of a picture of 96 x 96 at each of 22 angles: what it has, what it should have.
STAIRS = """
  float angle = float(3 + 4 * (i / 2304)) * 0.01745329;
  normal = vec2(sin(angle), cos(angle));
  ivec2 at = 24 + ivec2(i % 48, i / 48 % 48);
  float exact = 0.0;
  for (int k = 0; k < 256; ++k) exact += inside(vec2(at) + (vec2(k % 16, k / 16) + 0.5) / 16.0) / 256.0;
  words = floatBitsToUint(vec4(pixel(at, false), smoothed(at), exact, 0));
"""
SKY = "vec3 n = direction(i, 100); words = floatBitsToUint(vec4(irradiance(n, 20000).g, exact(n, 20000).g, 0, 0));"
GAUSSIANS = [(0.0064, 0.233, 0.455, 0.649), (0.0484, 0.1, 0.336, 0.344), (0.187, 0.118, 0.198, 0), (0.567, 0.113, 0.007, 0.007),
             (1.99, 0.358, 0.004, 0), (7.41, 0.078, 0, 0)]


def mean(values) -> float:
    values = list(values)
    return sum(values) / len(values)


def rms(values) -> float:
    return mean(value * value for value in values) ** 0.5


def of_shadow(rows) -> list[float]:
    return [mean(row[0] for row in rows), mean(row[1] for row in rows)]


def of_floor(rows) -> list[float]:
    return [rms(row[0] for row in rows), rms(row[1] for row in rows)]


def of_bloom(rows) -> list[float]:
    red = [row[0] for row in rows]
    middle = sum(i * value for i, value in enumerate(red)) / 16
    width = (sum((i - middle) ** 2 * value for i, value in enumerate(red)) / 16) ** 0.5
    return [sum(red), middle, width, 9 + 0.3 * red[500], 0.5 + 0.3 * red[520]]


def of_skin(rows) -> list[float]:
    found = []
    for c in range(3):
        def exact(x):
            return sum(one[1 + c] * 0.5 * math.erfc(-(x - 999.5) * 0.02 / math.sqrt(2 * one[0])) for one in GAUSSIANS)
        found += [rows[950][c], max(abs(row[c] - exact(x)) for x, row in enumerate(rows))]
    return found


def of_stairs(rows) -> list[float]:
    edges = [row for row in rows if 0 < row[2] < 1]
    return [rms(row[k] - row[2] for row in edges) for k in range(2)]


def of_sky(rows) -> list[float]:
    return [mean(row[1] for row in rows), max(abs(row[0] - row[1]) for row in rows)]


# By name: what runs, for how many rows of how many numbers, and the program's numbers from them.
NUMBERED = {"05_shadow_maps": (POINTS, 90000, 2, of_shadow), "07_mipmaps": (FLOOR, 19200, 2, of_floor), "08_bloom": (SPREAD, 1024, 3, of_bloom),
            "12_skin": (LEAVING, 2000, 3, of_skin), "13_mlaa": (STAIRS, 22 * 2304, 3, of_stairs), "14_environment": (SKY, 100, 2, of_sky)}


def printed(name: str) -> list[float]:
    done = subprocess.run([BUILD / "minimal" / name], stdout=subprocess.PIPE, text=True, check=True)
    return [float(number) for number in re.findall(r"-?\d+\.\d+", done.stdout)]

class Answers(unittest.TestCase):
    def test_each_program_has_the_place_that_an_answer_takes(self):
        for name, scene in running.scenes().items():
            text = scene.get("text") or (running.MINIMAL / f"{name}.frag").read_text()
            for exercise, (place, *_) in scene.get("mine", {}).items():
                self.assertIn(place, text, f"{name}: {exercise}")


class Twins(unittest.TestCase):
    def test_a_twin_has_at_most_60_lines(self):
        for path in TWINS.glob("*.frag"):
            lines = path.read_text().splitlines()
            self.assertLessEqual(len(lines), 60, path)
            self.assertLessEqual(max(map(len, lines)), 122, path)
            self.assertIn(path.stem, running.scenes())
            if (running.MINIMAL / f"{path.stem}.cpp").exists():
                self.assertIn(path.stem, NUMBERED)

    @unittest.skipUnless(CHROMIUM, "Chromium is not installed")
    def test_their_numbers_are_the_programs(self):
        with Browser(webgl=True) as browser:
            page = Path(os.environ.get("TMPDIR", "/tmp")) / f"twins.{os.getpid()}.html"
            page.write_text(f'<!doctype html><script src="{(running.OWN / "gl.js").as_uri()}"></script>')
            self.addCleanup(page.unlink)
            browser.open(page)
            for name, (calls, count, outs, numbers) in NUMBERED.items():
                with self.subTest(name):
                    rows = browser.evaluate(NUMBERS % (json.dumps((TWINS / f"{name}.frag").read_text()), calls.replace("\n", " "), count, outs))
                    rows = [struct.unpack(f"{outs}f", struct.pack(f"{outs}I", *row)) for row in rows]
                    for one, other in zip(numbers(rows), printed(name), strict=True):
                        # One of 14's 20,000 directions, at the rim of its window in single precision, carries up to 0.0045.
                        self.assertAlmostEqual(one, other, delta=0.0015 if name == "14_environment" else 0.0006)


if __name__ == "__main__":
    unittest.main()
