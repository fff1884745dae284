"""Removes what was built."""

import shutil

from tree import BUILD

HELP = "Removes the build folder: programs, pictures, reports."


def add_arguments(parser):
    pass


def run(_arguments, _rest) -> int:
    if BUILD.exists():
        shutil.rmtree(BUILD)
    return 0
