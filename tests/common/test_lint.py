"""The linters that Debian packages: clang-format and pyflakes over the tree, clang-tidy (.clang-tidy) over the C++ of common and of
the chapters."""
# Builds: nothing

import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "common/course"))
from build.format_tree import unformatted  # noqa: E402
from tree import BUILD, files  # noqa: E402

PYFLAKES, TIDY, DATABASE = shutil.which("pyflakes3"), shutil.which("clang-tidy"), BUILD / "compile_commands.json"
# Options that GCC alone has, and the one that makes errors of clang's own warnings.
OF_GCC = re.compile(r"-Werror|-Winvalid-pch|-munroll-only-small-loops|-mvzeroupper|-Wno-(restrict|stringop-overflow|array-bounds)|ggc-.*|--param")


def changed() -> set[str]:
    """C++ sources of the last commit and since, from the root."""
    said = subprocess.run(["git", "diff", "--name-only", "--diff-filter=d", "HEAD~1"], cwd=ROOT, stdout=subprocess.PIPE,
                          stderr=subprocess.DEVNULL, text=True).stdout
    return {name for name in said.splitlines() if name.endswith(".cpp")}


def commands() -> list[dict]:
    """The compile commands of common and the chapters as clang takes them, one for each file."""
    found = {}
    for entry in json.loads(DATABASE.read_text()):
        file = Path(entry["file"])
        inside = file.is_relative_to(ROOT) and file.relative_to(ROOT).parts[0] in ("common", "chapters")
        if not inside or {"exercise", "solution"} & set(file.parts):
            continue
        words = [word for word in shlex.split(entry["command"]) if not OF_GCC.fullmatch(word)]
        while "-include" in words:  # GCC's precompiled header
            at = words.index("-include")
            del words[at:at + 2]
        found[str(file.relative_to(ROOT))] = {"directory": entry["directory"], "file": str(file), "arguments": words}
    return [found[name] for name in sorted(found)]


class Lint(unittest.TestCase):
    def test_clang_format(self):
        self.assertEqual([str(name) for name in unformatted()], [], "./course format mends them")

    @unittest.skipUnless(PYFLAKES, "pyflakes3 is not installed")
    def test_pyflakes(self):
        said = subprocess.run([PYFLAKES, *(name for name in files() if name.suffix == ".py")], cwd=ROOT, stdout=subprocess.PIPE, text=True).stdout
        found = [re.match(r"([^:]+):(\d+):", line) for line in said.splitlines()]
        self.assertEqual([one.string for one in found
                          if one and "# noqa" not in (ROOT / one[1]).read_text().splitlines()[int(one[2]) - 1]], [])

    @unittest.skipUnless(TIDY and DATABASE.exists(), "clang-tidy is not installed, or the build is not configured")
    def test_clang_tidy(self):
        entries = commands()
        self.assertGreater(len(entries), 200)
        if os.environ.get("LIGHTWALK_TESTS") == "part":
            names = changed()
            entries = [entry for entry in entries if str(Path(entry["file"]).relative_to(ROOT)) in names]
        with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(os.cpu_count() or 1) as pool:
            Path(folder, "compile_commands.json").write_text(json.dumps(entries))

            def said(entry: dict) -> str:
                done = subprocess.run([TIDY, "-p", folder, "--quiet", entry["file"]], cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                                      text=True)
                return done.stdout.strip()
            self.assertEqual([one for one in pool.map(said, entries) if one], [])


if __name__ == "__main__":
    unittest.main()
