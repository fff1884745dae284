"""The program of docs/descriptors.md: every way gives the right picture with validation silent, and is timed."""

import json
import os
import re
import subprocess

from folder_case import FolderCase
from tree import BUILD, ROOT

# Builds: minimal_00_descriptors
FOLDER = ROOT / "docs" / "minimal"
PAGE = (ROOT / "docs" / "descriptors.md").read_text(encoding="utf-8")
WAYS = ("set written per draw", "push descriptor", "set per texture", "set per texture, sorted", "layers, dynamic offset",
        "layers, indirect", "table, push constant", "table, indirect")


def run(*arguments) -> subprocess.CompletedProcess:
    environment = os.environ | {"VK_INSTANCE_LAYERS": "VK_LAYER_KHRONOS_validation"}
    return subprocess.run([BUILD / "minimal" / "00_descriptors", *map(str, arguments)], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, timeout=120, env=environment)


class Descriptors(FolderCase):
    def test_each_way_draws_the_picture_and_is_timed_and_validation_is_silent(self):
        file = self.folder / "times.json"
        done = run(BUILD / "minimal", 2500, 3, file)
        self.assertEqual(done.returncode, 0, done.stdout)
        lines = done.stdout.splitlines()
        self.assertEqual(len(lines), 2 + len(WAYS), done.stdout)
        self.assertIn(", 2500 draws, 1024 textures, 3 rounds, load ", lines[0].replace(";", ","))
        points = json.loads(file.read_text())["points"]
        self.assertEqual([point["method"] for point in points], list(WAYS))
        for point, line in zip(points, lines[2:]):
            self.assertTrue(line.startswith(point["method"]), line)
            if len(point) == 1:
                self.assertIn("not on this device", line)
                self.assertRegex(point["method"], "^(push|table)")
            for key in ("record_ms", "wait_ms", "gpu_ms")[:len(point) - 1]:
                self.assertTrue(0 < point[key]["q1"] <= point[key]["median"] <= point[key]["q3"], point)

    def test_a_missing_shader_or_file_is_one_line(self):
        for arguments, words in (([], "usage"), (["/nowhere"], "no shader /nowhere/00_descriptors.vert.spv"),
                                 ([BUILD / "minimal", 1, 1, "/nowhere/x"], "/nowhere/x cannot be written")):
            done = run(*arguments)
            self.assertEqual(done.returncode, 1)
            self.assertRegex(done.stdout, f"^error: {words}[^\n]*\n$")

    def test_files_are_short_and_their_parts_are_quoted(self):
        for name, most in (("00_descriptors.cpp", 300), ("00_ranges.h", 60), ("00_descriptors.frag", 40)):
            text = (FOLDER / name).read_text()
            self.assertLessEqual(len(text.splitlines()), most, name)
            for part in re.findall(r"// \[(\w+)\]", text):
                self.assertIn(f"<!-- quote: docs/minimal/{name}#{part} -->", PAGE)
