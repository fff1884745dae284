"""Statements that a comma joins where each could have a line of its own: `a = 1, b = 2;`, `return act(), true;`.

As a program it lists them.
"""

import re
from collections.abc import Iterator
from pathlib import Path

from tree import ROOT, files, say

# Strings, characters, comments and directives; a quote between digits separates them.
TEXT = re.compile(r'R"(\w*)\(.*?\)\1"|"(?:[^"\\\n]|\\.)*"|(?<!\w)\'(?:[^\'\\\n]|\\.)+\'|//[^\n]*|/\*.*?\*/|^ *#(?:[^\n]*\\\n)*[^\n]*',
                  re.S | re.M)
TEMPLATE = re.compile(r"(?<=\w)<[\w:,.*&+\s]*>")
HEAD = re.compile(r"^(else\b|do\b|(if|for|while|switch)( constexpr)? *\(\)|case [^:]*:(?!:)|default *:|(public|private|protected) *:|[A-Z_]{4,} (?=[a-z]))\s*")
DECLARES = re.compile(r"^(const|constexpr|static|inline|using|throw|friend|template|struct|class|enum|precise|layout)\b"
                      r"|^[\w:]+(<.*>)?[ &*]+\w+(\[\])* *(\(\)|\{\}|=|,|:|$)")
GOES_ON = re.compile(r"\s*[,;).(\[*+\-=?:}<>&|/]")  # behind an initializer's brace; a block's ends its statement


def blank(found: re.Match) -> str:
    """As many characters that are no code."""
    kept = " " if found[0].lstrip()[0] in "/#" else "_"
    return re.sub(r"[^\n]", kept, found[0])


def statements(text: str) -> Iterator[tuple[int, int, str]]:
    """(begin, end, words) of each statement up to its semicolon; the words lack what parentheses and braces hold."""
    text = TEXT.sub(blank, text)
    while TEMPLATE.search(text):
        text = TEMPLATE.sub(blank, text)
    outer, words, begin, depth = [], "", 0, 0
    for at, letter in enumerate(text):
        depth -= letter in ")]"
        if letter == "{":
            outer.append((words, begin, depth))
            words, depth = "", 0
        elif letter == "}" and outer:
            words, begin, depth = outer.pop()
            if depth == 0:
                words = words + "{}" if GOES_ON.match(text, at + 1) else ""
        elif letter == ";" and depth == 0:
            yield begin, at, " ".join(words.split())
            words = ""
        elif depth == 0 and (words or not letter.isspace()):
            begin = begin if words else at
            words += letter
        depth += letter in "(["


def is_joined(words: str) -> bool:
    """Whether a statement is several that a comma joins. Declarations may name several variables."""
    while head := HEAD.match(words):
        words = words[head.end():]
    return "," in words and (words.startswith("return ") or not DECLARES.match(words) and bool(re.match(r"[\w+*(-]+.*[(=+-]", words)))


def joined(text: str) -> list[tuple[int, str]]:
    """(line, words) of joined statements in C++."""
    return [(text.count("\n", 0, begin) + 1, words) for begin, _, words in statements(text) if is_joined(words)]


def code(top: str) -> list[Path]:
    """C++ and GLSL below a folder, without exercises and their references."""
    kinds = (".h", ".cpp", ".glsl", ".vert", ".frag", ".comp")
    return [name for name in files() if name.parts[0] == top and name.suffix in kinds and not {"exercise", "solution"} & set(name.parts)]


def found(top: str) -> list[tuple[Path, int, str]]:
    """(file, line, words) of joined statements below a folder."""
    return [(name, *one) for name in code(top) for one in joined((ROOT / name).read_text(encoding="utf-8"))]


if __name__ == "__main__":
    for top in ("common", "chapters", "shaders", "tests"):
        for name, number, words in found(top):
            say(f"{name}:{number}: {words}")
