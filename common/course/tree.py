"""The course's tree: where things lie, which chapters and shots there are, and how a command says that it cannot."""

import contextlib
import difflib
import errno
import functools
import json
import os
import re
import shlex
import socket
import subprocess
import sys
import tempfile
import threading
from collections.abc import Iterable
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
# A test of another build folder (the sanitizers') says so in the environment.
BUILD = Path(os.environ.get("LIGHTWALK_BUILD", ROOT / "build"))
LIBRARIES = tuple(BUILD / f"lib{name}.so" for name in ("lightwalk", "lightwalk_check"))  # common, for all programs
SHADER_CACHE = Path(os.environ.get("LIGHTWALK_CACHE", ROOT / "build" / "shader_cache"))  # as common/base/kept.h says


# Python as ./course starts it (sys.executable has Debian's packages): PYTHON* and the locale's encoding change nothing.
PYTHON = (sys.executable, "-E", "-X", "utf8")

# What programs that the course starts have of the environment: who and where the user is, the display, proxies, which driver and
# card are used, sanitizers' options, and the course's own. Flags of compilers, CMake, ninja, layers and loaders change nothing.
KEPT = re.compile(r"""PATH|HOME|USER|LOGNAME|SHELL|TERM|COLORTERM|COLUMNS|LINES|NO_COLOR|LANG|LANGUAGE|LC_\w+|TZ|TMPDIR|PWD|HOSTNAME
|DISPLAY|WAYLAND_\w+|XAUTHORITY|XDG_\w+|DBUS_\w+|PULSE_\w+|PIPEWIRE_\w+|ALSA_\w+|SSH_\w+|WSL\w*|BROWSER|EDITOR|VISUAL|PAGER
|\w+_proxy|\w+_PROXY|SSL_CERT_\w+|CI|GITHUB_\w+|RUNNER_\w+|SLURM_\w+|SBATCH_\w+|SOURCE_DATE_EPOCH|CCACHE_DIR|LD_LIBRARY_PATH|LD_PRELOAD
|VK_DRIVER_FILES|VK_ICD_FILENAMES|VK_ADD_DRIVER_FILES|DRI_PRIME|MESA_VK_DEVICE_SELECT|MESA_SHADER_CACHE_DIR|MESA_SHADER_CACHE_DISABLE
|__NV_PRIME_RENDER_OFFLOAD|__VK_LAYER_NV_optimus|NVIDIA_\w+|CUDA_VISIBLE_DEVICES|GALLIUM_OVERRIDE_CPU_CAPS|GALLIVM_PERF|LP_NUM_THREADS
|MALLOC_PERTURB_|[AL]SAN_OPTIONS|UBSAN_OPTIONS|ENABLE_VULKAN_RENDERDOC_CAPTURE|RENDERDOC_\w+|DEBIAN_FRONTEND|npm_\w+|NODE_PATH|FONTCONFIG_\w+
|MOZ_\w+|LIGHTWALK_\w+""".replace("\n", ""))


def keep_environment():
    for name in [name for name in os.environ if not KEPT.fullmatch(name)]:
        del os.environ[name]
    if not os.access(os.path.expanduser("~"), os.W_OK):  # nobody's, or that of a container's user: ccache and matplotlib end there
        os.environ["HOME"] = str(ROOT / "build" / "home")


CLOSED = (errno.EROFS, errno.EACCES, errno.EPERM, errno.ENOSPC)  # of a folder that cannot be written
FULL = (errno.ENOSPC, errno.EDQUOT)  # of a disc


class UsageError(Exception):
    """An impossible command: one line with the remedy. Exit code 2. An empty line where all is said already."""


class Failure(Exception):
    """It was tried and failed: one line. Exit code 1. An empty line where all is said already."""


class Unjudged(Failure):
    """A known answer has no verdict here. Exit code 3; nothing is kept."""


def unjudged(exercise: str, why: str) -> Unjudged:
    return Unjudged(f"this machine cannot judge {exercise}: {why}{machine_words()}")


def machine_words() -> str:
    """What is known to keep a machine from judging, with the way out; empty for nothing."""
    folder, found = Path(tempfile.gettempdir()), ""
    try:
        at = os.statvfs(folder)
        if at.f_flag & os.ST_NOEXEC:
            found = f"; no program runs in the temporary folder {folder} (it is mounted noexec): TMPDIR=FOLDER names another"
        elif at.f_bavail * at.f_frsize < 1 << 26 or at.f_files and not at.f_favail:
            found = f"; the temporary folder {folder} is full: make room, or TMPDIR=FOLDER names another"
    except OSError:
        pass
    return found


def copy_words() -> str:
    """What to type where the course's folder cannot be written, or its disc is full."""
    home = Path(os.path.expanduser("~"))  # as it is where there is none
    place = home if os.access(home, os.W_OK) and not home.is_relative_to(ROOT) else Path(tempfile.gettempdir())
    copy = next(path for number in range(1, 1000) if not (path := place / f"lightwalk{number if number > 1 else ''}").exists())
    return f"; what is built goes below the course; for a copy of your own, type cp -r {shlex.quote(str(ROOT))} {shlex.quote(str(copy))}"


def unwritable(folder: Path, error: OSError) -> UsageError:
    return UsageError(f"{folder} cannot be written: {error.strerror}{copy_words() if folder.is_relative_to(ROOT) else ''}")


SOURCE = re.compile(r"[A-Za-z0-9]\w*(\.[A-Za-z0-9]+)+")
MANIFEST = Path("tests/starters.txt")  # of the exercises, with digests of their starters


def is_source(path: Path) -> bool:
    """False for an editor's lock, a backup, a resource fork, a copy with a blank in its name, a link to nothing."""
    return SOURCE.fullmatch(path.name) is not None and path.is_file()


def sources(folder: Path, pattern: str) -> list[Path]:
    """Those below a folder whose path is like the pattern, in order."""
    return [path for path in sorted(folder.glob(pattern)) if is_source(path)]


def manifest() -> dict[str, list[Path]]:
    """The exercises' files by chapter, from the root."""
    try:
        at = (ROOT / MANIFEST).stat()
    except OSError:
        return {}
    return read_manifest(ROOT / MANIFEST, at.st_mtime_ns, at.st_size)


@functools.lru_cache(4)
def read_manifest(path: Path, *_) -> dict[str, list[Path]]:
    found = {}
    for line in path.read_text(encoding="utf-8", errors="replace").splitlines():
        name = Path(line.partition(" ")[2])
        if len(name.parts) == 4:
            found.setdefault(name.parts[1], []).append(name)
    return found


def chapters() -> list[str]:
    """The chapters' names, "01_obj" and so on, in order. Of several folders of one number those in the manifest."""
    folders = sorted(path.name for path in (ROOT / "chapters").glob("[0-9][0-9]_*") if re.fullmatch(r"\w+", path.name) and path.is_dir())
    numbers = {name[:2] for name in folders if name in manifest()}
    return [name for name in folders if name in manifest() or name[:2] not in numbers]


def left_alone() -> list[str]:
    known = {path for chapter in chapters() for path in exercises(chapter).values()}
    found = [path for path in (ROOT / "chapters").glob("[0-9][0-9]_*") if path.is_dir() and path.name not in chapters()]
    for chapter in chapters():
        for folder in (ROOT / "chapters" / chapter / "exercise", ROOT / "shaders" / chapter / "exercise"):
            if folder.is_dir():
                found += [path for path in folder.iterdir() if path not in known and path.suffix != ".old"]
    return [relative(path) for path in sorted(found)]


@functools.cache
def say_left_alone():
    """Once for each command."""
    if found := left_alone():
        more = f" and {len(found) - 3} more" if len(found) > 3 else ""
        warn(f"left alone: {', '.join(found[:3])}{more}, not in {MANIFEST}; ./course docs --quote records a new exercise that has a solution")


def shader_files() -> list[Path]:
    known = {path for chapter in chapters() for path in exercises(chapter).values()}
    return [path for path in sources(ROOT / "shaders", "**/*.*") if path.parent.name != "exercise" or path in known]


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


def slug(title: str, _separator: str = "-") -> str:
    """A heading's address as forges make it."""
    return re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")


def chapter_program(chapter: str) -> Path:
    return BUILD / "chapters" / chapter


def shots(chapter: str) -> list[dict]:
    """The chapter's named pictures, as shots.py describes them. Empty where it has none."""
    path = ROOT / "tests" / chapter / "shots.json"
    if not path.exists():
        return []
    try:
        return json.loads(path.read_text(encoding="utf-8"))["shots"]
    except (ValueError, KeyError, TypeError) as error:
        raise Failure(f"{path.relative_to(ROOT)} is not a list of shots: {error}") from None


def best_first(chapter: str) -> list[dict]:
    """The chapter's shots, the one that shows it best first: "best" in shots.json, without it the first."""
    found = shots(chapter)
    path = ROOT / "tests" / chapter / "shots.json"
    best = json.loads(path.read_text(encoding="utf-8")).get("best") if found else None
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
    paths = [ROOT / name for name in manifest().get(chapter, [])] or [
        path for kind in ("chapters", "shaders") for path in (ROOT / kind / chapter / "exercise").glob("*.*")]  # a new chapter's
    return dict(sorted((f"{chapter[:2]}.{path.stem}", path) for path in paths if path.suffix in (".cpp", ".glsl") and is_source(path)))


def has_solutions() -> bool:
    return any(ROOT.glob("chapters/*/solution")) or any(ROOT.glob("shaders/*/solution"))


def is_edited(path: Path) -> bool:
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
        raise Failure("there is no git, which knows this copy's files and starters; as root, type: apt-get install git") from None
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
        found += [path.relative_to(root) for name in names if (path := Path(folder) / name).is_file()]
    return sorted(found)


def relative(path: Path) -> str:
    """How a path is printed: from the root where it lies in the tree."""
    path = Path(path)
    return str(path.relative_to(ROOT)) if path.is_relative_to(ROOT) else str(path)


def write_atomically(path: Path, data: bytes | str, mode: int | None = None):
    """Writes beside `path` and renames: a reader sees the old file or the whole new one. An OSError names `path`."""
    path.parent.mkdir(parents=True, exist_ok=True)
    beside = path.with_name(f".{path.name}.{os.getpid()}.{threading.get_ident():x}")
    try:
        if mode is not None:  # before there is anything in it to be read
            beside.touch(mode)
            beside.chmod(mode)
        beside.write_bytes(data.encode() if isinstance(data, str) else data)
        os.replace(beside, path)
    except OSError as error:
        error.filename, error.filename2 = str(path), None
        raise
    finally:
        with contextlib.suppress(OSError):
            beside.unlink(missing_ok=True)


def has_display() -> bool:
    """Whether somebody answers there. A display that was is said, once."""
    return display_words() == ""


@functools.cache
def display_words() -> str:
    """Why there is no display; empty where there is one."""
    x, wayland = os.environ.get("DISPLAY", ""), os.environ.get("WAYLAND_DISPLAY", "")
    if not x and not wayland:
        return "there is no display to open a window on"
    if wayland and answers(socket.AF_UNIX, os.path.join(os.environ.get("XDG_RUNTIME_DIR", "/"), wayland)):
        return ""
    if found := re.fullmatch(r"(?:unix)?:(\d+)(\.\d+)?", x):
        place = f"/tmp/.X11-unix/X{found[1]}"
        if answers(socket.AF_UNIX, place) or answers(socket.AF_UNIX, f"\0{place}"):
            return ""
    elif found := re.fullmatch(r"([\w.:-]+):(\d+)(\.\d+)?", x):  # as ssh -X has it
        if answers(socket.AF_INET, (found[1], 6000 + int(found[2]))):
            return ""
    elif x:  # of another kind
        return ""
    named = " and ".join(filter(None, (x and f"DISPLAY={x}", wayland and f"WAYLAND_DISPLAY={wayland}")))
    return f"nobody answers at {named}: a display that is gone"


def answers(family, address) -> bool:
    with contextlib.suppress(OSError, ValueError), socket.socket(family, socket.SOCK_STREAM) as one:
        one.settimeout(1)
        one.connect(address)
        return True
    return False


def cores() -> int:
    """Number of threads this process may keep busy: Slurm's limit, else its processors."""
    given = os.environ.get("SLURM_CPUS_PER_TASK", "")
    return int(given) if given.isdigit() and int(given) else len(os.sched_getaffinity(0))


def say(line: str = ""):
    print(line, flush=True)


def warn(line: str):
    print(line, file=sys.stderr, flush=True)


def run_on_chapter(main):
    """A script's whole command line, one chapter's name: main(NN_name) returns a line for each problem."""
    if len(sys.argv) != 2:
        warn(f"usage: {Path(sys.argv[0]).stem} NN_name")
        sys.exit(2)
    problems = main(sys.argv[1])
    for problem in problems:
        say(problem)
    sys.exit(1 if problems else 0)
