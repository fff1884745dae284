"""The program of docs/vulkan.md: silent under validation, into a file and into a window; and the broken one, with mistakes
that validation names as the page says."""

import os
import re
import subprocess
from pathlib import Path

from folder_case import FolderCase
from x_server import XServer
from tree import BUILD, ROOT

PROGRAMS = BUILD / "minimal"
FOLDER = ROOT / "docs" / "minimal"
PAGE = (ROOT / "docs" / "vulkan.md").read_text(encoding="utf-8")
SIDE = 256
CORNERS = {"red": (0, -0.8), "green": (-0.8, 0.6), "blue": (0.8, 0.6)}  # of the triangle, in clip space
BACKGROUND = (0.02, 0.02, 0.03)


def srgb(linear: float) -> float:
    """IEC 61966-2-1, from 0 to 255."""
    return 255 * (12.92 * linear if linear <= 0.0031308 else 1.055 * linear ** (1 / 2.4) - 0.055)


def weights(x: float, y: float) -> list[float]:
    """Barycentric coordinates of a point with respect to the three corners."""
    (ax, ay), (bx, by), (cx, cy) = CORNERS.values()
    whole = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay)
    b = ((x - ax) * (cy - ay) - (cx - ax) * (y - ay)) / whole
    c = ((bx - ax) * (y - ay) - (x - ax) * (by - ay)) / whole
    return [1 - b - c, b, c]


def run(program: Path, *arguments, display: str = "") -> subprocess.CompletedProcess:
    environment = os.environ | {"DISPLAY": display, "XDG_RUNTIME_DIR": "/tmp", "VK_LAYER_SYNCVAL_SHADER_ACCESSES_HEURISTIC": "true"}
    return subprocess.run([program, PROGRAMS, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          timeout=120, env=environment)


def patched(folder: Path, name: str) -> Path:
    """The program with the changes of NAME.patch."""
    source, program = folder / f"{name}.cpp", folder / name
    subprocess.run(["patch", "-s", "-o", source, FOLDER / "00_vulkan.cpp", FOLDER / f"{name}.patch"], check=True)
    subprocess.run(["c++", "-std=c++20", "-I", FOLDER, source, "-o", program, "-lvulkan", "-lglfw"], check=True)
    return program


def codes(said: str) -> list[str]:
    """The names of the rules that messages of the validation layer begin with."""
    return re.findall(r"\[ ?((?:VUID|SYNC|UNASSIGNED)[\w-]+) ?\]", said)


class Vulkan(FolderCase):
    def test_each_file_is_short_and_its_parts_are_quoted(self):
        for name, most in (("00_vulkan.cpp", 400), ("00_window.h", 150), ("00_timing.h", 60)):
            text = (FOLDER / name).read_text()
            self.assertLessEqual(len(text.splitlines()), most, name)
            for part in re.findall(r"// \[(\w+)\]", text):
                self.assertIn(f"<!-- quote: docs/minimal/{name}#{part} -->", PAGE)

    def test_the_picture_is_the_triangle_and_validation_is_silent(self):
        file = self.folder / "triangle.ppm"
        done = run(PROGRAMS / "00_vulkan", file)
        self.assertEqual((done.returncode, done.stdout), (0, ""))
        self.assert_triangles(file, lambda near, _: near if min(near) > 0 else BACKGROUND)

    def assert_triangles(self, file: Path, colour):
        """`colour` of a pixel follows from its weights in the triangle, and in one that stands on its head."""
        pixels = file.read_bytes()[-3 * SIDE * SIDE:]
        for y in range(SIDE):
            for x in range(SIDE):
                at = (x + 0.5) / SIDE * 2 - 1, (y + 0.5) / SIDE * 2 - 1
                near, far = weights(*at), weights(at[0], -at[1])
                if min(abs(min(near)), abs(min(far))) < 1e-3:
                    continue  # on an edge
                for i, expected in enumerate(colour(near, far)):
                    self.assertAlmostEqual(pixels[3 * (SIDE * y + x) + i], srgb(expected), delta=1.5, msg=f"pixel {x}, {y}")

    def test_the_gpu_is_timed_and_validation_is_silent(self):
        done = run(PROGRAMS / "00_vulkan", "time", 3)
        self.assertEqual(done.returncode, 0, done.stdout)
        median, low, high = map(float, re.fullmatch(r".*, 3 passes: median ([\d.]+) us, quartiles ([\d.]+) and ([\d.]+) us\n",
                                                    done.stdout).groups())
        self.assertTrue(0 < low <= median <= high, done.stdout)

    def test_the_depth_buffer_hides_what_is_farther_and_was_drawn_later(self):
        file = self.folder / "depth.ppm"
        done = run(patched(self.folder, "00_depth"), file)
        self.assertEqual((done.returncode, done.stdout), (0, ""))
        self.assert_triangles(file, lambda near, far: near if min(near) > 0 else (1, 1, 1) if min(far) > 0 else BACKGROUND)

    def test_the_window_shows_it_and_validation_is_silent(self):
        server = XServer()
        try:
            done = run(PROGRAMS / "00_vulkan", "window", 20, display=server.display)
        finally:
            server.close()
        self.assertEqual((done.returncode, done.stdout), (0, ""))

    def test_each_step_names_the_line_of_the_framework_that_does_it(self):
        paragraphs = re.findall(r"^In the course: (.*?)\n\n", PAGE, re.M | re.S)
        self.assertGreater(len(paragraphs), 10)
        found = 0
        for paragraph in paragraphs:
            files = [(ROOT / "docs" / path).resolve().read_text() for path in re.findall(r"\]\((\.\./common/[\w./]+)\)", paragraph)]
            self.assertTrue(files, paragraph)
            for code in re.findall(r"`([^`]+)`", paragraph):
                words = " ".join(code.split())
                if "(" in words and not words.startswith("pass."):
                    self.assertTrue(any(words in " ".join(text.split()) for text in files), f"{words} is not there: {paragraph}")
                    found += 1
        self.assertGreater(found, 10)

    def test_a_missing_shader_or_file_is_one_line(self):
        for arguments, words in (([], "usage"), (["/nowhere/x.ppm"], "/nowhere/x.ppm cannot be written")):
            done = run(PROGRAMS / "00_vulkan", *arguments)
            self.assertEqual(done.returncode, 1)
            self.assertRegex(done.stdout, f"^error: {words}[^\n]*\n$")

    def test_validation_names_each_mistake_of_the_broken_program(self):
        done = run(patched(self.folder, "00_broken"), self.folder / "broken.ppm")
        self.assertEqual(done.returncode, 1)
        found = codes(done.stdout)
        same = run(PROGRAMS / "00_vulkan", self.folder / "right.ppm")
        self.assertEqual(same.returncode, 0)
        named = set(codes(PAGE))
        self.assertGreaterEqual(len(named), 4)
        if "SYNC-HAZARD-READ-AFTER-WRITE" in found:  # the names of some rules change from release to release
            self.assertEqual(len(set(found) & named), len(set(found)), f"{set(found) - named} are not on the page")
        links = re.findall(r"#VUID-[\w-]+\)", done.stdout)  # newer layers name a rule there alone
        self.assertGreaterEqual(len(found) or len(links), 4, done.stdout)
