"""Shared by the tests of wrong input: a folder of their own, and a program that must refuse its input.

LIGHTWALK_BUILD names the build folder, by default build/ in the tree.
"""
import io
import os
import re
import subprocess
import unittest

from PIL import Image

from folder_case import FolderCase
from tree import BUILD, ROOT

CHAPTERS = {"01": BUILD / "chapters" / "01_obj", "02": BUILD / "chapters" / "02_lambert_phong",
            "04": BUILD / "chapters" / "04_surface_maps", "14": BUILD / "chapters" / "14_environment",
            "15": BUILD / "chapters" / "15_terrain_water"}
TIMEOUT_S = 120  # under a sanitizer; without one a run takes a second


def png(size=(64, 64), mode="RGB") -> bytes:
    return encoded(size, "PNG", mode)


def encoded(size, kind, mode="RGB") -> bytes:
    """A picture with enough in it that half of its bytes are not all of it."""
    image = Image.frombytes("RGB", size, bytes((x * x * 31 + x * 7) % 251 for x in range(3 * size[0] * size[1])))
    out = io.BytesIO()
    image.convert(mode).save(out, kind)
    return out.getvalue()


def radiance(width=64, height=8) -> bytes:
    """A run-length coded .hdr."""
    row = bytes([2, 2, width >> 8, width & 255]) + 4 * (bytes([width]) + bytes(range(100, 100 + width)))
    return b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y %d +X %d\n" % (height, width) + height * row


@unittest.skipUnless(CHAPTERS["02"].exists() or "LIGHTWALK_BUILD" in os.environ, "the chapters are not built")
class BadInput(FolderCase):
    def setUp(self):
        self.picture = self.folder / "picture.png"

    def run_program(self, program, *arguments, **environment):
        return subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, errors="replace",
                              stdin=subprocess.DEVNULL, timeout=TIMEOUT_S, cwd=ROOT, env=os.environ | environment)

    def refuse(self, program, *arguments, code=2, says="", **environment):
        """Runs it and asserts its exit code, its one line, and that no file is there that was not before.

        A shader's errors (exit code 1) are a line each, and the line of the source that is meant, indented.
        """
        with self.subTest(program=program.name, arguments=[str(a) for a in arguments], **environment):
            before = sorted(self.folder.rglob("*"))
            done = self.run_program(program, *arguments, **environment)
            lines = done.stderr.splitlines()
            if code == 1:
                lines[1:] = [line for line in lines[1:] if not re.match(r"    |shaders/\S+:\d+: ", line)]
            self.assertEqual(done.returncode, code, done.stderr)
            self.assertEqual(done.stdout, "")
            self.assertEqual(len(lines), 1, done.stderr)
            self.assertTrue(lines[0].startswith("error: "), done.stderr)
            self.assertGreater(len(lines[0]), 20, done.stderr)
            if says:
                self.assertRegex(lines[0], says)
            self.assertEqual(sorted(self.folder.rglob("*")), before)

    def draw(self, chapter, *arguments, **expected):
        """Refuses a picture of 64x48 that these options ask for."""
        self.refuse(CHAPTERS[chapter], "--size", "64x48", "--screenshot", self.picture, *arguments, **expected)
