"""The chapters draw with every knob at the ends of its range, in each of its choices, on and off.

LIGHTWALK_BUILD names the build folder where it is not build/ in the tree.
"""
import contextlib
import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "common/course"))

from rendering import Drawing  # noqa: E402

BUILD = Path(os.environ.get("LIGHTWALK_BUILD", ROOT / "build"))
CHAPTERS = sorted(path.name for path in (ROOT / "chapters").glob("[0-9][0-9]_*"))


def settings_of(knob) -> list[str]:
    """The values to try: as --set takes them."""
    if knob["type"] == "switch":
        return ["on", "off"]
    if "options" in knob:
        return knob["options"]
    if knob["name"] == "samples":
        return ["2", "7"]  # the end is 4,096 pictures
    count = len(knob["default"]) if isinstance(knob["default"], list) else 1
    return [",".join([str(int(end) if knob["type"] == "whole number" else end)] * count) for end in knob["range"]]


# What else is set with those that begin so. A window reads as many texels as its width's square: it refuses the default
# width. The others cost seconds by the product of several knobs, of which the rest is then small.
WITH = {"bloom.method=window": ["sigma_px=4"], "skin.sky_rays=1024": ["skin.sky_size=16"],
        "skin.map_size=4096": ["skin.sky_rays=1", "skin.method=gaussians_1", "shadow.method=none"],
        "skin.": ["skin.sky_rays=1"]}


def all_settings(setting: str) -> list[str]:
    """As options: others first, which `setting` may be one of."""
    others = next((others for begin, others in WITH.items() if setting.startswith(begin)), [])
    return [word for one in [*others, setting] for word in ("--set", one)]


@unittest.skipUnless((BUILD / "compare").exists() or "LIGHTWALK_BUILD" in os.environ, "the chapters are not built")
class KnobsTest(unittest.TestCase):
    def test_every_knob_at_its_ends(self):
        tried = set()  # modules: a knob is tried in the first chapter that has it
        for chapter in CHAPTERS:
            listed = subprocess.run([BUILD / "chapters" / chapter, "--list", "knobs", "--json"], capture_output=True, text=True,
                                    stdin=subprocess.DEVNULL, timeout=120, cwd=ROOT)
            knobs = [knob for knob in json.loads(listed.stdout) if knob["name"] not in tried]
            tried |= {knob["name"] for knob in knobs}
            settings = [f"{knob['name']}={value}" for knob in knobs for value in settings_of(knob)]
            self.assertTrue(settings, chapter)
            with tempfile.TemporaryDirectory() as folder, contextlib.ExitStack() as programs:
                drawing = None
                for number, setting in enumerate(settings):
                    if not drawing or not drawing.is_alive():
                        drawing = programs.enter_context(Drawing(chapter))
                    with self.subTest(chapter=chapter, set=setting):
                        said = drawing.draw([*all_settings(setting), "--size", "32x24"], Path(folder) / f"{number}.png")
                        self.assertEqual(said, (0, "", ""))


if __name__ == "__main__":
    unittest.main()
