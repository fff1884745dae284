"""Statements that a comma joins where each could have a line of its own: `a = 1, b = 2;`, `return act(), true;`.

As a program it lists them.
"""

import re
from pathlib import Path

from tree import ROOT, files, say

TEXT = re.compile(r'"(?:[^"\\\n]|\\.)*"|\'(?:[^\'\\\n]|\\.)+\'|//.*')
TEMPLATE = re.compile(r"(?<=\w)<[\w:,.*&+ ]*>")
HEAD = re.compile(r"^(else\b|(if|for|while|switch)( constexpr)? *\(\)|case [^:]*:(?!:)|default *:)\s*")
DECLARES = re.compile(r"^(const|constexpr|static|inline|using|throw)\b|^[\w:]+[ &*]+\w+ *(\(\)|\{\}|=|,|$)")


def outside(line: str) -> str | None:
    """The text of a line outside of parentheses, brackets and braces; None if it begins within some."""
    found, depth, rest = "", 0, TEXT.sub("", line)
    while TEMPLATE.search(rest):
        rest = TEMPLATE.sub("", rest)
    for letter in rest.strip():
        depth -= letter in ")]}"
        if depth < 0:
            return None
        if depth == 0:
            found += letter
        depth += letter in "([{"
    return found


def joined(line: str) -> bool:
    """Whether a line of C++ holds a statement that a comma joins. Declarations may name several variables."""
    rest = outside(line)
    if not rest or not rest.endswith(";") or "," not in rest:
        return False
    while head := HEAD.match(rest):
        rest = rest[head.end():]
    return "," in rest and (rest.startswith("return ") or not DECLARES.match(rest)) and bool(re.match(r"[\w+*-]+.*[(=+-]|return", rest))


def found(top: str) -> list[tuple[Path, int, str]]:
    """(file, line, text) of joined statements in the C++ below a folder, without exercises."""
    return [(name, number, line.strip()) for name in files() if name.parts[0] == top and name.suffix in (".h", ".cpp")
            and "exercise" not in name.parts for number, line in enumerate((ROOT / name).read_text(encoding="utf-8").splitlines(), 1)
            if joined(line)]


if __name__ == "__main__":
    for top in ("common", "chapters"):
        for name, number, line in found(top):
            say(f"{name}:{number}: {line}")
