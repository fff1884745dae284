"""The commands of ./course and the module of each; of a command with an option behind it, the module that the option selects."""

import argparse

from tree import UsageError

# The help of all of them is in the shell script, which must print it without Python.
COMMANDS = {
    "run": "run",
    "run --models": "models",
    "run --film": "film",
    "run --table": "film",
    "run --page": "film",
    "test": "test.run_tests",
    "test --device": "test.device",
    "release": "test.release",
    "accept": "shots.accept",
    "check": "check.check",
    "reset": "check.reset",
    "study": "charts.study",
    "study --stretch": "check.stretch",
    "shader": "pages.shader",
    "new": "new",
    "format": "build.format_tree",
    "fuzz": "build.fuzz",
    "handout": "grading.handout",
    "handout --autograder": "grading.autograder",
    "grade": "grading.grade",
    "docs": "pages.docs",
    "docs --check": "test.figures",
    "docs --quote": "pages.quotes",
    "docs --slides": "pages.slides",
    "docs --book": "pages.book",
    "serve": "live.serve",
    "doctor": "build.doctor",
    "clean": "build.clean",
}
# Names of earlier versions.
MOVED = {
    "progress": "check --progress",
    "next": "check --next",
    "figures": "docs --check",
    "quote": "docs --quote",
    "slides": "docs --slides",
    "book": "docs --book",
    "stretch": "study 02 --stretch",
    "models": "run --models",
    "film": "run 19 --film OUT.mp4",
    "autograder": "handout FOLDER --autograder",
}


def names() -> list[str]:
    return [name for name in COMMANDS if " " not in name]


def selected(command: str, words: list[str]) -> str:
    """The key of COMMANDS that the words behind a command select."""
    keys = (f"{command} {word.partition('=')[0]}" for word in words)
    return next((key for key in keys if key in COMMANDS), command)


class Parser(argparse.ArgumentParser):
    see = ""  # behind each message: where help is

    def error(self, message):
        raise UsageError(message + self.see)
