"""Removes the build."""

import shutil

from build.build import alone
from tree import BUILD, ROOT, UsageError

HELP = "Removes the build folder: programs, pictures, reports."


def add_arguments(parser):
    pass


def run(_arguments, _rest) -> int:
    if not BUILD.exists() and not BUILD.is_symlink():
        return 0
    folder = BUILD.resolve()
    if folder == ROOT or ROOT.is_relative_to(folder) or not is_ours(folder):
        raise UsageError(f"{BUILD} is not a build folder of this course: nothing was removed")
    with alone(folder):  # not under another that builds there
        shutil.rmtree(folder)
    if BUILD.is_symlink():
        BUILD.unlink()
    return 0


def is_ours(folder) -> bool:
    """True for folders made by the course or cmake; others that LIGHTWALK_BUILD may name stay."""
    if folder == (ROOT / "build").resolve() or (folder.is_relative_to(ROOT / "build")):
        return True
    cache = folder / "CMakeCache.txt"
    return cache.is_file() and f"CMAKE_HOME_DIRECTORY:INTERNAL={ROOT}\n" in cache.read_text(errors="replace", encoding="utf-8")
