"""Tests of the order of the tree's parts (common/course/test/order.py) and of the variables in docs/development.md, on small trees of files."""
# Builds: nothing

import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "common" / "course"))

from test import order, text_check  # noqa: E402

FILES = {
    "common/base/text.h": "", "common/gpu/frame.h": '#include "common/base/text.h"\n#include "common/view.h"\n',
    "common/scene/scene.h": '#include "common/gpu/frame.h"\n#include <common/window/window.h>\n',
    "common/window/window.h": '#include "common/scene/scene.h"\n',
    "shaders/common/view.h": "", "shaders/common/view.glsl": '#include "common/view.h"\n',
    "shaders/01_obj/mesh.glsl": '#include "common/view.glsl"\n',
    "shaders/02_lambert/lit.frag": '#include "01_obj/mesh.glsl"\n#include "02_lambert/phong.glsl"\n',
    "chapters/01_obj/obj.h": '#include "common/scene/scene.h"\n',
    "chapters/02_lambert/main.cpp": '#include "01_obj/obj.h"\n// #include "03_later/x.h"\n',
    "tests/catch.h": "", "tests/common/fixture.h": '#include "catch.h"\n#include "common/scene/scene.h"\n',
    "tests/02_lambert/test_it.cpp": '#include "../common/fixture.h"\n#include "01_obj/obj.h"\n',
    "common/course/tree.py": "import os\n", "common/course/build/build.py": "from tree import ROOT\n",
    "common/course/test/needs.py": "from build.build import build\nfrom test.results import table\n",
    "common/course/cli.py": "from build.build import build\n    import test.needs\n",
}


class Order(unittest.TestCase):
    def wrong(self, **changed: str) -> list[str]:
        """Messages about the small tree with a file added or replaced."""
        with tempfile.TemporaryDirectory() as made:
            root = Path(made).resolve()
            for name, text in (FILES | changed).items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text)
            with mock.patch.object(order, "ROOT", root):
                return order.check_order(sorted(map(Path, FILES | changed)))

    def assert_wrong(self, name: str, text: str, *words: str):
        [said] = self.wrong(**{name: text})
        for word in words:
            self.assertIn(word, said)

    def test_what_is_in_order(self):
        self.assertEqual(self.wrong(), [])

    def test_rooms(self):
        self.assert_wrong("common/base/x.cpp", '\n#include "common/gpu/frame.h"\n', "common/base/x.cpp:2", "'common/gpu/frame.h'")
        self.assert_wrong("common/gpu/x.h", '# include  "common/scene/scene.h"\n', "common/gpu may not", "common/scene")
        self.assert_wrong("common/scene/x.h", '#include "../window/window.h"\n', "common/scene may not", "common/window")
        self.assert_wrong("common/window/x.h", '#include "01_obj/obj.h"\n', "common/window may not", "chapter 01")
        self.assert_wrong("common/attic/x.h", "", "common/attic", "not a room", "base, gpu, check, image, scene, app")

    def test_the_core_comes_first(self):
        self.assertEqual(" ".join(order.ROOMS), "base gpu check image scene app measure study judge window")

    def test_chapters(self):
        self.assert_wrong("chapters/01_obj/x.h", '#include "02_lambert/main.cpp"\n', "chapter 01 may not", "chapter 02")
        self.assert_wrong("chapters/02_lambert/x.h", '#include "tests/common/fixture.h"\n', "chapter 02 may not", "tests/common")
        self.assert_wrong("shaders/01_obj/x.glsl", '#include "02_lambert/phong.glsl"\n', "chapter 01 may not", "chapter 02")
        self.assert_wrong("shaders/common/x.glsl", '#include "01_obj/mesh.glsl"\n', "shaders/common may not", "chapter 01")
        self.assert_wrong("chapters/02_lambert/x.h", '#include "build/x.h"\n', "'build/x.h' leads to no part")

    def test_tests(self):
        self.assert_wrong("tests/common/x.cpp", '#include "01_obj/obj.h"\n', "tests/common may not", "chapter 01")
        self.assert_wrong("tests/01_obj/x.cpp", '#include "02_lambert/main.cpp"\n', "tests/01 may not", "chapter 02")
        self.assert_wrong("tests/01_obj/x.cpp", '#include "tests/02_lambert/test_it.cpp"\n', "tests/01 may not", "tests/02")

    def test_packages(self):
        self.assert_wrong("common/course/build/x.py", "import os\n    from test.needs import y\n", "x.py:2", "build may not import test")
        self.assert_wrong("common/course/tree.py", "import progress\n", "tree may not import progress")
        self.assert_wrong("common/course/attic/x.py", "", "common/course/attic", "not a package", "charts")


class Variables(unittest.TestCase):
    def wrong(self, readme: str) -> list[str]:
        # In two parts, so that this file reads none.
        files = {"a/x.cpp": f'std::getenv("{"LIGHTWALK"}_A"); // LIGHTWALK_COMMENT\n', "b.py": f"os.environ['{'LIGHTWALK'}_B']\n",
                 "docs/development.md": readme}
        with tempfile.TemporaryDirectory() as made:
            for name, text in files.items():
                Path(made, name).parent.mkdir(exist_ok=True)
                Path(made, name).write_text(text)
            with mock.patch.object(text_check, "ROOT", Path(made)), \
                    mock.patch.object(text_check, "files", lambda: [Path(name) for name in files]):
                return text_check.check_variables()

    def test_readme_names_what_is_read_and_nothing_else(self):
        self.assertEqual(self.wrong("| `LIGHTWALK_A` | x |\n| `LIGHTWALK_B` | y |"), [])
        self.assertEqual(self.wrong("| `LIGHTWALK_A` | x |\nand `LIGHTWALK_B`"), ["b.py: docs/development.md does not name LIGHTWALK_B"])
        self.assertEqual(self.wrong("".join(f"| `LIGHTWALK_{name}` | x |\n" for name in "ABC")), ["docs/development.md: nothing reads LIGHTWALK_C"])


if __name__ == "__main__":
    unittest.main()
