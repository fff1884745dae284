"""The course's tree: where things lie, which chapters and shots there are, and how a command says that it cannot."""

import difflib
import json
import os
import re
import subprocess
import sys
import threading
from collections.abc import Iterable
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
# A test of another build folder (the sanitizers') says so in the environment.
BUILD = Path(os.environ.get("LIGHTWALK_BUILD", ROOT / "build"))
LIBRARIES = tuple(BUILD / f"lib{name}.so" for name in ("lightwalk", "lightwalk_check", "lightwalk_app"))  # common, for all programs
SHADER_CACHE = Path(os.environ.get("LIGHTWALK_CACHE", ROOT / "build" / "shader_cache"))  # as common/base/kept.h says


class UsageError(Exception):
    """An impossible command: one line with the remedy. Exit code 2."""


class Failure(Exception):
    """It was tried and failed: one line. Exit code 1. An empty line where all is said already."""


def chapters() -> list[str]:
    """The chapters' names, "01_obj" and so on, in order."""
    return sorted(path.name for path in (ROOT / "chapters").glob("[0-9][0-9]_*") if path.is_dir())


def lesson_pages(chapter: str) -> list[Path]:
    """The chapter's lesson, docs/15_terrain_water.md, and its further pages, docs/15a_terrain.md and so on."""
    docs = ROOT / "docs"
    pages = [docs / f"{chapter}.md", *sorted(docs.glob(f"{chapter[:2]}[a-z]_*.md"))]
    return [path.relative_to(ROOT) for path in pages if path.exists()]


def lessons() -> list[Path]:
    """All pages of lessons in the order in which they are read. The first, docs/00_start.md, belongs to no chapter."""
    start = Path("docs/00_start.md")
    return [*[start] * (ROOT / start).exists(), *[page for chapter in chapters() for page in lesson_pages(chapter)]]


def find_lesson(word: str) -> Path:
    """The page that a person means by 00, 15a, 15a_terrain or a chapter's name."""
    for page in lessons():
        if word in (page.stem, page.stem.split("_")[0]):
            return page
    chapter = find_chapter(word)
    if not lesson_pages(chapter):
        raise UsageError(f"chapter {chapter} has no lesson")
    return lesson_pages(chapter)[0]


def nearest(word: str, known: Iterable[str]) -> str:
    """The two names that are most like a word, which may be a path or a file's name alone, as an error says them."""
    def likeness(name: str) -> float:
        other = name if "/" in word else Path(name).name
        ratio = difflib.SequenceMatcher(None, word.lower(), other.lower()).ratio()
        return ratio + (len(word) > 2 and word.lower() in other.lower())
    found = sorted(known, key=lambda name: (-likeness(name), name))[:2]
    return f"the nearest {'is' if len(found) == 1 else 'are'} {' and '.join(found)}" if found else "there are none"


def find_chapter(word: str) -> str:
    """The chapter that a person means by 02, 2, 02_lambert_phong or lambert_phong."""
    for name in chapters():
        number, title = name.split("_", 1)
        if word in (name, number, number.lstrip("0"), title):
            return name
    if not chapters():
        raise UsageError("there are no chapters here")
    raise UsageError(f"there is no chapter '{word}'; {nearest(word, chapters())}; the README lists all of them")


def chapter_title(chapter: str) -> str:
    """"02 Lambert and Phong shading": the first heading of the chapter's lesson, which is the list of titles that everything
    shows; without a lesson, the folder's name in words."""
    number, _, name = chapter.partition("_")
    lesson = ROOT / "docs" / f"{chapter}.md"
    heading = lesson.read_text(encoding="utf-8").partition("\n")[0] if lesson.exists() else ""
    found = re.fullmatch(r"#\s+(?:[Cc]hapter\s+)?(?:\d+[a-z]?\s*[:.·–-]*\s*)?(.*\S)\s*", heading)
    title = found[1] if found else name.replace("_", " ").capitalize()
    return f"{number} {title}" if name else chapter


def chapter_program(chapter: str) -> Path:
    return BUILD / "chapters" / chapter


def shots(chapter: str) -> list[dict]:
    """The chapter's named pictures, as shots.py describes them. Empty where it has none."""
    path = ROOT / "tests" / chapter / "shots.json"
    if not path.exists():
        return []
    try:
        return json.loads(path.read_text())["shots"]
    except (ValueError, KeyError, TypeError) as error:
        raise Failure(f"{path.relative_to(ROOT)} is not a list of shots: {error}") from None


def best_first(chapter: str) -> list[dict]:
    """The chapter's shots, the one that shows it best first: "best" in shots.json, without it the first."""
    found = shots(chapter)
    path = ROOT / "tests" / chapter / "shots.json"
    best = json.loads(path.read_text()).get("best") if found else None
    return sorted(found, key=lambda shot: shot["name"] != best)


def find_shots(word: str) -> list[tuple[str, dict]]:
    """(chapter, shot) for "", "02", "02.SHOT" or "02_lambert_phong.SHOT"."""
    chapter_word, dot, shot_word = word.partition(".")
    if dot and not shot_word:
        raise UsageError(f"'{word}' names no shot; {chapter_word or '02'} means all of a chapter")
    named = [find_chapter(chapter_word)] if chapter_word else chapters()
    found = [(chapter, shot) for chapter in named for shot in shots(chapter)
             if not shot_word or shot["name"] == shot_word]
    if not found:
        names = [f"{chapter[:2]}.{shot['name']}" for chapter in named for shot in shots(chapter)]
        raise UsageError(f"there is no shot '{word}'; {nearest(word, names)}; ./course run NN --list shots lists those of a chapter")
    return found


def exercises(chapter: str) -> dict[str, Path]:
    """The chapter's exercises by id, "02.phong", and the one file of each."""
    found = {}
    for folder in (ROOT / "chapters" / chapter / "exercise", ROOT / "shaders" / chapter / "exercise"):
        for path in folder.glob("*.*"):
            if path.suffix in (".cpp", ".glsl"):
                found[f"{chapter[:2]}.{path.stem}"] = path
    return dict(sorted(found.items()))


def has_solutions() -> bool:
    return any(ROOT.glob("chapters/*/solution")) or any(ROOT.glob("shaders/*/solution"))


def is_edited(path: Path) -> bool:
    """True where git knows that a file is not as it was committed."""
    if not (ROOT / ".git").exists():
        return False
    return subprocess.run(["git", "-C", ROOT, "diff", "--quiet", "HEAD", "--", path],
                          stderr=subprocess.DEVNULL).returncode == 1


def git(*words: str) -> bytes:
    """Output of git. Raises Failure with its first line."""
    try:
        done = subprocess.run(["git", "-C", ROOT, *words], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE)
    except FileNotFoundError:
        raise Failure("there is no git, which this copy's list of files is asked from") from None
    said = done.stderr.decode(errors="replace").strip().splitlines() or [f"it ended with {done.returncode}"]
    if "dubious ownership" in said[0]:
        raise Failure(f"git does not trust this copy, which is another user's: git config --global --add safe.directory "
                      f"'{ROOT}'")
    if done.returncode:
        raise Failure(f"git {words[0]}: {said[0]}")
    return done.stdout


def files() -> list[Path]:
    """The files of the course, relative to the root: those that git tracks or would add, without the build."""
    if (ROOT / ".git").exists():
        listed = os.fsdecode(git("ls-files", "-z", "--cached", "--others", "--exclude-standard")).split("\0")
        return sorted(Path(name) for name in listed if name and (ROOT / name).is_file())
    return walk(ROOT)


def walk(root: Path) -> list[Path]:
    """The files below a folder, relative to it, without the build."""
    found = []
    for folder, folders, names in os.walk(root):
        built = ("__pycache__", ".git", *(["build"] if Path(folder) == root else []))
        folders[:] = [name for name in folders if name not in built]
        found += [(Path(folder) / name).relative_to(root) for name in names]
    return sorted(found)


def relative(path: Path) -> str:
    """How a path is printed: from the root where it lies in the tree."""
    path = Path(path)
    return str(path.relative_to(ROOT)) if path.is_relative_to(ROOT) else str(path)


def write_atomically(path: Path, data: bytes | str, mode: int | None = None):
    """Writes beside `path` and renames: a reader sees the old file or the whole new one."""
    path.parent.mkdir(parents=True, exist_ok=True)
    beside = path.with_name(f".{path.name}.{os.getpid()}.{threading.get_ident():x}")
    try:
        if mode is not None:  # before there is anything in it to be read
            beside.touch(mode)
            beside.chmod(mode)
        beside.write_bytes(data.encode() if isinstance(data, str) else data)
        os.replace(beside, path)
    finally:
        beside.unlink(missing_ok=True)


def has_display() -> bool:
    return bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))


def cores() -> int:
    """Number of threads this process may keep busy: Slurm's limit, else its processors."""
    given = os.environ.get("SLURM_CPUS_PER_TASK", "")
    return int(given) if given.isdigit() and int(given) else len(os.sched_getaffinity(0))


RUN = "run.json"  # in the build folder, while ./course test runs its tests


def test_run() -> dict:
    """The run of ./course test that this is part of: {"pid", "name", "part"}, where part means that a test of many like
    cases tries some of them. Empty outside of a run."""
    try:
        run = json.loads((BUILD / RUN).read_text())
    except (OSError, ValueError):
        return {}
    return run if os.path.exists(f"/proc/{run['pid']}") else {}


def say(line: str = ""):
    print(line, flush=True)


def warn(line: str):
    print(line, file=sys.stderr, flush=True)


def run_on_chapter(main):
    """A script's whole command line, one chapter's name: main(NN_name) returns a line for each problem."""
    if len(sys.argv) != 2:
        warn(f"usage: {Path(sys.argv[0]).stem} NN_name")
        sys.exit(2)
    try:
        problems = main(sys.argv[1])
    except Failure as error:
        problems = [str(error)]
    for problem in problems:
        say(problem)
    sys.exit(1 if problems else 0)
