"""Refuses an exercise in GLSL that redefines what it is checked with.

A shader's text comes before that of the check which calls it, and a macro has no place of its own: "#define main" or a
macro with the name of a variable of the check would change the check. A macro may have any name that nothing but this
exercise uses.
"""

import functools
import re
from pathlib import Path

from tree import ROOT

WORD = re.compile(r"[A-Za-z_]\w*")
DEFINE = re.compile(r"^\s*#\s*(?:define|undef)\s+(\w+)", re.M)
# Of GLSL itself, what a check's text is made of.
LANGUAGE = set("""main void bool int uint float double if else for while do return break continue discard switch case default
struct const in out inout uniform buffer shared layout readonly writeonly coherent volatile restrict true false""".split())


def foreign_macro(data: bytes, path: Path) -> str:
    """Why it is refused; empty where it is not."""
    # A line that ends in a backslash goes on, and a comment may stand anywhere between the words.
    text = re.sub(r"/\*.*?\*/", " ", data.decode("utf-8", "replace").replace("\\\r\n", "").replace("\\\n", ""), flags=re.S)
    names = set(DEFINE.findall(text))
    for name in sorted(names & (words_elsewhere(path) | LANGUAGE)):
        return f"it defines the macro {name}, a name that others use: what is checked would be something else"
    for name in sorted(names):
        if name.startswith(("gl_", "GL_", "__")):
            return f"it defines the macro {name}, which is GLSL's own"
    return ""


@functools.cache
def words_elsewhere(path: Path) -> frozenset[str]:
    """The words of all shaders but this exercise, and of the GLSL within the checks."""
    words = set()
    for shader in (ROOT / "shaders").rglob("*.*"):
        if shader.name != path.name or shader.parent.parent != path.parent.parent:
            words |= set(WORD.findall(code_of(shader.read_text(errors="replace"))))
    for source in (*(ROOT / "tests").glob("*/checks_*.cpp"), *(ROOT / "common" / "check").glob("*.cpp")):
        for quoted in re.findall(r'R"\((.*?)\)"|"((?:[^"\\\n]|\\.)*)"', source.read_text(errors="replace"), re.S):
            words |= set(WORD.findall(" ".join(quoted)))
    return frozenset(words)


def code_of(text: str) -> str:
    return re.sub(r"//[^\n]*|/\*.*?\*/", " ", text, flags=re.S)
