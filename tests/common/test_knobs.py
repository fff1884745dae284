"""The chapters draw with every knob at the ends of its range, in each of its choices, on and off.

LIGHTWALK_BUILD names the build folder where it is not build/ in the tree.
"""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(os.environ.get("LIGHTWALK_BUILD", ROOT / "build"))
CHAPTERS = sorted(path.name for path in (ROOT / "chapters").glob("[0-9][0-9]_*"))


def settings(knob) -> list[str]:
    """The values to try: as --set takes them."""
    if knob["type"] == "switch":
        return ["on", "off"]
    if "options" in knob:
        return knob["options"]
    if knob["name"] == "samples":
        return ["2", "7"]  # the end is 4,096 pictures
    count = len(knob["default"]) if isinstance(knob["default"], list) else 1
    return [",".join([str(int(end) if knob["type"] == "whole number" else end)] * count) for end in knob["range"]]


# A window reads as many texels as its width's square: it refuses the default width.
WITH = {"bloom.method=window": ["--set", "sigma_px=4"]}


@unittest.skipUnless((BUILD / "compare").exists() or "LIGHTWALK_BUILD" in os.environ, "the chapters are not built")
class KnobsTest(unittest.TestCase):
    def run_chapter(self, chapter, *arguments):
        return subprocess.run([BUILD / "chapters" / chapter, *map(str, arguments)], capture_output=True, text=True,
                              stdin=subprocess.DEVNULL, timeout=120, cwd=ROOT)

    def test_every_knob_at_its_ends(self):
        tried = set()  # modules: a knob is tried in the first chapter that has it
        for chapter in CHAPTERS:
            knobs = json.loads(self.run_chapter(chapter, "--list", "knobs", "--json").stdout)
            self.assertTrue(knobs, chapter)
            for knob in knobs:
                if knob["name"] in tried:
                    continue
                tried.add(knob["name"])
                for value in settings(knob):
                    with self.subTest(chapter=chapter, set=f"{knob['name']}={value}"), \
                            tempfile.TemporaryDirectory() as folder:
                        picture = pathlib.Path(folder) / "picture.png"
                        done = self.run_chapter(chapter, "--set", f"{knob['name']}={value}", *WITH.get(f"{knob['name']}={value}", []),
                                                "--size", "32x24", "--validate", "on", "--screenshot", picture)
                        self.assertEqual((done.returncode, done.stderr), (0, ""))
                        self.assertTrue(picture.exists())


if __name__ == "__main__":
    unittest.main()
