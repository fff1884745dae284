"""The numbers of the smallest programs (docs/minimal), of the texts that pages draw with, run in a browser."""

import json
import math
import struct
import tempfile
import unittest
from pathlib import Path

from browser import WHY_NONE, Browser

from pages import running

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


@unittest.skipIf(WHY_NONE, WHY_NONE)
class Numbers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        page = Path(cls.enterClassContext(tempfile.TemporaryDirectory()), "numbers.html")
        page.write_text(f'<!doctype html><script src="{(running.OWN / "gl.js").as_uri()}"></script>')
        cls.browser = cls.enterClassContext(Browser(webgl=True))
        cls.browser.open(page)

    def rows(self, name: str, calls: str, count: int, outs: int) -> list[tuple]:
        """So many rows of so many numbers, of what runs behind a chapter's program."""
        text = (running.MINIMAL / f"{name}.frag").read_text()
        rows = self.browser.evaluate(NUMBERS % (json.dumps(text), calls.replace("\n", " "), count, outs))
        return [struct.unpack(f"{outs}f", struct.pack(f"{outs}I", *row)) for row in rows]

    def test_05_an_offset_ends_false_shadows(self):
        rows = self.rows("05_shadow_maps", POINTS, 90000, 2)
        self.assertGreater(mean(without for without, _ in rows), 0.2)
        self.assertLess(mean(with_offset for _, with_offset in rows), 0.01)

    def test_07_levels_end_most_of_the_error(self):
        rows = self.rows("07_mipmaps", FLOOR, 19200, 2)
        self.assertGreater(rms(without for without, _ in rows), 0.15)
        self.assertLess(rms(with_levels for _, with_levels in rows), 0.07)

    def test_08_a_pyramid_keeps_the_light_and_its_place(self):
        red = [row[0] for row in self.rows("08_bloom", SPREAD, 1024, 3)]
        middle = sum(i * value for i, value in enumerate(red)) / 16
        width = (sum((i - middle) ** 2 * value for i, value in enumerate(red)) / 16) ** 0.5
        self.assertAlmostEqual(sum(red), 16, 3)
        self.assertAlmostEqual(middle, 500.5, 1)
        # Halving texels of a width h has a variance of 3/4 h², doubling them again as well; the tube has 1/4.
        variance = sum((4 ** level - 1) / 2 for level in range(1, 6)) / 5 + 1 / 4
        self.assertAlmostEqual(width, variance ** 0.5, 2)

    def test_12_the_edge_of_a_shadow_is_its_error_functions(self):
        rows = self.rows("12_skin", LEAVING, 2000, 3)
        for c in range(3):
            for x, row in enumerate(rows):
                exact = sum(one[1 + c] * 0.5 * math.erfc(-(x - 999.5) * 0.02 / math.sqrt(2 * one[0])) for one in GAUSSIANS)
                self.assertLess(abs(row[c] - exact), 0.001, x)
        self.assertGreater(rows[950][0], 10 * rows[950][2])

    def test_13_smoothed_edges_are_closer_to_the_truth(self):
        edges = [row for row in self.rows("13_mlaa", STAIRS, 22 * 2304, 3) if 0 < row[2] < 1]
        self.assertGreater(rms(stairs - exact for stairs, _, exact in edges), 0.2)
        self.assertLess(rms(smoothed - exact for _, smoothed, exact in edges), 0.12)

    def test_14_nine_colours_hold_the_irradiance(self):
        rows = self.rows("14_environment", SKY, 100, 2)
        mean_ = mean(exact for _, exact in rows)
        self.assertGreater(mean_, 1)
        self.assertLess(max(abs(nine - exact) for nine, exact in rows), 0.08 * mean_)
