"""Copies the course without its solutions, for students."""

import os
import shutil
import tempfile
from pathlib import Path

from tree import ROOT, UsageError, chapters, exercises, files, say

HELP = """Copies the course to a new FOLDER without the solutions: what students are given.

The copy has the lessons, starters, checks and goldens, and no history. ./course run, check and test work in it; a test
that needs a reference to draw with is not in it."""


def add_arguments(parser):
    parser.add_argument("folder", metavar="FOLDER", type=Path)


def run(arguments, _rest) -> int:
    folder = arguments.folder.absolute()
    if folder.exists() and (not folder.is_dir() or any(folder.iterdir())):
        raise UsageError(f"{arguments.folder} exists; name a folder that does not")
    if folder.resolve().is_relative_to(ROOT):
        raise UsageError(f"{arguments.folder} lies in the course itself; name a folder outside of it")
    names = [name for name in files() if "solution" not in name.parts[:-1]]
    try:
        folder.parent.mkdir(parents=True, exist_ok=True)
        beside = Path(tempfile.mkdtemp(prefix=f".{folder.name}.", dir=folder.parent))
    except OSError as error:
        raise UsageError(f"{arguments.folder} cannot be written: {error.strerror}") from None
    try:
        for name in names:
            (beside / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / name, beside / name, follow_symlinks=False)
        beside.chmod(0o755)
        os.replace(beside, folder)  # an empty folder there is replaced
    except BaseException:
        shutil.rmtree(beside, ignore_errors=True)
        raise
    count = sum(len(exercises(chapter)) for chapter in chapters())
    say(f"{arguments.folder}: {len(names)} files, {count} exercises, no solutions")
    return 0
