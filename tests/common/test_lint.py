"""The linters that take seconds: clang-format over the C++ and the GLSL, pyflakes over the Python."""
# Builds: nothing

import re
import shutil
import subprocess
import unittest

from build.format_tree import unformatted
from tree import ROOT, files

PYFLAKES = shutil.which("pyflakes3")


class Lint(unittest.TestCase):
    def test_clang_format(self):
        self.assertEqual([str(name) for name in unformatted()], [], "./course format mends them")

    @unittest.skipUnless(PYFLAKES, "pyflakes3 is not installed")
    def test_pyflakes(self):
        said = subprocess.run([PYFLAKES, *(name for name in files() if name.suffix == ".py")], cwd=ROOT, stdout=subprocess.PIPE, text=True).stdout
        found = [re.match(r"([^:]+):(\d+):", line) for line in said.splitlines()]
        self.assertEqual([one.string for one in found
                          if one and "# noqa" not in (ROOT / one[1]).read_text().splitlines()[int(one[2]) - 1]], [])
