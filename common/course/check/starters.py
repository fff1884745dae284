"""The starters as they were handed out, by their digests: tests/starters.txt, which ./course docs --quote writes.

A student's own commits do not matter to it, and a handout without git has it too. A digest leaves white space out,
because an editor may end lines or the file in its own way."""

import functools
import re
from pathlib import Path

from tree import MANIFEST, ROOT, chapters, exercises, is_source, relative, write_atomically

LIST = MANIFEST
EXERCISE = re.compile(r"(chapters|shaders)/\d\d_\w+/exercise/\w+\.(cpp|glsl)")


@functools.lru_cache(1024)
def digest(data: bytes) -> str:
    """FNV-1a of 64 bits, ignoring white space, as common/window/exercise_checks.cpp computes it."""
    found = 14695981039346656037
    for byte in b"".join(data.split()):
        found = (found ^ byte) * 1099511628211 & (1 << 64) - 1
    return f"{found:016x}"


def listed(texts: dict[Path, bytes]) -> str:
    return "".join(f"{digest(text)} {name.as_posix()}\n" for name, text in sorted(texts.items()))


def as_they_stand() -> dict[Path, bytes]:
    """Those of the list, and what has a solution beside them: a new exercise, before it is in the list."""
    names = {Path(relative(path)) for chapter in chapters() for path in exercises(chapter).values()}
    for name in chapters():
        for room in ("chapters", "shaders"):
            names |= {Path(room, name, "exercise", path.name) for path in (ROOT / room / name / "solution").glob("*.*")}
    return {name: (ROOT / name).read_bytes() for name in names if EXERCISE.fullmatch(name.as_posix()) and is_source(ROOT / name)}


def untouched() -> set[str]:
    """The ids of the exercises that are still as they were handed out."""
    try:
        known = dict(reversed(line.split(" ", 1)) for line in (ROOT / LIST).read_text(encoding="utf-8").splitlines())
    except (OSError, ValueError):
        return set()
    return {name for chapter in chapters() for name, path in exercises(chapter).items()
            if (of := known.get(relative(path))) and digest(path.read_bytes()) == of}


def check_starters(write: bool = False) -> list[str]:
    """Compares the list with the starters, or writes it."""
    there, is_so = (ROOT / LIST).read_text(encoding="utf-8") if (ROOT / LIST).exists() else "", listed(as_they_stand())
    if there == is_so:
        return []
    if write:
        write_atomically(ROOT / LIST, is_so)
        return []
    new = sorted({line.split()[-1] for line in set(is_so.splitlines()) ^ set(there.splitlines())})
    return [f"{LIST}: the starter {name} is not in it; ./course docs --quote writes it" for name in new]
