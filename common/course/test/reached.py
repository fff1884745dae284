"""Which chapters and tests changed files reach: includes, shots and scenes say so."""

import re
from functools import cache
from pathlib import Path

from tree import ROOT, chapters, files

INCLUDE = re.compile(r'^\s*#\s*include\s+["<]([^">]+)[">]', re.M)
SHADER = re.compile(r'"((?:\.\./)?[\w/.]+\.(?:vert|geom|frag|comp|glsl))"')
WINDOW = ("common", "window")  # shots and checks are drawn without one
CODE = (".cpp", ".h", ".glsl", ".vert", ".geom", ".frag", ".comp")
EVERYTHING = ("common/base", "common/gpu", "common/image", "common/scene", "common/app", "common/measure", "common/study",
              "shaders/common", "CMakeLists.txt", "common/build.cmake", "tests/programs.cmake", "tests/build.cmake", "tests/run.py")


def named_files(path: Path) -> set[Path]:
    """The files of the tree that a file includes, or names as a pipeline's shader."""
    text, found = (ROOT / path).read_text(errors="replace", encoding="utf-8"), set()
    for name in {*INCLUDE.findall(text), *SHADER.findall(text)}:
        folder, last = Path(name).parent, Path(name).name
        places = [Path(root, folder, below, last) for root in ("", "chapters", "shaders") for below in ("", "exercise", "solution")]
        found |= {Path(place.as_posix().replace("shaders/../", "")) for place in places if (ROOT / place).is_file()}
    return found


@cache
def users() -> dict[Path, set[Path]]:
    """Files by each file that they need: includes, shaders, and a header's own .cpp."""
    found = {}
    for path in (name for name in files() if name.suffix in CODE):
        for needed in named_files(path):
            found.setdefault(needed, set()).add(path)
        if path.suffix == ".cpp" and (ROOT / path.with_suffix(".h")).is_file():
            found.setdefault(path, set()).add(path.with_suffix(".h"))
    return found


def reached_files(changed: list[str]) -> set[Path]:
    found, asked = set(), [Path(name) for name in changed if name]
    while asked:
        path = asked.pop()
        if path not in found:
            found.add(path)
            asked += users().get(path, ()) if path.parts[:2] != WINDOW else ()
    return found


def chapter_of(path: Path) -> str | None:
    return path.parts[1] if path.parts[0] in ("chapters", "shaders", "tests") and len(path.parts) > 2 and path.parts[1] in chapters() else None


def is_of_chapters(changed: list[str]) -> bool:
    """Whether all changed files are chapters' or texts: no other part of the tree has changed."""
    return all(chapter_of(Path(name)) or name.startswith(("docs/", "assets/", "tests/starters.txt")) for name in changed if name)


def draws(chapter: str, assets: list[str]) -> bool:
    """Whether a shot or the code of a chapter names a file of assets, itself or by a scene."""
    names = {Path(name).name for name in assets}
    scenes = {path.name for path in (ROOT / "assets" / "scenes").glob("*.json") if any(name in path.read_text(encoding="utf-8") for name in names)}
    texts = [path.read_text(errors="replace", encoding="utf-8") for path in [*(ROOT / "chapters" / chapter).rglob("*.[ch]*"), ROOT / "tests" / chapter / "shots.json"]
             if path.is_file()]
    return any(name in text for name in names | scenes for text in texts)


def reached(tests: list[str], changed: list[str]) -> list[str]:
    """Those of `tests` that changed files reach. A file of common that all programs are made of reaches every test."""
    if any(name.startswith(EVERYTHING) for name in changed):
        return tests
    of = {chapter for path in reached_files(changed) if (chapter := chapter_of(path))}
    if assets := [name for name in changed if name.startswith("assets/")]:
        of |= {chapter for chapter in chapters() if draws(chapter, assets)}
    lessons = {path.stem[:2] for name in changed if (path := Path(name)).parts[:1] == ("docs",)}
    numbers = {chapter[:2] for chapter in of}
    scripts = {Path(name).stem.removeprefix("test_") for name in changed if name.startswith("tests/common/")}
    units = any(name.startswith("tests/common/") and name.endswith((".cpp", ".h")) for name in changed) or \
        any(name.startswith(("common/check/", "common/judge/", "common/window/")) for name in changed)

    def is_reached(test: str) -> bool:
        words = set(test.split("."))
        return bool(words & of or words & numbers or words & scripts) or test in ("text.tree", "python.common.lint") or \
            test == "unit.common" and units or test.startswith("figures.") and bool(words & lessons) or \
            test == "python.common.equal_methods" and bool(of - {chapters()[-1]})  # nobody draws by the last one's methods

    return [test for test in tests if is_reached(test)]
