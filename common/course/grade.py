"""Checks what students handed in, each in turn in one scratch copy of this tree.

A submission is a folder or an archive that holds a student's tree, or some of it: of it the exercise files alone are
read (chapters/NN_name/exercise/*, shaders/NN_name/exercise/*), so that a student's checks and framework count for
nothing. What one leaves out counts as handed out.
"""

import json
import shutil
import tarfile
import zipfile
from pathlib import Path

from build import BuildFailure, configure, is_configured, run_ninja
from check import check
from tree import ROOT, Failure, UsageError, chapters, exercises, files, find_chapter, say

HELP = """Checks the exercises that students handed in, against this tree's checks: one line per student.

Each PATH is a folder with a student's course in it, or a .zip or .tar.* of one. A folder without a course in it is taken
for a folder of such folders and archives. It builds and runs the students' code: do that on a machine or in a container
that you can lose. Exit code 0 whatever the grades are."""
ARCHIVES = (".zip", ".tar", ".tar.gz", ".tgz", ".tar.xz", ".tar.bz2")
MAX_FILE_BYTES = 1 << 20


def add_arguments(parser):
    parser.add_argument("paths", nargs="+", type=Path, metavar="PATH")
    parser.add_argument("--chapter", metavar="NN", help="this chapter's exercises alone")
    parser.add_argument("--json", action="store_true", help="one JSON object per student, with what is wrong")


def run(arguments, _rest) -> int:
    named = [find_chapter(arguments.chapter)] if arguments.chapter else chapters()
    wanted = {exercise: chapter for chapter in named for exercise in exercises(chapter)}
    submissions = [found for path in arguments.paths for found in find_submissions(path)]
    scratch = make_scratch()
    for path in submissions:
        try:
            grade = {"error": None, "results": grade_one(read_submission(path), scratch, wanted)}
        except Failure as failure:
            grade = {"error": str(failure), "results": []}
        show({"student": student_of(path), **grade}, len(wanted), arguments.json)
    return 0


def find_submissions(path: Path) -> list[Path]:
    if not path.exists():
        raise UsageError(f"{path}: there is no such file or folder")
    if path.is_file() or (path / "chapters").is_dir() or (path / "shaders").is_dir():
        return [path]
    found = sorted(child for child in path.iterdir() if child.is_dir() or child.name.endswith(ARCHIVES))
    if not found:
        raise UsageError(f"{path}: there is no submission in it")
    return found


def student_of(path: Path) -> str:
    name = path.absolute().name
    return next((name[:-len(end)] for end in ARCHIVES if name.endswith(end)), name)


def read_submission(path: Path) -> dict[str, bytes]:
    """The exercise files in it, by their path in the tree. Nothing is unpacked. Raises Failure."""
    wanted = {str(file.relative_to(ROOT)) for chapter in chapters() for file in exercises(chapter).values()}
    found = {}
    try:
        for name, size, read in members(path):
            # The tree may lie in one folder of its own.
            inside = next((part for part in (name, name.partition("/")[2]) if part in wanted), None)
            if inside and size <= MAX_FILE_BYTES:
                found[inside] = read()
    except (OSError, tarfile.TarError, zipfile.BadZipFile, EOFError, RuntimeError) as error:
        raise Failure(f"cannot be read: {error}") from None
    if not found:
        raise Failure("holds no exercise")
    return found


def members(path: Path):
    """(name, bytes, a function that reads it) of each ordinary file."""
    if path.is_dir():
        for pattern in ("*/*/exercise/*", "*/*/*/exercise/*"):
            for file in path.glob(pattern):
                if file.is_file() and not file.is_symlink():
                    yield str(file.relative_to(path)), file.stat().st_size, file.read_bytes
    elif path.name.endswith(".zip"):
        with zipfile.ZipFile(path) as archive:
            for info in archive.infolist():
                yield info.filename.removeprefix("./"), info.file_size, lambda info=info: archive.read(info)
    else:
        with tarfile.open(path) as archive:
            for info in archive:
                if info.isfile():
                    yield info.name.removeprefix("./"), info.size, lambda info=info: archive.extractfile(info).read()


def make_scratch() -> Path:
    """A copy of this tree that is kept, so that the next student costs no more than the files that differ."""
    scratch = ROOT / "build" / "grade"
    present = {name for name in files() if not (ROOT / name).is_symlink()}
    for name in present:
        write_if_new(scratch / name, (ROOT / name).read_bytes())
        shutil.copymode(ROOT / name, scratch / name)
    for old in [path for path in scratch.rglob("*") if path.is_file()]:
        inside = old.relative_to(scratch)
        if inside.parts[0] != "build" and inside not in present:
            old.unlink()
    return scratch


def write_if_new(path: Path, data: bytes):
    if not path.exists() or path.read_bytes() != data:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)


def grade_one(submitted: dict[str, bytes], scratch: Path, wanted: dict[str, str]) -> list[dict]:
    """What check says of each exercise wanted. One that does not compile is as if it were not handed in."""
    broken = {}
    place(submitted, scratch)
    targets = [f"check_{chapter}" for chapter in sorted(set(wanted.values()))]
    folder = scratch / "build"
    folder.mkdir(exist_ok=True)
    if not is_configured(folder, scratch):
        configure("default", folder, scratch)
    try:
        run_ninja(folder, ["-k", "0", *targets])
    except BuildFailure as failure:
        broken = why_not_built(submitted, failure.said)
        place({name: data for name, data in submitted.items() if name not in broken}, scratch)
        run_ninja(folder, targets)
    results = [check(chapter, exercise, root=scratch) for exercise, chapter in wanted.items()]
    for result in results:
        if result["file"] in broken:
            result |= {"ok": False, "first_failure": broken[result["file"]]}
    return results


def why_not_built(submitted: dict[str, bytes], said: str) -> dict[str, str]:
    """The files that the compiler complains about, and how; where it is the linker that does, every C++ file."""
    found = {}
    for line in said.splitlines():
        for name in submitted:
            if f"{name}:" in line and "error" in line:
                found.setdefault(name, f"it does not compile: {line.partition(name)[2][1:]}")
    undefined = next((line for line in said.splitlines() if "undefined" in line), "the build failed")
    return found or {name: f"it does not link: {undefined}" for name in submitted if name.endswith(".cpp")}


def place(submitted: dict[str, bytes], scratch: Path):
    """Puts the exercises into the scratch tree: the student's, or as handed out."""
    for chapter in chapters():
        for file in exercises(chapter).values():
            name = str(file.relative_to(ROOT))
            write_if_new(scratch / name, submitted[name] if name in submitted else file.read_bytes())


def show(grade: dict, count: int, as_json: bool):
    if as_json:
        say(json.dumps(grade, ensure_ascii=False))
        return
    right = sum(result["ok"] for result in grade["results"])
    still = [result["exercise"] for result in grade["results"] if not result["ok"]]
    what = grade["error"] or ("open: " + ", ".join(still) if still else "")
    say(f"{grade['student']:24} {right} of {count}  {what}".rstrip())
