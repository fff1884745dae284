"""The order in which parts of the tree may use each other: no part includes or imports a later one.

The rooms of common, in C++; the chapters, in C++ and GLSL, which may use common and earlier chapters; tests, which may also
use those of earlier chapters; the packages of common/course, in Python.
"""

import re
from pathlib import Path

from tree import ROOT

ROOMS = ("base", "gpu", "check", "image", "scene", "app", "measure", "study", "judge", "window")
# Modules beside the packages have a position in the order as well.
PACKAGES = ("tree", "commands", "progress", "many", "build", "shots", "charts", "check", "pages", "grading", "live", "test", "gallery", "models", "run", "new", "film", "cli", "__main__")

INCLUDE = re.compile(r'\s*#\s*include\s+"([^"]+)"')
IMPORT = re.compile(r"\s*(?:from|import) (\w+)")
CODE = (".h", ".cpp", ".glsl", ".vert", ".frag", ".geom", ".comp", ".tesc", ".tese")
CHAPTER = re.compile(r"\d\d_\w+")


def check_order(names: list[Path]) -> list[str]:
    """One "file:line: message" for each #include or import of a later part, and for each part without a position in the order."""
    rooms = {name.parts[1] for name in names if name.suffix in CODE and name.parts[0] == "common"}
    wrong = [f"common/{room}: not a room in the order {', '.join(ROOMS)} (common/course/test/order.py)"
             for room in sorted(rooms - set(ROOMS))]
    packages = {Path(name.parts[2]).stem for name in names if name.suffix == ".py" and name.parts[:2] == ("common", "course")}
    wrong += [f"common/course/{package}: not a package in the order {', '.join(PACKAGES)} (common/course/test/order.py)"
              for package in sorted(packages - set(PACKAGES))]
    for name in names:
        if name.suffix in CODE and name.parts[0] in ("common", "chapters", "shaders", "tests"):
            wrong += later_parts(name, INCLUDE, lambda used: later_include(name, used))
        elif name.suffix == ".py" and name.parts[:2] == ("common", "course"):
            wrong += later_parts(name, IMPORT, lambda used: later_import(name, used))
    return wrong


def later_parts(name: Path, pattern: re.Pattern, problem) -> list[str]:
    found = []
    for number, line in enumerate((ROOT / name).read_text(errors="replace", encoding="utf-8").splitlines(), 1):
        match = pattern.match(line)
        if match and (words := problem(match[1])):
            found.append(f"{name}:{number}: {words}")
    return found


def later_include(user: Path, used: str) -> str:
    mine, theirs = place(user), place(included(user, used))
    if theirs is None:
        return f"'{used}' leads to no part of the tree that code may include"
    kind, rank = theirs
    if mine[0] == "common":
        allowed = kind == "common" and rank <= mine[1]
    elif mine[0] == "chapter":
        allowed = kind == "common" or kind == "chapter" and rank <= mine[1]
    else:
        allowed = kind == "common" or rank <= mine[1]
    return "" if allowed else f"{where(mine)} may not include '{used}', which belongs to {where(theirs)}"


def where(placed: tuple[str, int]) -> str:
    kind, rank = placed
    if kind == "common":
        return f"common/{ROOMS[rank]}" if rank >= 0 else "shaders/common"
    return f"tests/{rank:02}" if kind == "tests" and rank else "tests/common" if kind == "tests" else f"chapter {rank:02}"


def included(user: Path, used: str) -> Path:
    """The path from the root that an #include means: beside its file, else below a folder that compilers search."""
    beside = (ROOT / user.parent / used).resolve()
    if beside.is_relative_to(ROOT) and beside.is_file():
        return beside.relative_to(ROOT)
    if CHAPTER.fullmatch(Path(used).parts[0]):
        return Path("chapters") / used
    below = [(ROOT / folder / used).resolve() for folder in ("", "shaders", "tests")]
    return next((path.relative_to(ROOT) for path in below if path.is_relative_to(ROOT) and path.is_file()), Path(used))


def place(name: Path) -> tuple[str, int] | None:
    """("common", room), ("chapter", number) or ("tests", number); shaders/common is before all rooms, tests/common is 0."""
    area, folder = (*name.parts, "")[:2]
    if area == "common" and folder in ROOMS:
        return "common", ROOMS.index(folder)
    if area == "shaders" and folder == "common":
        return "common", -1
    if (area, folder) == ("docs", "minimal"):  # programs of pages, which only their tests may use
        return "tests", 0
    if area == "tests":
        return "tests", int(folder[:2]) if CHAPTER.fullmatch(folder) else 0
    if area in ("chapters", "shaders") and CHAPTER.fullmatch(folder):
        return "chapter", int(folder[:2])
    return None


def later_import(user: Path, used: str) -> str:
    mine = Path(user.parts[2]).stem
    if used not in PACKAGES or mine not in PACKAGES or PACKAGES.index(used) <= PACKAGES.index(mine):
        return ""
    return f"{mine} may not import {used}, which is later in the order {', '.join(PACKAGES)}"
