"""Selected tests, and the targets that they need: a run of a few tests builds nothing else.

tests/build.cmake writes BUILD/tests.needs: a line "TEST TARGET..." for each test that does not need everything.
"""

import re
import subprocess
from pathlib import Path

from build.build import build
from tree import Failure

TEST = re.compile(r"^ *Test +#(\d+): (\S+)", re.M)
NOTHING = ["build.ninja"]  # a target for CMake alone, which runs where a file of the build changed


def selected(folder: Path, selection: list[str]) -> list[tuple[str, str]]:
    """(number, name) of each test that ctest's options select."""
    done = subprocess.run(["ctest", "--test-dir", str(folder), "-N", *selection], stdin=subprocess.DEVNULL, text=True, errors="replace",
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if done.returncode:
        raise Failure(f"ctest cannot list the tests: {done.stdout.strip()[-300:]}")
    return TEST.findall(done.stdout)


def targets(folder: Path, tests: list[str]) -> list[str]:
    needs = {words[0]: words[1:] for words in map(str.split, (folder / "tests.needs").read_text(encoding="utf-8").splitlines())}
    return sorted({target for test in tests for target in needs.get(test, ["all"])}) or NOTHING


def build_for(selection: list[str], shard_options, preset: str = "default", also: list[str] = ()) -> tuple[Path, list[str]]:
    """Builds the programs of the selected tests, limited to those that shard_options(folder, selection) leaves, and
    `also`. Returns the build's folder and ctest's options."""
    folder = build(NOTHING, preset)
    options = selection + shard_options(folder, selection)
    build([*targets(folder, [name for _, name in selected(folder, options)]), *also], preset)
    return folder, options
