"""The twins of the smallest programs in C++ (docs/minimal/twins): short, and with the numbers that those print."""

import json
import os
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


def printed(name: str) -> list[float]:
    done = subprocess.run([BUILD / "minimal" / name], stdout=subprocess.PIPE, text=True, check=True)
    return [float(line.split()[1]) for line in done.stdout.splitlines()]


class Twins(unittest.TestCase):
    def test_a_twin_has_at_most_60_lines(self):
        for path in TWINS.glob("*.frag"):
            lines = path.read_text().splitlines()
            self.assertLessEqual(len(lines), 60, path)
            self.assertLessEqual(max(map(len, lines)), 122, path)
            self.assertIn(path.stem, running.scenes())

    @unittest.skipUnless(CHROMIUM, "Chromium is not installed")
    def test_their_numbers_are_the_programs(self):
        with Browser(webgl=True) as browser:
            page = Path(os.environ.get("TMPDIR", "/tmp")) / f"twins.{os.getpid()}.html"
            page.write_text(f'<!doctype html><script src="{(running.OWN / "gl.js").as_uri()}"></script>')
            self.addCleanup(page.unlink)
            browser.open(page)
            for name, calls, count, mean in (("05_shadow_maps", POINTS, 90000, lambda v: sum(v) / len(v)),
                                             ("07_mipmaps", FLOOR, 19200, lambda v: (sum(x * x for x in v) / len(v)) ** 0.5)):
                with self.subTest(name):
                    rows = browser.evaluate(NUMBERS % (json.dumps((TWINS / f"{name}.frag").read_text()), calls.replace("\n", " "), count, 2))
                    found = [mean([struct.unpack("f", struct.pack("I", row[k]))[0] for row in rows]) for k in range(2)]
                    for one, other in zip(found, printed(name), strict=True):
                        self.assertAlmostEqual(one, other, delta=0.0006)


if __name__ == "__main__":
    unittest.main()
