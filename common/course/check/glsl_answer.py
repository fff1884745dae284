"""Reads an exercise in GLSL as the compiler will, and refuses text that could change or reveal its check.

An answer is compiled together with its check. So that both read the same, the compiler gets plain() of
the file: without comments, continued lines and other line ends, in which "#define" could hide. In that text an
answer defines no macro that others use, asks the preprocessor for no name but its own and its starter's, uses no name of a
check (check_, probe_ or undefined_ in front) and no macro that only checks define, declares no buffers, and includes only
files that its starter or the framework does.
"""

import functools
import re
from pathlib import Path

from tree import ROOT, shader_files, sources

WORD = re.compile(r"[A-Za-z_]\w*")
RESERVED = re.compile(r"(check|probe|undefined)_|(Check|Probe)[A-Z]|CHECK_")
PREDEFINED = re.compile(r"__|GL_|VULKAN$")
INCLUDE = re.compile(r'\s*#\s*include\s*"([^"]*)"\s*')
CONDITION = re.compile(r"^[ \t]*#[ \t]*(?:if|ifdef|ifndef|elif)\b(.*)", re.M)
DEFINE = re.compile(r"^[ \t]*#[ \t]*define[ \t]+(\w+)(.*)", re.M)
DIRECTIVES = ("define", "undef", "if", "ifdef", "ifndef", "elif", "else", "endif", "include", "")
# Keywords that reach memory by binding or address.
DECLARING = ("uniform", "buffer", "layout", "subroutine", "buffer_reference")
# GLSL's own names in a check's text.
LANGUAGE = set("""main void bool int uint float double if else for while do return break continue discard switch case default
struct const in out inout uniform buffer shared layout readonly writeonly coherent volatile restrict true false""".split())


# Every character belongs to one of these, and none is scanned twice: a hostile text may have a megabyte.
PIECE = re.compile(r'//[^\n]*|/\*|"[^"\n]*["\n]?|[\t\n -!#-.0-\[\]-~]+|/|.', re.S)
LONGEST_NAME = 200


class Refused(Exception):
    """Its text says why."""


def plain(data: bytes, path: Path) -> str:
    """The text that is compiled, with the lines of the file. Raises Refused."""
    if data.startswith((b"\xff\xfe", b"\xfe\xff")):
        raise Refused("error: it is UTF-16 text; save it as UTF-8")
    # White space too, by GLSL's specification, 3.1.
    data = data.replace(b"\f", b" ").replace(b"\v", b" ")
    text = without_comments(spliced(data.removeprefix(b"\xef\xbb\xbf").decode("utf-8", "replace")))
    starter, reference = given(path)
    known, allowed = set(WORD.findall(starter)), reached(path, starter) | reached(path, reference)
    for number, line in enumerate(text.split("\n"), 1):
        if line:
            look_at_line(line, number, path, allowed)
    names = set(WORD.findall(re.sub(r'"[^"]*"', "", text)))
    for name in sorted(names - known):
        if RESERVED.match(name):
            raise Refused(f"it has the name {name}, and such names are the checks' own")
        if name in macros_of_checks():
            raise Refused(f"it asks for the macro {name}, by which shaders know that they are checked")
        if PREDEFINED.match(name):
            raise Refused(f"it has the name {name}, which the compiler defines, and which differs where an answer is checked")
    if asked := sorted(asked_for(text) - asked_for(starter) - asked_for(reference)):
        raise Refused(f"its #if asks for {asked[0]}, which neither it nor its starter defines: it would be another answer elsewhere")
    for name in sorted((names & written_buffers(path)) - known - set(WORD.findall(reference))):
        raise Refused(f"it names {name}, into which the functions of its starter write for it")
    for name in DECLARING:
        if len(re.findall(rf"\b{name}\b", text)) > len(re.findall(rf"\b{name}\b", starter)):
            raise Refused(f"it has a {name} that its starter does not have")
    if re.search(r"\b(?:binding|set)\s*=\s*\w+\s*[,)]", text):
        raise Refused("it binds something by a number, and bindings have names here")
    if why := foreign_macro(text, path):
        raise Refused(why)
    return text


def asked_for(text: str) -> set[str]:
    """Names on which a text's conditions depend that it does not define itself."""
    own = {}
    for name, body in DEFINE.findall(text):
        own.setdefault(name, set()).update(WORD.findall(body))
    asked, waiting = set(), [name for line in CONDITION.findall(text) for name in WORD.findall(line) if name != "defined"]
    while waiting:
        name = waiting.pop()
        if name not in asked:
            asked.add(name)
            waiting += own.get(name, ())
    return asked - set(own)


def spliced(text: str) -> str:
    """Each line whole, where a backslash goes on with it in the next; the lines behind it keep their numbers."""
    lines, parts = [], []
    for line in re.split(r"\r\n|\r|\n", text):
        if line.endswith("\\"):
            parts.append(line[:-1])
            continue
        lines += ["".join([*parts, line]), *[""] * len(parts)]
        parts = []
    return "\n".join(lines + (["".join(parts)] if parts else []))


def without_comments(text: str) -> str:
    """A space for each, and the ends of its lines. Raises Refused."""
    out, at = [], 0
    while at < len(text):
        piece = PIECE.match(text, at)[0]
        at += len(piece)
        if piece == "/*":
            end = text.find("*/", at)
            if end < 0:
                raise Refused("error: a comment does not end")
            out.append(" " + "\n" * text.count("\n", at, end))
            at = end + 2
        elif not piece.startswith("//"):
            # Quotes contain an #include's name, checked later by its line; comments cannot begin in it.
            if piece[0] != '"' and not (piece[0] in "\t\n" or (" " <= piece[0] <= "~" and piece[0] != "\\")):
                raise Refused(f"line {text.count(chr(10), 0, at) + 1}: unexpected token: U+{ord(piece[0]):04X} is no letter of GLSL")
            out.append(piece)
    return "".join(out)


def look_at_line(line: str, number: int, path: Path, allowed: set[str]):
    """Raises Refused where a directive is none that an exercise needs."""
    directive = re.match(r"\s*#\s*(\w*)", line)
    word = directive[1] if directive else None
    if word is not None and word not in DIRECTIVES:
        raise Refused(f"line {number}: error: no exercise needs #{word}")
    if word == "include":
        if not (found := INCLUDE.fullmatch(line)):
            raise Refused(f'line {number}: error: expected #include "path below shaders/"')
        look_at_include(found[1], number, path, allowed)
    elif '"' in line or "'" in line or "#" in (line[directive.end():] if directive else line):
        raise Refused(f"line {number}: error: GLSL has no texts, and no # within a line")


def look_at_include(name: str, number: int, path: Path, allowed: set[str]):
    here = f'line {number}: #include "{name[:60]}"'
    if len(name) > LONGEST_NAME:
        raise Refused(f"{here}: there is no file of that name")
    if Path(name).is_absolute() or ".." in Path(name).parts:
        raise Refused(f"{here}: an include is a path below shaders/")
    if {"solution", "exercise"} & set(Path(name).parts):
        raise Refused(f"{here}: there is no file of that name; which version is meant is not the shader's to say")
    for other in sorted(exercises_behind((name,)) - allowed - {id_of(path)}):
        raise Refused(f"{here}: that has {other} in it, an exercise that the starter does not build on")


def id_of(path: Path) -> str:
    return f"{path.parent.parent.name[:2]}.{path.stem}"


@functools.cache
def given(path: Path) -> tuple[str, str]:
    """The starter as it lies here, and the reference; empty where there is none."""
    def text_of(one):
        return without_comments(spliced(one.read_text(errors="replace", encoding="utf-8"))) if one.exists() else ""
    return text_of(path), text_of(path.parent.parent / "solution" / path.name)


@functools.cache
def reached(path: Path, text: str) -> set[str]:
    """The exercises that a text of this one has by its includes."""
    return exercises_behind(tuple(includes_of(text))) - {id_of(path)}


def includes_of(text: str) -> list[str]:
    return [found[1] for line in text.split("\n") if (found := INCLUDE.fullmatch(line))]


@functools.cache
def exercises_behind(names: tuple[str, ...]) -> set[str]:
    """Of includes, and of all that they include: the exercises."""
    found = set()
    for file in files_behind(names):
        if file.parent.name in ("exercise", "solution"):
            found.add(id_of(file))
    return found


@functools.cache
def files_behind(names: tuple[str, ...]) -> set[Path]:
    shaders, seen, waiting = ROOT / "shaders", set(), list(names)
    while waiting:
        place = shaders / waiting.pop()
        for file in (place, place.parent / "exercise" / place.name, place.parent / "solution" / place.name):
            if file.is_file() and file not in seen:
                seen.add(file)
                waiting += includes_of(code_of(file.read_text(errors="replace", encoding="utf-8")))
    return seen


@functools.cache
def written_buffers(path: Path) -> frozenset[str]:
    """Written members of the buffers that this exercise's includes declare."""
    names = set()
    for text in (code_of(file.read_text(errors="replace", encoding="utf-8")) for file in files_behind(tuple(includes_of(given(path)[0])))):
        for before, inside in re.findall(r"([^;{}]*)\bbuffer\s+\w+\s*\{([^}]*)\}", text):
            if "readonly" not in before:
                names |= set(re.findall(r"(\w+)\s*(?:\[[^\]]*\]\s*)?;", inside))
    return frozenset(names)


@functools.cache
def macros_of_checks() -> frozenset[str]:
    """Macros defined only by checks: a handout has no list of them."""
    named, asked = set(), set()
    for source in (*sources(ROOT / "tests", "*/checks_*.cpp"), *sources(ROOT / "tests", "*/*.h")):
        text = source.read_text(errors="replace", encoding="utf-8")
        named |= set(re.findall(r'(?:\{|macros\.set\()"([A-Z][A-Z0-9_]+)"|^#define ([A-Z][A-Z0-9_]+)', text, re.M))
    for shader in (*shader_files(), *sources(ROOT / "tests", "*/*.glsl")):
        asked |= set(WORD.findall(code_of(shader.read_text(errors="replace", encoding="utf-8"))))
    return frozenset(name for pair in named for name in pair if name in asked)


def foreign_macro(text: str, path: Path) -> str:
    """Why a macro of a plain text is refused; empty where none is. A macro has no place of its own: one with the name of a
    variable of the check would change the check. It may have any name that nothing but this exercise uses."""
    names = set(re.findall(r"^[ \t]*#[ \t]*(?:define|undef)[ \t]+(\w+)", text, re.M))
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
    for shader in shader_files():
        if shader.name != path.name or shader.parent.parent != path.parent.parent:
            words |= set(WORD.findall(code_of(shader.read_text(errors="replace", encoding="utf-8"))))
    for shader in sources(ROOT / "tests", "*/*.glsl"):
        words |= set(WORD.findall(code_of(shader.read_text(encoding="utf-8", errors="replace"))))
    for source in (*sources(ROOT / "tests", "*/checks_*.cpp"), *sources(ROOT / "common" / "check", "*.cpp")):
        for quoted in re.findall(r'R"\((.*?)\)"|"((?:[^"\\\n]|\\.)*)"', source.read_text(errors="replace", encoding="utf-8"), re.S):
            words |= set(WORD.findall(" ".join(quoted)))
    return frozenset(words)


def code_of(text: str) -> str:
    return re.sub(r"//[^\n]*|/\*.*?\*/", " ", text, flags=re.S)
