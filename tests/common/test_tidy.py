"""clang-tidy (.clang-tidy) over the C++ of common and of the chapters, exercises and solutions aside."""
# Builds: nothing

import json
import os
import re
import shlex
import shutil
import subprocess
import tempfile
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from tree import BUILD, ROOT

TIDY, DATABASE = shutil.which("clang-tidy"), BUILD / "compile_commands.json"
# Options that GCC alone has, and the one that makes errors of clang's own warnings.
OF_GCC = re.compile(r"-Werror|-Winvalid-pch|-munroll-only-small-loops|-mvzeroupper|-Wno-(restrict|stringop-overflow|array-bounds)|ggc-.*|--param")
OF_UNITY = ["--checks=-bugprone-suspicious-include", r"--header-filter=\.cpp$"]  # it includes sources, and these are read
INCLUDED = re.compile(r'^#include "([^"]+)"', re.M)


def sources(file: Path) -> set[Path]:
    """The sources in common and the chapters that a compiled file consists of: a unity file includes them."""
    names = INCLUDED.findall(file.read_text()) if file.name.startswith("unity_") else [file]
    return {path for path in map(Path, names) if not {"exercise", "solution"} & set(path.parts)
            and path.is_relative_to(ROOT) and path.relative_to(ROOT).parts[0] in ("common", "chapters")}


def commands() -> tuple[list[dict], set[Path]]:
    """Compile commands for all sources of common and the chapters, as clang takes them, and these sources."""
    found, read = [], set()
    for entry in json.loads(DATABASE.read_text()):
        if sources(Path(entry["file"])) <= read:  # another target compiles them, too
            continue
        read |= sources(Path(entry["file"]))
        words = [word for word in shlex.split(entry["command"]) if not OF_GCC.fullmatch(word)]
        while "-include" in words:  # GCC's precompiled header
            at = words.index("-include")
            del words[at:at + 2]
        found.append({"directory": entry["directory"], "file": entry["file"], "arguments": words})
    return found, read


def complaints(entries: list[dict]) -> list[str]:
    """What clang-tidy says of each file that it finds wrong."""
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        Path(folder, "compile_commands.json").write_text(json.dumps(entries))

        def said(entry: dict) -> str:
            done = subprocess.run([TIDY, "-p", folder, "--quiet", f"--config-file={ROOT / '.clang-tidy'}", *OF_UNITY, entry["file"]],
                                  cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
            return done.stdout.strip()
        return [one for one in pool.map(said, entries) if one]


@unittest.skipUnless(TIDY and DATABASE.exists(), "clang-tidy is not installed, or the build is not configured")
class Tidy(unittest.TestCase):
    def test_every_file(self):
        entries, read = commands()
        there = {path for folder in ("common", "chapters") for path in (ROOT / folder).rglob("*.cpp")}
        self.assertEqual([path for path in sorted(there - read) if not {"exercise", "solution"} & set(path.parts)], [])
        self.assertEqual(complaints(entries), [])
