"""Checks what students handed in, each in turn in one scratch copy of this tree.

A submission is a folder or an archive that holds a student's tree, or some of it: of it the exercise files alone are
taken (chapters/NN_name/exercise/*, shaders/NN_name/exercise/*), so that a student's checks and framework count for
nothing. What one leaves out counts as handed out.
"""

import json
import shutil
import subprocess
import tempfile
from pathlib import Path

from build import configure, is_configured, run_ninja
from check import check
from tree import ROOT, Failure, UsageError, chapters, exercises, files, find_chapter, say

HELP = """Checks the exercises that students handed in, against this tree's checks: one line per student.

Each PATH is a folder with a student's course in it, or a .zip or .tar.* of one. A folder without a course in it is taken
for a folder of such folders and archives. It builds and runs the students' code: do that on a machine or in a container
that you can lose."""


def add_arguments(parser):
    parser.add_argument("paths", nargs="+", type=Path, metavar="PATH")
    parser.add_argument("--chapter", default="", metavar="NN", help="this chapter's exercises alone")
    parser.add_argument("--json", action="store_true", help="one JSON object per student, with what is wrong")


def run(arguments, _rest) -> int:
    wanted = [(chapter, exercise) for chapter in chapters() for exercise in exercises(chapter)
              if exercise.startswith(chapter_number(arguments.chapter))]
    submissions = [found for path in arguments.paths for found in find_submissions(path)]
    scratch = make_scratch()
    for path in submissions:
        with tempfile.TemporaryDirectory(prefix="lightwalk.") as unpacked:
            try:
                grade = grade_one(top_of(path, Path(unpacked)), scratch, wanted)
            except Failure as failure:
                grade = {"error": str(failure), "results": []}
        show({"student": student_of(path), **grade}, len(wanted), arguments.json)
    return 0


def chapter_number(word: str) -> str:
    return find_chapter(word)[:3].replace("_", ".") if word else ""


def find_submissions(path: Path) -> list[Path]:
    if not path.exists():
        raise UsageError(f"{path}: there is no such file or folder")
    if path.is_file() or holds_course(path):
        return [path]
    found = sorted(child for child in path.iterdir() if child.is_dir() or is_archive(child))
    if not found:
        raise UsageError(f"{path}: there is no submission in it")
    return found


def is_archive(path: Path) -> bool:
    return any(path.name.endswith(end) for _, ends, _ in shutil.get_unpack_formats() for end in ends)


def holds_course(folder: Path) -> bool:
    return (folder / "chapters").is_dir() or (folder / "shaders").is_dir()


def student_of(path: Path) -> str:
    name = path.absolute().name
    for _, ends, _ in shutil.get_unpack_formats():
        for end in ends:
            name = name.removesuffix(end)
    return name


def top_of(path: Path, unpacked: Path) -> Path:
    """The folder that holds the student's tree. Raises Failure where there is none."""
    if path.is_file():
        try:
            # The data filter, where Python has it, keeps an archive from writing outside of the folder.
            shutil.unpack_archive(path, unpacked)
        except (shutil.ReadError, ValueError, OSError) as error:
            raise Failure(f"cannot be unpacked: {error}") from None
        path = unpacked
    for folder in [path, *sorted(child for child in path.iterdir() if child.is_dir())]:
        if holds_course(folder):
            return folder
    raise Failure("holds neither chapters/ nor shaders/")


def make_scratch() -> Path:
    """A copy of this tree that is kept, so that the next student costs no more than the files that differ."""
    scratch = ROOT / "build" / "grade"
    present = {name for name in files() if not (ROOT / name).is_symlink()}
    for name in present:
        write_if_new(scratch / name, (ROOT / name).read_bytes())
    for old in [path for path in scratch.rglob("*") if path.is_file()]:
        inside = old.relative_to(scratch)
        if inside.parts[0] != "build" and inside not in present:
            old.unlink()
    return scratch


def write_if_new(path: Path, data: bytes):
    if not path.exists() or path.read_bytes() != data:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)


def grade_one(student: Path, scratch: Path, wanted: list) -> dict:
    for chapter in chapters():
        for file in exercises(chapter).values():
            name = file.relative_to(ROOT)
            theirs = student / name
            given = theirs.is_file() and not theirs.is_symlink()
            write_if_new(scratch / name, theirs.read_bytes() if given else file.read_bytes())
    folder = scratch / "build"
    folder.mkdir(exist_ok=True)
    if not is_configured(folder, scratch):
        configure("default", folder, scratch)
    try:
        run_ninja(folder, [f"check_{chapter}" for chapter in sorted({chapter for chapter, _ in wanted})])
    except Failure:
        for chapter in {chapter for chapter, _ in wanted}:  # what an earlier student's code was built to
            (folder / "tests" / f"check_{chapter}").unlink(missing_ok=True)
        return {"error": "does not compile", "results": []}
    return {"error": None, "results": [check(chapter, exercise, root=scratch) for chapter, exercise in wanted]}


def show(grade: dict, exercises_wanted: int, as_json: bool):
    if as_json:
        say(json.dumps(grade, ensure_ascii=False))
        return
    right = [result for result in grade["results"] if result["ok"]]
    still = [result["exercise"] for result in grade["results"] if not result["ok"]]
    say(f"{grade['student']:24} {len(right)} of {exercises_wanted}  {grade['error'] or ' '.join(still)}".rstrip())
