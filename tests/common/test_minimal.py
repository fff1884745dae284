"""The smallest version of each chapter's method (docs/minimal): at most 60 lines that compile, run and are right, and that
the lesson shows whole. The shaders' functions are tested in tests/minimal and by test_minimal_numbers.py."""

import shutil
import subprocess
import unittest
from pathlib import Path

from folder_case import FolderCase
from tree import BUILD, ROOT, chapters

FOLDER = ROOT / "docs" / "minimal"
MOST_LINES = 60
CUBE = "".join(f"v {x} {y} {z}\n" for x in (0, 2) for y in (0, 2) for z in (0, 2)) + \
    "vn -1 0 0\nvn 1 0 0\nvn 0 -1 0\nvn 0 1 0\nvn 0 0 -1\nvn 0 0 1\n" + \
    "f 1//1 2//1 4//1 3//1\nf 5//2 7//2 8//2 6//2\nf 1//3 5//3 6//3 2//3\nf -6//4 -5//4 -1//4 -2//4\n" + \
    "f 1//5 3//5 7//5 5//5\nf 2//6 6//6 8//6 4//6\n"


def sources() -> list[Path]:
    """Those of chapters: 00 is longer (test_minimal_vulkan.py)."""
    return sorted(path for path in FOLDER.iterdir() if path.suffix in (".cpp", ".frag", ".comp") and path.name[:2] != "00")


def said(name: str, given: str = "") -> dict[str, float]:
    """A program's output: each word with the number behind it, later ones over earlier ones."""
    done = subprocess.run([BUILD / "minimal" / name], input=given, stdout=subprocess.PIPE, text=True, check=True, timeout=60)
    words = done.stdout.split()
    return {words[i]: float(words[i + 1]) for i in range(0, len(words), 2)}


class Minimal(FolderCase):
    def test_every_chapter_has_one_that_its_lesson_shows_whole(self):
        for chapter in chapters():
            with self.subTest(chapter):
                [own] = [path for path in sources() if path.stem == chapter]
                lesson = (ROOT / "docs" / f"{chapter}.md").read_text()
                self.assertIn(f"<!-- quote: docs/minimal/{own.name}#minimal -->", lesson)
                self.assertIn("\n".join(own.read_text().splitlines()[1:-1]), lesson)
                before = lesson[:lesson.index("<!-- quote: ")]
                self.assertIn("docs/minimal", lesson[len(before):len(before) + 40], "it is not the first code of the lesson")

    def test_a_file_has_at_most_60_lines_and_is_shown_from_the_first_to_the_last(self):
        for path in sources():
            with self.subTest(path.name):
                lines = path.read_text().splitlines()
                self.assertLessEqual(len(lines), MOST_LINES)
                self.assertEqual((lines[0], lines[-1]), ("// [minimal]", "// [/minimal]"))
                self.assertLessEqual(max(map(len, lines)), 120)

    @unittest.skipUnless(shutil.which("glslangValidator") and shutil.which("spirv-val"), "no compiler of GLSL here")
    def test_the_shaders_compile_to_valid_spirv(self):
        for path in sources():
            if path.suffix == ".cpp":
                continue
            with self.subTest(path.name):
                made = self.folder / "made.spv"
                for command in (["glslangValidator", "-V", "--target-env", "vulkan1.3", path, "-o", made],
                                ["spirv-val", "--target-env", "vulkan1.3", made]):
                    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
                    self.assertEqual(done.returncode, 0, done.stdout)

    def test_01_reads_a_cube(self):
        self.assertEqual(said("01_obj", CUBE), {"vertices": 24, "triangles": 12, "volume": 8})

    def test_06_deferred_is_forward_for_less(self):
        found = said("06_deferred")
        self.assertEqual(found["different"], 0)
        self.assertLess(10 * found["deferred"], found["forward"])
        self.assertGreater(found["deferred"], 50000)

    def test_19_a_path_passes_its_keys_evenly_and_upright(self):
        found = said("19_ambiance")
        self.assertLess(found["key"], 1e-9)
        self.assertLess(found["speed"], 1.02)
        self.assertAlmostEqual(found["up"], 1, 6)
