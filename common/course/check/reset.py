"""Puts an exercise's starter back."""

import itertools
import os
import zipfile
import zlib
from pathlib import Path

from check.check import select
from check.starters import LIST, digest
from tree import ROOT, Failure, UsageError, exercises, git, relative, say, write_atomically

HELP = """Restores the starter of an exercise. Your answer is kept beside it.

  ./course reset 02.phong"""
KEPT = Path("tests/starters.zip")  # of a handout, which has no history


def add_arguments(parser):
    parser.add_argument("exercise", metavar="NN.NAME")


def run(arguments, _rest) -> int:
    if "." not in arguments.exercise:
        raise UsageError(f"'{arguments.exercise}' names no exercise; ./course reset 02.phong resets one")
    [(chapter, exercise)] = select(arguments.exercise)
    path = exercises(chapter)[exercise]
    there = path.read_bytes()
    starter = starter_of(path)
    if there == starter:
        say(f"{relative(path)} is the starter")
        return 0
    old = next(name for number in itertools.count(1) if not (name := path.with_name(f"{path.name}.{number}.old")).exists())
    write_atomically(old, there)
    write_atomically(path, starter, path.stat().st_mode & 0o777)
    say(f"{relative(path)} is the starter again; your answer is {relative(old)}")
    return 0


def starter_of(path: Path) -> bytes:
    """The starter: from the handout's own copy, else the version in the history that the list names."""
    name = relative(path)
    wanted = next((line.split()[0] for line in (ROOT / LIST).read_text(encoding="utf-8").splitlines() if line.endswith(f" {name}")), None)
    if (ROOT / KEPT).exists():
        try:
            with zipfile.ZipFile(ROOT / KEPT) as kept:
                return kept.read(name)
        except KeyError:  # of a chapter that is newer than the handout
            pass
        except (zipfile.BadZipFile, zlib.error, EOFError):
            raise Failure(f"{KEPT} is damaged; a new copy of the course has it") from None
    if (ROOT / ".git").exists():
        for commit in os.fsdecode(git("log", "--format=%H", "--", name)).split():
            if git("ls-tree", commit, "--", name) and digest(found := git("show", f"{commit}:{name}")) == wanted:
                return found
    if digest(there := path.read_bytes()) == wanted:
        return there
    raise Failure(f"there is no starter of {name} here: neither {KEPT} nor git's history has it; a new copy of the course does")
