"""Statistics of comments: the share that names a thing by a clause where a noun would do, and their length.

As a program it prints both for each folder, and the longest and the clausal comments of the folders that it is given.
"""

import re
import sys
from pathlib import Path

from tree import ROOT, files, say

SUFFIXES = (".h", ".cpp", ".glsl", ".vert", ".frag", ".comp", ".geom")
CLAUSE = re.compile(r"\b(what(ever)?|whose|whoever|that which|those (of|that|which|who)|one another's)\b", re.I)
LINE = re.compile(r"^\s*///?<?\s?(.*)$")
BEHIND = re.compile(r"(?<![:\"'])//[/!]?<?\s+(.*)$")
MARKER = re.compile(r"\[/?[\w.-]+\]$|clang-format|NOLINT")


def comments(text: str) -> list[tuple[int, str]]:
    """(line, words) of each comment: lines that follow one another are one, a comment behind code is one of its own."""
    found, open_at, words = [], 0, []
    for number, line in enumerate([*text.splitlines(), ""], 1):
        alone = LINE.match(line)
        if alone and not MARKER.match(alone[1]):
            open_at = open_at or number
            words.append(alone[1])
            continue
        if words:
            found.append((open_at, " ".join(words)))
            open_at, words = 0, []
        if not alone and (behind := BEHIND.search(line)):
            found.append((number, behind[1]))
    return [(number, re.sub(r"\s+", " ", said).strip()) for number, said in found if len(said.split()) > 1]


def area(name: Path) -> str:
    """The folder that a file is counted with: common/gpu, chapters/02_lambert_phong, shaders/common."""
    return "/".join(name.parts[:2])


def counted(name: Path) -> bool:
    """Exercises state a task, not a reason; their texts are the lessons'."""
    return name.suffix in SUFFIXES and name.parts[0] in ("common", "chapters", "shaders") and "exercise" not in name.parts


def figures() -> dict[str, tuple[int, int, int]]:
    """(comments, clausal ones, words) of each folder."""
    sums: dict[str, list[int]] = {}
    for name in filter(counted, files()):
        total = sums.setdefault(area(name), [0, 0, 0])
        for _, said in comments((ROOT / name).read_text(encoding="utf-8")):
            total[0] += 1
            total[1] += bool(CLAUSE.search(said))
            total[2] += len(said.split())
    return {name: tuple(total) for name, total in sorted(sums.items())}


def main(folders: list[str]):
    for name, (count, clausal, words) in figures().items():
        if not folders or name in folders:
            say(f"{name}: {count} comments, {100 * clausal / max(count, 1):.1f}% by a clause, {words / max(count, 1):.1f} words")
    for name in filter(counted, files()):
        if area(name) in folders:
            for number, said in comments((ROOT / name).read_text(encoding="utf-8")):
                if CLAUSE.search(said) or len(said.split()) > 40:
                    say(f"{name}:{number}: {said}")


if __name__ == "__main__":
    main(sys.argv[1:])
