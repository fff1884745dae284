"""What the build compiles for ./course run of one chapter: common and the chapters that it includes."""
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

FIRST = 45  # compilations before the first picture


def compiled_for(program: str) -> list[str]:
    """The target of each object that a program is linked from."""
    said = subprocess.run(["ninja", "-C", str(BUILD), "-t", "commands", program], stdout=subprocess.PIPE, text=True, check=True)
    return [found[1] for line in said.stdout.splitlines() if (found := re.search(r" -o CMakeFiles/(\w+)\.dir/\S+\.o ", line))]


@unittest.skipUnless((BUILD / "build.ninja").exists(), "the build is not configured")
class CheckBuild(unittest.TestCase):
    def test_a_chapter_is_built_with_what_it_includes_and_without_checks(self):
        counts = {}
        for chapter in chapters():
            parts = {f"{part}_{name}" for name in {chapter} | used(chapter) for part in ("chapter", "exercises")}
            compiled = compiled_for(chapter)
            self.assertEqual(set(compiled) - {"lightwalk", chapter} - parts, set(), chapter)
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
                (build / "chapters.links").write_text("01_a\n02_b\n03_c 02_b\n")
                self.assertTrue(is_configured(build))


if __name__ == "__main__":
    unittest.main()
