"""What ./course check compiles for one chapter: the core of common, its checks and its starters."""
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


def compiled_for(chapter: str) -> list[str]:
    """The target of each object that the program of the chapter's checks is linked from."""
    said = subprocess.run(["ninja", "-C", str(BUILD), "-t", "commands", f"check_{chapter}"], stdout=subprocess.PIPE, text=True, check=True)
    return [found[1] for line in said.stdout.splitlines() if (found := re.search(r" -o CMakeFiles/(\w+)\.dir/\S+\.o ", line))]


@unittest.skipUnless((BUILD / "build.ninja").exists(), "the build is not configured")
class CheckBuild(unittest.TestCase):
    def test_nothing_of_another_chapter_is_compiled(self):
        for chapter in chapters():
            own = {f"{part}_{chapter}" for part in ("checks", "trials", "exercises", "called")}
            compiled = compiled_for(chapter)
            self.assertTrue(compiled, chapter)
            self.assertEqual(set(compiled) - CORE - own - MORE.get(chapter, set()), set(), chapter)

    def test_the_core_is_a_third_of_common(self):
        self.assertLessEqual(sum(target in CORE for target in compiled_for("16_volume")), 14)


if __name__ == "__main__":
    unittest.main()
