"""What the build compiles for one chapter: for ./course check the core of common, its checks and its starters; for ./course run
common and the chapters that it includes."""
# Builds: nothing

import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "common" / "course"))

from build.build import is_configured, used  # noqa: E402
from tree import BUILD, chapters  # noqa: E402

CORE = {"lightwalk", "lightwalk_check", "lightwalk_check_plain", "check_main"}
APP = {"lightwalk_app", "lightwalk_app_once", "lightwalk_app_plain"}
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

    def test_a_chapter_is_built_with_what_it_includes_and_without_checks(self):
        counts = {}
        for chapter in chapters():
            parts = {f"{part}_{name}" for name in {chapter} | used(chapter) for part in ("chapter", "called", "lent", "exercises")}
            compiled = compiled_for(chapter)
            self.assertEqual(set(compiled) - {"lightwalk", *APP, chapter} - parts, set(), chapter)
            counts[chapter[:2]] = len(compiled)
        print(f"compilations: {counts}")
        self.assertLessEqual(counts["01"], FIRST)
        self.assertLess(counts["16"], counts["15"])
        self.assertLess(counts["17"], counts["15"])

    def test_a_new_include_is_seen(self):
        with tempfile.TemporaryDirectory() as made:
            root, build = Path(made) / "course", Path(made) / "build"
            for name in ("01_a", "02_b", "03_c"):
                (root / "chapters" / name).mkdir(parents=True)
                (root / "chapters" / name / "main.cpp").write_text('#include "common/window/run.h"\n')
            for name in ("build.ninja", "CMakeFiles/rules.ninja", "CMakeCache.txt"):
                (build / name).parent.mkdir(parents=True, exist_ok=True)
                (build / name).write_text(f"# CMAKE_HOME_DIRECTORY:INTERNAL={root}\n")
            with mock.patch.multiple("build.build", ROOT=root, chapters=lambda: ["01_a", "02_b", "03_c"]):
                self.assertTrue(is_configured(build))
                (root / "chapters" / "03_c" / "main.cpp").write_text('#include "02_b/b.h"\n')
                self.assertFalse(is_configured(build))
                (build / "visible" / "03_c" / "02_b").mkdir(parents=True)
                self.assertTrue(is_configured(build))


if __name__ == "__main__":
    unittest.main()
