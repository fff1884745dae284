"""Tests of ./course handout: it contains no truth, no reference, and all included files. test_leaks.py looks for answers elsewhere."""

import subprocess
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from folder_case import FolderCase
from graded_class import REAL  # first: it finds the packages
from check.starters import LIST, digest
from grading import handout
from tree import UsageError, walk

GUARDED = "__has_include"  # a file that asks first can do without


class Folder(FolderCase):
    def test_an_empty_folder_stays_and_is_filled(self):
        """Somebody works in it, another disc begins there, or a link leads to it."""
        (self.folder / "there").mkdir()
        (self.folder / "link").symlink_to("there")
        (self.folder / "new").symlink_to("elsewhere")
        for name, place in (("link", "there"), ("new", "elsewhere"), ("plain", "plain")):
            with self.subTest(name):
                at = (self.folder / place).stat().st_ino if (self.folder / place).exists() else None
                with handout.new_folder(self.folder / name) as beside:
                    (beside / "docs").mkdir()
                    (beside / "docs/one").write_text("1")
                self.assertEqual([str(path) for path in walk(self.folder / place)], ["docs/one"])
                self.assertIn((self.folder / place).stat().st_ino, (at, at or (self.folder / place).stat().st_ino))
        self.assertTrue((self.folder / "link").is_symlink() and (self.folder / "new").is_symlink())
        (self.folder / "round").symlink_to("round")
        for name in ("round", "plain"):
            with self.assertRaisesRegex(UsageError, "exists; name a folder that does not"), handout.new_folder(self.folder / name):
                pass
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["elsewhere", "link", "new", "plain", "round", "there"])


class Handout(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with mock.patch("grading.handout.objects", lambda names: {name: b"" for name in names}):
            cls.contents = handout.what_is_handed_out(sources=False)

    def test_it_has_no_truth_and_no_reference(self):
        for name in self.contents:
            with self.subTest(str(name)):
                self.assertNotIn("solution", name.parts)
                self.assertFalse(name.parts[0] == "chapters" and name.name.endswith("truth.h"))
        for name in ("chapters/05_shadow_maps/ray_truth.h", "chapters/09_post_effects/tone_truth.h"):
            self.assertTrue((REAL / name).exists())
            self.assertNotIn(Path(name), self.contents)

    def test_each_source_that_is_compiled_has_a_command(self):
        """In this build, whether or not it compiles several together."""
        commands = handout.compiled_by()
        hidden = [name for name in handout.tracked() if any(name.match(pattern) for pattern in handout.COMPILED)]
        self.assertGreater(len(hidden), 30)
        self.assertEqual([str(name) for name in hidden if REAL / name not in commands], [])

    def test_what_is_right_cannot_be_called(self):
        """A student's file that is linked with a check finds no function of the truth in it, nor a second time what all
        objects share (kind u): outside of its group it would be a definition of its own."""
        name = Path("tests/16_volume/checks_exercises.cpp")
        with tempfile.NamedTemporaryFile(suffix=".o") as file:
            file.write(handout.objects([name])[name])
            file.flush()
            said = subprocess.run(["nm", file.name], stdout=subprocess.PIPE, text=True, check=True).stdout
        kinds = {line.split()[-2] for line in said.splitlines() if handout.TRUTH in line}
        self.assertTrue(kinds <= {"t", "r", "b", "d"}, kinds)
        self.assertIn("RegisterCheck", said)
        self.assertEqual([line for line in said.splitlines() if line.split()[-2] == "u"], [])

    def test_it_says_what_is_handed_out_as_starters(self):
        listed = dict(reversed(line.split()) for line in self.contents[LIST].decode().splitlines())
        starters = [name for name in self.contents if "exercise" in name.parts[:-1]]
        self.assertEqual(sorted(listed), sorted(name.as_posix() for name in starters))
        for name in starters:
            source = self.contents[name]
            self.assertEqual(listed[name.as_posix()], digest(source if isinstance(source, bytes) else source.read_bytes()), name)

    def test_what_it_includes_is_in_it(self):
        for name in self.contents:
            if name.suffix not in (".cpp", ".h") or name.parts[0] not in ("chapters", "common", "tests"):
                continue
            text = (REAL / name).read_text()
            for said, meant in ((one, handout.meant_by(name, one)) for one in handout.includes(text)):
                if not any((REAL / one).exists() for one in meant) or f'{GUARDED}("{said}")' in text:
                    continue  # a library's, or one that can lack
                with self.subTest(str(name)):
                    self.assertTrue(meant & set(self.contents), said)
