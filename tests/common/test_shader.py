"""Tests of ./course shader, and of how many files a shader needs."""

import re
import subprocess
import sys
import unittest
from pathlib import Path

from pages import docs
from check.glsl_answer import code_of
from pages.pages_markdown import Site, convert
from pages.shader import find_shader, macros_of, names, whole
from tree import ROOT, UsageError, has_solutions


def files_of(text: str) -> list[str]:
    return re.findall(r"^// ==== (\S+)$", text, re.M)


class Whole(unittest.TestCase):
    def test_each_part_stands_under_its_file_once_and_nothing_is_left_out(self):
        text = whole("05_shadow_maps/surface.frag")
        files = files_of(text)
        self.assertEqual(len(files), len(set(files)))
        self.assertEqual(files[0], "shaders/05_shadow_maps/surface.frag")
        self.assertNotRegex(text, r"(?m)^\s*#\s*include")
        for file in files:
            kept = [line for line in (ROOT / file).read_text().splitlines() if not re.match(r"\s*#\s*include", line)]
            rest = iter(text.splitlines())
            self.assertTrue(all(line in rest for line in kept), file)

    def test_a_part_that_goes_on_after_an_include_says_where(self):
        file, line = re.search(r"^// ==== (\S+), line (\d+) on\n", whole("05_shadow_maps/surface.frag"), re.M).groups()
        after = whole("05_shadow_maps/surface.frag").split(f"// ==== {file}, line {line} on\n", 1)[1].split("\n")[0]
        self.assertEqual((ROOT / file).read_text().splitlines()[int(line) - 1], after)

    def test_exercises_are_read_as_asked(self):
        self.assertIn("shaders/05_shadow_maps/exercise/pcf.glsl", files_of(whole("05_shadow_maps/pcf.glsl", "exercise")))
        folder = "solution" if has_solutions() else "exercise"
        self.assertIn(f"shaders/05_shadow_maps/{folder}/pcf.glsl", files_of(whole("05_shadow_maps/pcf.glsl")))

    def test_every_shader_can_be_printed(self):
        for name in names():
            self.assertIn(name.rsplit("/", 1)[1], files_of(whole(name))[0])

    def test_macros_are_those_of_the_compiler(self):
        self.assertEqual(macros_of({"name": "shadow.method", "type": "choice", "default": "pcf", "options": ["hard", "pcf"]}),
                         {"SHADOW_METHOD": 1, "SHADOW_METHOD_HARD": 0, "SHADOW_METHOD_PCF": 1})
        self.assertEqual(macros_of({"name": "ambient", "type": "switch", "default": True}), {"AMBIENT": 1})
        self.assertEqual(macros_of({"name": "maps.steps", "type": "integer", "default": 32.0}), {})


class Pages(unittest.TestCase):
    def test_a_lesson_links_to_the_whole_of_each_shader_that_it_quotes(self):
        site = Site()
        page = convert(site, Path("docs/03_attenuation.md"))
        quoted = set(re.findall(r"<!-- quote: (shaders/[^#]*)#", (ROOT / "docs/03_attenuation.md").read_text()))
        quoted = {name for name in quoted if "/exercise/" not in name}
        self.assertEqual({str(path) for path in site.wholes}, quoted)
        for path, target in site.wholes.items():
            self.assertIn(f"[the whole shader]({target})", page)
            self.assertIn(f"// ==== {path}", docs.whole_page(path))
            self.assertNotIn("/solution/", docs.whole_page(path))


class Names(unittest.TestCase):
    def test_a_name_is_a_path_or_what_only_one_file_has(self):
        for word in ("05_shadow_maps/pcf.glsl", "shaders/05_shadow_maps/pcf.glsl", "pcf.glsl", "05_shadow_maps/exercise/pcf.glsl"):
            self.assertEqual(find_shader(word), "05_shadow_maps/pcf.glsl")
        with self.assertRaisesRegex(UsageError, "shaders are called surface.frag: 04"):
            find_shader("surface.frag")
        self.assertEqual(find_shader("surface.frag", "05_shadow_maps"), "05_shadow_maps/surface.frag")

    def test_a_wrong_name_is_one_line_with_the_two_nearest_and_2(self):
        for word, expected in (("05_shadow_maps/surfac.frag", "05_shadow_maps/surface.frag"), ("schadow.glsl", "shadow.glsl")):
            done = subprocess.run([sys.executable, ROOT / "common/course/cli.py", "shader", word], capture_output=True, text=True)
            self.assertEqual((done.returncode, done.stdout, done.stderr.count("\n")), (2, "", 1))
            self.assertRegex(done.stderr, rf"no shader '{re.escape(word)}'; the nearest are .*{re.escape(expected)}.* and ")
        done = subprocess.run([sys.executable, ROOT / "common/course/cli.py", "shader", "05_shadow_maps/shadow.glsl", "--chapter", "03"],
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn("later chapter", done.stderr)


class Read(unittest.TestCase):
    def test_what_students_read_asks_for_no_macro_of_a_check(self):
        of_checks = {"FIELD", "COUNTED", "NO_PICTURE", "BALLS", "FIELD_WIDTH", "IMPULSE_X", "MOST_READS"}
        for path in (ROOT / "shaders").rglob("*.*"):
            words = set(re.findall(r"\w+", code_of(path.read_text())))
            self.assertFalse(words & of_checks or [word for word in words if word.startswith("KNOWN_")], path)
