"""What the build compiles for one chapter: for ./course check the core of common, its checks and its starters; for ./course run
common and the chapters that it builds on."""
# Builds: nothing

import re
import subprocess
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "common" / "course"))

from tree import BUILD, chapters  # noqa: E402

CORE = {"lightwalk", "lightwalk_check", "lightwalk_check_plain", "check_main"}
APP = {"lightwalk_app", "lightwalk_app_plain"}
# Chapters whose checks have a module, or another one's camera.
MORE = {"06_deferred": APP | {"lent_03_attenuation", "called_03_attenuation", "exercises_03_attenuation"},
        "07_mipmaps": APP | {"lent_07_mipmaps"}, "11_fractals": APP, "14_environment": APP,
        "15_terrain_water": {"check_15_terrain_water", "called_01_obj", "exercises_01_obj"},
        "18_playground": {"check_18_playground", "called_01_obj", "exercises_01_obj"}}
FIRST = 45  # compilations before the first picture


def compiled_for(program: str) -> list[str]:
    """The target of each object that a program is linked from."""
    said = subprocess.run(["ninja", "-C", str(BUILD), "-t", "commands", program], stdout=subprocess.PIPE, text=True, check=True)
    return [found[1] for line in said.stdout.splitlines() if (found := re.search(r" -o CMakeFiles/(\w+)\.dir/\S+\.o ", line))]


@unittest.skipUnless((BUILD / "build.ninja").exists(), "the build is not configured")
class CheckBuild(unittest.TestCase):
    def test_nothing_of_another_chapter_is_compiled(self):
        for chapter in chapters():
            own = {f"{part}_{chapter}" for part in ("checks", "trials", "exercises", "called")}
            compiled = compiled_for(f"check_{chapter}")
            self.assertTrue(compiled, chapter)
            self.assertEqual(set(compiled) - CORE - own - MORE.get(chapter, set()), set(), chapter)

    def test_the_core_is_a_third_of_common(self):
        self.assertLessEqual(sum(target in CORE for target in compiled_for("check_16_volume")), 14)

    def test_a_chapter_is_built_without_later_ones_and_without_checks(self):
        """Every earlier one is in it, used or not: any exercise may be named to --use."""
        before, counts = {"lightwalk", *APP}, {}
        for chapter in chapters():
            before |= {chapter, *(f"{part}_{chapter}" for part in ("chapter", "called", "lent", "exercises"))}
            compiled = compiled_for(chapter)
            self.assertEqual(set(compiled) - before, set(), chapter)
            counts[chapter[:2]] = len(compiled)
        print(f"compilations: {counts}")
        self.assertLessEqual(counts["01"], FIRST)


if __name__ == "__main__":
    unittest.main()
