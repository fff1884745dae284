"""Statistics of comments: the share that names a thing by a clause where a noun would do, and their length.

As a program it prints both for each folder, and the longest and the clausal comments of the folders that it is given.
"""

import ast
import io
import re
import sys
import tokenize
from pathlib import Path

from tree import ROOT, files, say

CODE = (".h", ".cpp", ".glsl", ".vert", ".frag", ".comp", ".geom")
CLAUSE = re.compile(r"\b(what(ever)?|whose|whoever|that which|those (of|that|which|who)|one another's)\b", re.I)
QUOTED = re.compile(r"`[^`]*`|\"[^\"]*\"")
LINE = re.compile(r"^\s*///?<?\s?(.*)$")
BEHIND = re.compile(r"(?<![:\"'])//[/!]?<?\s+(.*)$")
MARKER = re.compile(r"\[/?[\w.-]+\]$|clang-format|NOLINT")
TO_PROGRAMS = re.compile(r"#!|#\s*(noqa|type:|Builds:)")
LONG = 40


def comments(text: str) -> list[tuple[int, str]]:
    """(line, words) of each comment in C++ or GLSL: consecutive lines are one, a comment behind code is one of its own."""
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
    return told(found)


def python_comments(text: str) -> list[tuple[int, str]]:
    """The same in Python. Each paragraph of a docstring is a comment; indented ones are formats and do not count."""
    found, last = [], -1
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type != tokenize.COMMENT or TO_PROGRAMS.match(token.string):
            continue
        words, (number, column) = re.sub(r"\s*#\s*noqa.*", "", token.string).lstrip("# "), token.start
        alone = not token.line[:column].strip()
        if alone and last == number - 1:
            found[-1] = (found[-1][0], f"{found[-1][1]} {words}")
        else:
            found.append((number, words))
        last = number if alone else -1
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)) and (doc := ast.get_docstring(node)):
            found += [(node.body[0].lineno, part) for part in re.split(r"\n\s*\n", doc) if not part.startswith(" ")]
    return told(sorted(found))


def told(found: list[tuple[int, str]]) -> list[tuple[int, str]]:
    """Without comments of one word, and with single spaces."""
    return [(number, re.sub(r"\s+", " ", said).strip()) for number, said in found if len(said.split()) > 1]


def is_clausal(said: str) -> bool:
    return bool(CLAUSE.search(QUOTED.sub("", said)))


def area(name: Path) -> str:
    """The folder that a file is counted with: common/gpu, chapters/02_lambert_phong, shaders/common."""
    return "/".join(name.parts[:2])


def counted(name: Path) -> bool:
    """Exercises state a task, and variants are answers to one; fuzz corpora are data."""
    return name.suffix in (*CODE, ".py") and name.parts[0] in ("common", "chapters", "shaders", "tests", "docs") \
        and not {"exercise", "variants", "corpus"} & set(name.parts)


def comments_of(name: Path) -> list[tuple[int, str]]:
    return (python_comments if name.suffix == ".py" else comments)((ROOT / name).read_text(encoding="utf-8"))


def figures() -> dict[str, tuple[int, int, int]]:
    """(comments, clausal ones, words) of each folder."""
    sums: dict[str, list[int]] = {}
    for name in filter(counted, files()):
        total = sums.setdefault(area(name), [0, 0, 0])
        for _, said in comments_of(name):
            total[0] += 1
            total[1] += is_clausal(said)
            total[2] += len(said.split())
    return {name: tuple(total) for name, total in sorted(sums.items())}


def main(folders: list[str]):
    for name, (count, clausal, words) in figures().items():
        if not folders or name in folders:
            say(f"{name}: {count} comments, {100 * clausal / max(count, 1):.1f}% by a clause, {words / max(count, 1):.1f} words")
    for name in filter(counted, files()):
        if area(name) in folders:
            for number, said in comments_of(name):
                if is_clausal(said) or len(said.split()) > LONG:
                    say(f"{name}:{number}: {said}")


if __name__ == "__main__":
    main(sys.argv[1:])
