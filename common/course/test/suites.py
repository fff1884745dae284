"""The suites of tests/suites.txt: which tests a change concerns, and how long each suite took."""

import re
import xml.etree.ElementTree as xml
from pathlib import Path

from tree import ROOT, Failure, git

SUITES = ("first", "engine", "platform", "field")
EVERY_COMMIT = ["-L", "^(first|engine)$"]  # ctest's option for the tests of a run without any choice
SLOWEST, LONG_S, REASON = 10, 60, "60s"


def lines() -> list[tuple[str, str, list[str]]]:
    """(suite, the regular expression of its tests' names, the paths that concern them) of each line."""
    return [(words[0], words[1], words[2:]) for words in read() if words[0] != REASON]


def read() -> list[list[str]]:
    """The words of each line but comments."""
    text = (ROOT / "tests" / "suites.txt").read_text(encoding="utf-8")
    return [line.split() for line in text.splitlines() if line and not line.startswith("#")]


def long_without_reason(took: dict[str, float]) -> list[str]:
    """The tests above 60 s for which no line "60s REGEX reason" of tests/suites.txt has a reason."""
    known = [words[1] for words in read() if words[0] == REASON and words[2:]]
    return [test for test in took if took[test] > LONG_S and not any(re.search(pattern, test) for pattern in known)]


def branch_base() -> str:
    """The commit where this branch left the main one; on the main one, its parent."""
    for main in ("origin/HEAD", "origin/main"):
        try:
            base = git("merge-base", "HEAD", main)
        except Failure:
            continue
        if base != git("rev-parse", "HEAD"):
            return base.decode().strip()
    return "HEAD~1"


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
    """The tests of platform that changed files concern by tests/suites.txt; all where the changes are unknown."""
    return [test for test in tests if files is None or any(file.startswith(path) for path in line_of(test)[2] for file in files)]


def times(junit: Path, with_reasons: bool) -> list[str]:
    """Lines that say how long the tests of a ctest run took, by suite, which took longest, and which need a reason for that."""
    took = {case.get("name"): float(case.get("time") or 0) for case in xml.parse(junit).getroot().iter("testcase")}
    by_suite = {suite: [took[test] for test in took if line_of(test)[0] == suite] for suite in SUITES}
    said = [f"{suite} {sum(each):.0f} s in {len(each)} tests" for suite, each in by_suite.items() if each]
    slowest = [f"{test} {took[test]:.0f} s" for test in sorted(took, key=took.get, reverse=True)[:SLOWEST]]
    asked = sorted(long_without_reason(took)) if with_reasons else []
    return [f"time of tests, some at once: {', '.join(said)}", f"slowest: {', '.join(slowest)}"] + \
        [f"above {LONG_S} s without a reason in tests/suites.txt: {', '.join(asked)}"] * bool(asked)
