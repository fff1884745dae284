"""A shader whole: with all that it includes, in the order in which it is compiled, each part under the file it comes from."""

import re
from pathlib import Path

from build.build import build
from pages.knob_links import knobs_of
from tree import ROOT, Failure, UsageError, find_chapter, nearest, say, shader_files

HELP = """Prints a shader whole, as a chapter compiles it: each part under a comment with the file it comes from.

  ./course shader 05_shadow_maps/surface.frag                with that chapter's knobs as they are by default
  ./course shader surface.frag --chapter 05                  the same
  ./course shader 05_shadow_maps/shadow.glsl --chapter 12    with the knobs of chapter 12
  ./course shader pcf.glsl --use exercise                    your version of the exercises
  ./course shader --list                                     the names of all shaders"""
INCLUDE = re.compile(r'\s*#\s*include\s*"([^"]+)"')
CPP_INCLUDE = re.compile(r"\s*#\s*include\s*<")
STAGES = (".vert", ".geom", ".frag", ".comp")
SHADERS = (*STAGES, ".glsl", ".h")


def add_arguments(parser):
    parser.add_argument("file", nargs="?", help="a file below shaders/; its name alone where only one has it")
    parser.add_argument("--chapter", metavar="NN", help="whose knobs decide; default: the file's own")
    parser.add_argument("--use", choices=("solution", "exercise"), default="solution", help="which version of the exercises")
    parser.add_argument("--list", action="store_true", help="the names of all shaders")


def run(arguments, _rest) -> int:
    if arguments.list:
        if arguments.file or arguments.chapter:
            raise UsageError("--list names all shaders: leave out what else was given")
        say("\n".join(names()))
        return 0
    if not arguments.file:
        raise UsageError("which shader? ./course shader --list names all")
    chapter = find_chapter(arguments.chapter) if arguments.chapter else None
    name = find_shader(arguments.file, chapter)
    own = name.split("/")[0]
    if chapter and own != "common" and own > chapter:
        raise UsageError(f"{chapter} knows no shader of a later chapter, and {name} is one")
    say(whole(name, arguments.use, chapter or (own if own != "common" else None)).rstrip("\n"))
    return 0


def names() -> list[str]:
    """Includable files and stages: paths below shaders/, an exercise without its folder."""
    found = {path.relative_to(ROOT / "shaders") for path in shader_files() if path.suffix in SHADERS}
    return sorted({str(one.parent.parent / one.name) if one.parent.name in ("exercise", "solution") else str(one)
                   for one in found})


def find_shader(word: str, chapter: str | None = None) -> str:
    """The shader that a person means. Raises UsageError, with the two nearest names."""
    known = names()
    path = Path(word.removeprefix("shaders/"))
    path = path.parent.parent / path.name if path.parent.name in ("exercise", "solution") else path
    meant = [str(path)] if str(path) in known else [name for name in known if Path(name).name == word]
    if chapter and len(meant) > 1:
        meant = [name for name in meant if name.startswith(f"{chapter}/")] or meant
    if len(meant) == 1:
        return meant[0]
    if meant:
        raise UsageError(f"{len(meant)} shaders are called {word}: {', '.join(meant)}")
    raise UsageError(f"there is no shader '{word}'; {nearest(word, known)}; ./course shader --list names all")


def whole(name: str, use: str = "solution", chapter: str | None = None) -> str:
    """The text of a shader with its includes, each once and where it is met first. With a chapter, which is built for it,
    the macros of its knobs stand before it. Raises Failure where an include leads nowhere."""
    lines = []
    add(name, use, lines, set())
    text = "\n".join(lines) + "\n"
    return header(chapter, text) + text if chapter else text


def place(name: str, use: str, asked: str) -> Path:
    """The file that an include means (common/gpu/flatten.cpp): an exercise's lies in one of two folders."""
    path = Path(name)
    for folder in ("", use, "exercise"):
        if (ROOT / "shaders" / path.parent / folder / path.name).is_file():
            return Path("shaders") / path.parent / folder / path.name
    raise Failure(f"{asked}: no file shaders/{name}")


def add(name: str, use: str, lines: list[str], seen: set[str], asked: str = "./course shader"):
    if name in seen:
        return
    seen.add(name)
    path = place(name, use, asked)
    lines.append(f"// ==== {path}")
    goes_on = False  # an include stood here
    for number, line in enumerate((ROOT / path).read_text(encoding="utf-8", errors="replace").splitlines(), 1):
        if found := INCLUDE.match(line):
            before = len(lines)
            add(found[1], use, lines, seen, f"{path}:{number}")
            goes_on = goes_on or len(lines) > before
        elif not CPP_INCLUDE.match(line):
            if goes_on and line.strip():
                lines.append(f"// ==== {path}, line {number} on")
                goes_on = False
            lines.append(line)


def header(chapter: str, text: str) -> str:
    """The lines before a shader: the macros of the chapter's knobs that it names, at their defaults."""
    build([chapter])
    macros = {}
    for knob in knobs_of(chapter):
        macros |= macros_of(knob)
    named = set(re.findall(r"\w+", text))
    defines = "".join(f"#define {macro} {value}\n" for macro, value in macros.items() if macro in named)
    empty = "".join(f"#define {word}\n" for word in ("BEGIN_SHARED", "END_SHARED", "SHARED_FUNCTION") if word in named)
    return f"#version 460\n#extension GL_EXT_scalar_block_layout : require\n{empty}// ==== the knobs of {chapter} by default\n{defines}"


def macros_of(knob: dict) -> dict[str, int]:
    """As KnobBase::macro() names them: the kind of module, which is nearly always its name, stands before the knob's."""
    macro = "_".join(knob["name"].split(".")[-2:]).upper()
    if knob["type"] == "choice":
        options = {f"{macro}_{option.upper()}": i for i, option in enumerate(knob["options"])}
        return {macro: options[f"{macro}_{knob['default'].upper()}"], **options}
    return {macro: int(knob["default"])} if isinstance(knob["default"], bool) else {}
