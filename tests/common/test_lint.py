"""The linters that take seconds: clang-format over the C++ and the GLSL, Clang over common's headers, pyflakes over the Python."""
# Builds: nothing

import ast
import json
import re
import shlex
import shutil
import subprocess
import unittest

from build.format_tree import unformatted
from tree import BUILD, ROOT, files

CLANG, DATABASE, PYFLAKES = shutil.which("clang++"), BUILD / "compile_commands.json", shutil.which("pyflakes3")


class Lint(unittest.TestCase):
    def test_clang_format(self):
        self.assertEqual([str(name) for name in unformatted()], [], "./course format mends them")

    @unittest.skipUnless(CLANG and DATABASE.exists(), "there is no clang, or the build is not configured")
    def test_clang_reads_the_headers(self):
        """./course fuzz compiles with it, and Debian 12's Clang 14 lacks parts of C++20."""
        words = shlex.split(next(entry["command"] for entry in json.loads(DATABASE.read_text()) if "/lightwalk.dir/" in entry["command"]))
        options = [word for before, word in zip(words, words[1:]) if word.startswith(("-D", "-I", "-std=", "-isystem")) or before == "-isystem"]
        headers = "".join(f'#include "{name}"\n' for name in files() if name.suffix == ".h" and name.parts[0] == "common")
        said = subprocess.run([CLANG, *options, "-fsyntax-only", "-x", "c++", "-"], input=headers, cwd=ROOT,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True).stdout
        self.assertEqual(re.findall(r".*error: .*", said), [])

    @unittest.skipUnless(PYFLAKES, "pyflakes3 is not installed")
    def test_pyflakes(self):
        said = subprocess.run([PYFLAKES, *(name for name in files() if name.suffix == ".py")], cwd=ROOT, stdout=subprocess.PIPE, text=True).stdout
        found = [re.match(r"([^:]+):(\d+):", line) for line in said.splitlines()]
        self.assertEqual([one.string for one in found
                          if one and "# noqa" not in (ROOT / one[1]).read_text().splitlines()[int(one[2]) - 1]], [])

    def test_text_has_an_encoding(self):
        """The locale's would be another on another machine."""
        found = []
        for name in files():
            if name.suffix == ".py" and name.parts[:2] == ("common", "course"):
                found += [f"{name}:{call.lineno}: {ast.unparse(call)[:80]}" for call in ast.walk(ast.parse((ROOT / name).read_text(encoding="utf-8")))
                          if isinstance(call, ast.Call) and (reads_text(call) or hears_text(call))]
        self.assertEqual(found, [], 'encoding="utf-8" is missing, or errors="replace" of what another program says')


def hears_text(call: ast.Call) -> bool:
    """Whether a program's output that is no UTF-8 ends ours with a traceback."""
    given = {keyword.arg: ast.unparse(keyword.value) for keyword in call.keywords}
    return given.get("text") == "True" and "errors" not in given


def reads_text(call: ast.Call) -> bool:
    """Whether a call opens, reads or writes text in the encoding of the locale."""
    name = ast.unparse(call.func)
    words = {keyword.arg for keyword in call.keywords}
    if words & {"encoding", None}:
        return False
    if name.endswith((".read_text", ".write_text")):
        return len(call.args) < (2 if name.endswith("write_text") else 1)
    if name not in ("open", "os.fdopen", "tempfile.TemporaryFile", "tempfile.NamedTemporaryFile") and not name.endswith("Path.open"):
        return False
    at = 0 if "emporary" in name else 1
    given = call.args[at] if len(call.args) > at else next((word.value for word in call.keywords if word.arg == "mode"), None)
    mode = given.value if isinstance(given, ast.Constant) else "b" if given or "emporary" in name else "r"
    return "b" not in str(mode)
