#!/usr/bin/env python3
# Builds: 01_obj 03_attenuation 04_surface_maps 05_shadow_maps 08_bloom 09_post_effects 12_skin 13_mlaa 15_terrain_water
"""Tests of README: its length, its pictures, its titles, and the numbers in its table, which equal the knobs' choices."""

import json
import os
import re
import subprocess
import sys
import unittest
import zlib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "common/course"))
from PIL import Image  # noqa: E402

from tree import chapter_title, chapters, find_chapter  # noqa: E402

BUILD = Path(os.environ.get("LIGHTWALK_BUILD", ROOT / "build"))
README = (ROOT / "README.md").read_text(encoding="utf-8")
NUMBERS = "one two three four five six seven eight nine ten eleven twelve".split()
# (chapter, counted noun, the knob, and choices that do not count)
COUNTED = (("01", "loaders", "loader", ()), ("03", "ways", "lights.method", ()), ("04", "methods", "maps.method", ()),
           ("05", "filters", "shadow.method", ("none",)), ("08", "blurs", "bloom.method", ("none", "copy", "exact")),
           ("09", "tone curves", "post.tone", ("off",)), ("12", "methods", "skin.method", ()), ("13", "methods", "mlaa.method", ("none",)),
           ("15", "methods", "transparency.method", ()))


def row(number: str) -> str:
    return next(line for line in README.splitlines() if line.startswith("| [![](") and f"front/{number}.jpg" in line)


def stored(file: Path) -> int:
    """Bytes of a file as git stores it: deflated, but for formats that cannot become smaller."""
    if file.suffix in (".png", ".jpg", ".webp", ".ogg"):
        return file.stat().st_size
    return len(zlib.compress(file.read_bytes(), 6))


class FirstScreen(unittest.TestCase):
    def test_it_is_short(self):
        self.assertLessEqual(len(README.split()), 900)

    def test_a_sentence_a_picture_and_two_commands_come_first(self):
        before = README[:README.index("## Why this one?")]
        self.assertRegex(before, r"\A# Lightwalk\n\n[^#\[]+\n\n\[!\[[^\]]+\]\(docs/images/front/best\.jpg\)\]")
        self.assertEqual(re.findall(r"^    (\./course \w+)$", before, re.M), ["./course run", "./course test"])
        self.assertEqual(len(set(re.findall(r"front/lesson_\d\d\.jpg\)[^\]]*\]\(docs/(\d\d_\w+)\.md\)", before))), 6)
        with Image.open(ROOT / "docs/images/front/best.jpg") as picture:
            self.assertEqual(picture.size, (960, 540))
        self.assertRegex(before, r"(?s)\d+ s\b.*\d+ min", "measured times")

    def test_each_chapter_has_a_picture_and_its_title(self):
        for chapter in chapters():
            self.assertIn(f"[{chapter_title(chapter)}](docs/{chapter}.md)", row(chapter[:2]))
            with Image.open(ROOT / f"docs/images/front/{chapter[:2]}.jpg") as picture:
                self.assertEqual(picture.size, (160, 90))

    def test_a_shallow_clone_is_as_small_as_it_says(self):
        listed = subprocess.run(["git", "-C", ROOT, "ls-files", "-z"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        if listed.returncode:
            self.skipTest("a copy without git")
        files = [ROOT / os.fsdecode(name) for name in listed.stdout.split(b"\0") if name]
        deflated = sum(stored(file) for file in files if file.is_file()) / 1e6
        self.assertLess(deflated, 92)  # a clone packs like files together, and is smaller
        [said] = re.findall(r"`--depth 1` takes (\d+) MB", README)
        self.assertLess(abs(deflated - int(said)), 5)

    def test_it_counts_what_the_knobs_have(self):
        for number, what, knob, others in COUNTED:
            with self.subTest(number):
                said = re.search(rf"({'|'.join(NUMBERS)}) (?:\w+ )?{what}", row(number), re.I)
                self.assertTrue(said, row(number))
                program = BUILD / "chapters" / find_chapter(number)
                listed = json.loads(subprocess.run([program, "--list", "knobs", "--json"], check=True, text=True,
                                                   stdout=subprocess.PIPE).stdout)
                listed = listed["knobs"] if isinstance(listed, dict) else listed
                choices = next(one["options"] for one in listed if one["name"] == knob or one["name"].endswith("." + knob))
                self.assertEqual(NUMBERS.index(said[1].lower()) + 1, len(set(choices) - set(others)), choices)

    def test_the_undo_of_18_has_the_bound_of_its_code(self):
        [megabytes] = re.findall(r"undo keeps (\d+) MB", row("18"))
        code = "".join(path.read_text() for path in (ROOT / "chapters/18_playground").glob("*.h"))
        self.assertRegex(code, rf"\b{megabytes}\)? << 20|\b{megabytes}[' ]?000[' ]?000\b|{float(megabytes) * 1e6:.0e}")


if __name__ == "__main__":
    unittest.main()
