"""Tests of ./course handout: what students are given holds no answer, and whatever it includes is in it."""

import unittest
from pathlib import Path
from unittest import mock

from graded_class import REAL
from grading import handout

GUARDED = "__has_include"  # a file that asks first can do without


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


if __name__ == "__main__":
    unittest.main()
