"""Copies the course without its solutions, for students."""

import contextlib
import io
import json
import os
import platform
import re
import shlex
import shutil
import subprocess
import tempfile
import zipfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from build.build import build
from check.reset import KEPT
from check.starters import LIST, as_they_stand, listed
from progress import Progress
from tree import BUILD, ROOT, Failure, UsageError, chapters, exercises, files, git, relative, say, warn

HELP = """Copies the course to a new FOLDER without the solutions, for students.

The copy has the lessons, starters, checks and goldens, but no history. ./course run, check and test work in it; tests that
need a reference for drawing are left out. Only files known to git are handed out, with the exercises as committed: your own
answers are not copied.

Code that would give answers away (the checks and their references) is handed out compiled: the students' machines need the
same kind of processor and the same release of the system as this one. --sources hands it out as source.

  ./course handout FOLDER --autograder    an autograder for Gradescope and a workflow for GitHub Classroom; --autograder --help"""

# Compiled on this machine, as an object beside where the source was.
COMPILED = ("tests/*/checks_*.cpp", "chapters/01_obj/scan.cpp", "chapters/01_obj/load_bench.cpp",
            "chapters/07_mipmaps/level_view.cpp", "chapters/07_mipmaps/texels.cpp", "chapters/09_post_effects/white_point.cpp")
# Not handed out: files that the above includes, tests of those (and tests that include them), and answers with their
# verdicts.
LEFT_OUT = ("chapters/*/*truth.h", "chapters/*/table/*", "tests/*/variants/*", "tests/*/test_stability.cpp",
            "tests/01_obj/test_floats.cpp", "tests/01_obj/test_loaders.cpp", "tests/common/*grad*.py",
            "tests/common/hostile*.py")


HEADER = "CMakeFiles/lightwalk.dir/cmake_pch.hxx.gch"  # precompiled, with nothing of a solution in it
TRUTH = "5truth"  # lightwalk::truth, as compilers write it


def add_arguments(parser):
    parser.add_argument("folder", metavar="FOLDER", type=Path)
    parser.add_argument("--sources", action="store_true", help="hand out the checks as sources, which contain the answers")


def run(arguments, _rest) -> int:
    with new_folder(arguments.folder) as beside:
        contents = what_is_handed_out(arguments.sources)
        for name, source in contents.items():
            (beside / name).parent.mkdir(parents=True, exist_ok=True)
            if isinstance(source, bytes):
                (beside / name).write_bytes(source)
            else:
                shutil.copy2(source, beside / name, follow_symlinks=False)
    count = sum(len(exercises(chapter)) for chapter in chapters())
    say(f"{arguments.folder}: {len(contents)} files, {count} exercises, no solutions")
    return 0


@contextlib.contextmanager
def new_folder(folder: Path):
    """A folder to fill, which takes its place when it is whole. Raises UsageError where it cannot: before minutes of work, not behind
    them."""
    place = Path(os.path.realpath(folder))  # a link's target is filled, not the link replaced
    if os.path.lexists(place) and (not place.is_dir() or any(place.iterdir())):
        raise UsageError(f"{folder} exists; name a folder that does not")
    if place.is_relative_to(ROOT):
        raise UsageError(f"{folder} lies in the course itself; name a folder outside of it")
    is_there = place.is_dir()  # where one works in it, or another disc begins there: it stays, and is filled
    try:
        place.parent.mkdir(parents=True, exist_ok=True)
        beside = Path(tempfile.mkdtemp(prefix=f".{place.name}.", dir=place if is_there else place.parent))
    except OSError as error:
        raise UsageError(f"{folder} cannot be written: {error.strerror}") from None
    try:
        yield beside
        if is_there:
            for one in beside.iterdir():
                one.rename(place / one.name)
            beside.rmdir()
        else:
            beside.chmod(0o755)
            beside.rename(place)
    except BaseException:
        shutil.rmtree(beside, ignore_errors=True)
        raise


def what_is_handed_out(sources: bool) -> dict[Path, Path | bytes]:
    names = [name for name in tracked() if "solution" not in name.parts[:-1]]
    contents = {name: ROOT / name for name in names}
    committed = starters(names)
    contents |= committed
    contents[LIST] = listed(as_they_stand() | committed).encode()
    contents[KEPT] = zipped(as_they_stand() | committed)
    if sources:
        return contents
    hidden = [name for name in names if any(name.match(pattern) for pattern in COMPILED)]
    for name, compiled in objects(hidden).items():
        del contents[name]
        contents[name.with_suffix(".o")] = compiled
    left_out = {name for name in contents if any(name.match(pattern) for pattern in LEFT_OUT)}
    left_out |= tests_that_include(left_out, contents)
    contents = {name: source for name, source in contents.items() if name not in left_out}
    return contents | ({Path("compiled_for"): f"{platform.machine()}\n".encode()} if hidden else {})


def zipped(texts: dict[Path, bytes]) -> bytes:
    """The starters, for ./course reset: the same bytes each time."""
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as kept:
        for name, text in sorted(texts.items()):
            kept.writestr(zipfile.ZipInfo(name.as_posix()), text, zipfile.ZIP_DEFLATED)
    return out.getvalue()


def tests_that_include(left_out: set[Path], contents) -> set[Path]:
    """Tests that do not compile without the omitted files, directly or through another such test."""
    found = set()
    while more := {name for name in contents if name.parts[0] == "tests" and name.suffix in (".cpp", ".h")
                   and name not in left_out | found
                   and any(meant_by(name, one) & (left_out | found) for one in includes((ROOT / name).read_text(encoding="utf-8")))}:
        found |= more
    return found


def includes(text: str) -> list[str]:
    return re.findall(r'^\s*#\s*include\s*"([^"]+)"', text, re.M)


def meant_by(name: Path, include: str) -> set[Path]:
    """Files of the course that an include may refer to."""
    return {Path(os.path.normpath(folder / include))
            for folder in (name.parent, *map(Path, ("chapters", "tests", "shaders", ".")))}


def tracked() -> list[Path]:
    if not (ROOT / ".git").exists():
        warn("without git's history all files are handed out, and the exercises as they stand")
        return files()
    listed = os.fsdecode(git("ls-files", "-z", "--cached")).split("\0")
    return sorted(Path(name) for name in listed if name and (ROOT / name).is_file())


def starters(names: list[Path]) -> dict[Path, bytes]:
    """The exercises as they were committed. Says which of them differ here."""
    if not (ROOT / ".git").exists():
        return {}
    found = {name: git("show", f"HEAD:{name.as_posix()}") for name in names
             if "exercise" in name.parts[:-1] and git("ls-tree", "HEAD", "--", name.as_posix())}
    for name, starter in found.items():
        if (ROOT / name).read_bytes() != starter:
            warn(f"{name}: handed out as committed; changes here are not included")
    return found


def objects(names: list[Path]) -> dict[Path, bytes]:
    """Each source compiled in a tree without solutions and without this machine's paths."""
    if not names:
        return {}
    build([HEADER])
    commands = compiled_by()
    with tempfile.TemporaryDirectory() as made, Progress("compiling the checks") as progress, \
            ThreadPoolExecutor(os.cpu_count()) as pool:
        found = {}
        for name, compiled in zip(names, pool.map(lambda name: compile_one(ROOT / name, commands[ROOT / name], Path(made)), names)):
            found[name] = compiled
            progress.show(len(found), len(names), str(name))
    return found


def compiled_by() -> dict[Path, dict]:
    """The entry of compile_commands.json for each source, of several compiled together the same."""
    found = {}
    for entry in json.loads((BUILD / "compile_commands.json").read_text(encoding="utf-8")):
        unit = Path(entry["file"])
        sources = re.findall('#include "(.*)"', unit.read_text(encoding="utf-8")) if "Unity" in unit.parts else [unit]
        found |= {Path(source): entry for source in sources}
    return found


def compile_one(source: Path, entry: dict, folder: Path) -> bytes:
    words = shlex.split(entry["command"])
    compiled = folder / str(source).strip("/").replace("/", ".")
    words[words.index("-o") + 1], words[words.index("-c") + 1] = str(compiled), str(source)
    prefix = f"-ffile-prefix-map={ROOT}=."
    # Reference functions are local symbols: a global name would be an answer of one line. A header's function is in a
    # group, by which the linker would not find it under a name of its own. Outside of groups no symbol may be unique:
    # some linkers refuse the second one.
    whole = compiled.with_suffix(".whole.o")

    def run_tool(*command) -> str:
        done = subprocess.run(command, cwd=entry["directory"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
        if done.returncode:
            raise Failure(f"{relative(source)} could not be compiled for the handout: {done.stdout.strip()}")
        return done.stdout

    run_tool(*words, "-DLIGHTWALK_NO_SOLUTION", "-g0", "-fno-gnu-unique", prefix)
    run_tool("ld", "-r", "--force-group-allocation", "-o", whole, compiled)
    names = re.findall(rf" [A-TV-Za-tv-z] (\w*9lightwalk{TRUTH}\w*)$", run_tool("nm", whole), re.M)
    run_tool("objcopy", *[f"--localize-symbol={name}" for name in sorted(set(names))], whole)
    run_tool("strip", "--strip-unneeded", whole)
    return whole.read_bytes()
