"""The tests that lessons name: `build/tests/test_NN_name "[NN.tag]"`, and `[NN.tag]` alone for the chapter's own program.

Prose has tags alone, for a test's name is a sentence. A command may have a name: it is matched as Catch2 does, against the
sources, so that nothing has to be built.
"""

import fnmatch
import re
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from tree import ROOT, chapters, sources

CASE = re.compile(r'\bTEST_CASE(?:_METHOD)?\s*\(\s*(?:\w+\s*,\s*)?((?:"(?:[^"\\]|\\.)*"\s*)+)(?:,\s*((?:"(?:[^"\\]|\\.)*"\s*)+))?\)', re.S)
STRING = re.compile(r'"((?:[^"\\]|\\.)*)"', re.S)
COMMAND = re.compile(r'build/tests/(test_\w+)\s+"([^"]+)"')
ALONE = re.compile(r"`(\[\d\d\.\w+\])`")
SENTENCE = re.compile(r'`"[^"`]*\*[^"`]*"`')  # a test's name in prose, with Catch2's wildcard


@dataclass(frozen=True)
class Named:
    """A place in a lesson that names tests."""
    lesson: Path
    line: int
    program: str
    spec: str


def joined(text: str) -> str:
    return "".join(STRING.findall(text)).replace('\\"', '"')


@cache
def cases(program: str) -> list[tuple[str, str]]:
    """(name, tags) of a test program's cases, from the sources of its folder."""
    folder = ROOT / "tests" / program.removeprefix("test_")
    return [(joined(name), joined(tags or "").lower()) for path in sources(folder, "*.cpp")
            for name, tags in CASE.findall(path.read_text(encoding="utf-8"))]


def matched(program: str, part: str) -> list[str]:
    if part.startswith("["):
        tags = re.findall(r"\[[^\]]*\]", part.lower())
        return [name for name, has in cases(program) if all(tag in has for tag in tags)]
    return [name for name, _ in cases(program) if fnmatch.fnmatchcase(name.lower(), part.lower())]


def named_in(lesson: Path) -> list[Named]:
    text = (ROOT / lesson).read_text(encoding="utf-8")
    own = next((f"test_{chapter}" for chapter in chapters() if chapter[:2] == lesson.stem[:2]), "")
    found = [(match.start(), match[1], match[2]) for match in COMMAND.finditer(text)]
    if own:
        found += [(match.start(), own, match[1]) for match in ALONE.finditer(text)]
    return [Named(lesson, text.count("\n", 0, at) + 1, program, " ".join(spec.split()))
            for at, program, spec in sorted(found)]


def of_chapters(names: list[Path]) -> list[Path]:
    """The lessons among texts: docs/NN_name.md, and docs/NNa_name.md of lessons with several pages."""
    return [name for name in names if re.fullmatch(r"docs/\d\d[a-z]?_\w+\.md", str(name))]


def check_named(lesson: Path) -> list[str]:
    """A line for each name that no test has, and for each sentence where a tag belongs."""
    wrong = [f"{one.lesson}:{one.line}: no test of {one.program} matches \"{one.spec}\""
             for one in named_in(lesson) if not matched(one.program, one.spec)]
    text = (ROOT / lesson).read_text(encoding="utf-8")
    return wrong + [f"{lesson}:{text.count(chr(10), 0, match.start()) + 1}: {match[0]}: name the test by its tag, such as `[14.furnace]`"
                    for match in SENTENCE.finditer(text)]
