"""The suites of tests/suites.txt: which tests a change concerns, and how long each suite took."""

import re
import xml.etree.ElementTree as xml
from pathlib import Path

from tree import ROOT, Failure, git

SUITES = ("first", "engine", "platform", "field")
EVERY_COMMIT = ["-L", "^(first|engine)$"]  # ctest's option for the tests of a run without any choice
SLOWEST = 10


def lines() -> list[tuple[str, str, list[str]]]:
    """(suite, the regular expression of its tests' names, the paths that concern them) of each line."""
    text = (ROOT / "tests" / "suites.txt").read_text()
    return [(words[0], words[1], words[2:]) for line in text.splitlines() if (words := line.split()) and not line.startswith("#")]


def changed_since(commit: str) -> list[str] | None:
    """The files that differ from those of a commit; None where git does not know it."""
    try:
        listed = git("diff", "--name-only", commit) + git("ls-files", "--others", "--exclude-standard")
    except Failure:
        return None
    return listed.decode(errors="replace").split("\n")


def line_of(test: str) -> tuple[str, str, list[str]]:
    """The first line that names a test."""
    return next(line for line in lines() if re.search(line[1], test))


def concerned(tests: list[str], files: list[str] | None) -> list[str]:
    """The tests of platform that changed files concern; all where the changes are unknown."""
    return [test for test in tests if files is None or any(file.startswith(path) for path in line_of(test)[2] for file in files)]


def times(junit: Path) -> list[str]:
    """Lines that say how long the tests of a ctest run took, by suite, and which took longest."""
    took = {case.get("name"): float(case.get("time") or 0) for case in xml.parse(junit).getroot().iter("testcase")}
    by_suite = {suite: [took[test] for test in took if line_of(test)[0] == suite] for suite in SUITES}
    said = [f"{suite} {sum(each):.0f} s in {len(each)} tests" for suite, each in by_suite.items() if each]
    slowest = [f"{test} {took[test]:.0f} s" for test in sorted(took, key=took.get, reverse=True)[:SLOWEST]]
    return [f"time of tests, some at once: {', '.join(said)}", f"slowest: {', '.join(slowest)}"]
