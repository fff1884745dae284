"""Runs the commands that lessons name, and compares their output with the lessons.

Three kinds of figures: tables and numbers whose source is a file (pages/tables.py); tests that a lesson names
(check/lesson_tests.py), whose output is printed beside the lesson's line; and numbers whose source is such a command,

    0.0004<!-- figure: build/tests/test_08_bloom "[08.flicker]"#sigma 8 pingpong flicker: brightness {} -->

where {} stands for the number in a line of the output, and blanks for any blanks. `; tolerance=5%` behind it allows more
than the digits printed, and `scale=100` makes a share a percentage.
"""

import re
import shlex
import subprocess
from pathlib import Path

from build.build import build
from charts.measured import earlier
from check import lesson_tests
from pages import tables
from pages.quotes import lessons
from test import lesson_commands
from tree import BUILD, ROOT, UsageError, chapters, find_chapter, run_on_chapter, say

HELP = """Runs the tests that lessons name, and prints their output beside the lesson's lines: every figure can be measured again.

  ./course docs --check          all lessons
  ./course docs --check 08           one lesson
  ./course docs --check 08 --list    what would be run; builds and runs nothing

It builds what is needed. Tables of studies and numbers with a source are compared with it, and a chapter's program reads the
commands that any page prints for it, and draws those that set something. A line that begins with WRONG says where a figure is
not what was found, or a command is refused, and the exit code is then 1. Studies that measured an earlier version of the
chapter's code are listed at the end."""

INTERESTING = re.compile(r"^(Filters:|=+$|All tests passed|\s*$)")


def add_arguments(parser):
    parser.add_argument("--check", action="store_true", help="check what lessons say")
    parser.add_argument("chapter", nargs="?", metavar="NN", help="number or name of the chapter")
    parser.add_argument("--list", action="store_true", help="list what would be run")


def run(arguments, _rest) -> int:
    chapter = find_chapter(arguments.chapter) if arguments.chapter else ""
    chosen = [name for name in lesson_tests.of_chapters(lessons()) if name.stem.startswith(chapter[:2])]
    if not chosen:
        raise UsageError(f"chapter {chapter} has no lesson")
    if not arguments.list:
        programs = sorted({one.program for lesson in chosen for one in lesson_tests.named_in(lesson)} |
                          {Path(source.split()[0]).name for lesson in chosen for *_, source in commands(lesson)})
        build([*programs, *(one for one in chapters() if one.startswith(chapter[:2]))])
    wrong = sum(check(lesson, arguments.list) for lesson in chosen)
    wrong += sum(check_commands(one, arguments.list) for one in chapters() if one.startswith(chapter[:2]))
    old = [study for study in earlier() if study.name.startswith(chapter[:2])]
    if old:
        say("measured with an earlier version of the chapter's code: " + ", ".join(str(study.relative_to(ROOT / "docs/studies").with_suffix("")) for study in old))
    say(f"{wrong} wrong" if wrong else "no figure is wrong")
    return 1 if wrong else 0


def commands(lesson: Path) -> list[tuple[int, str, str, str]]:
    return [figure for figure in tables.figures((ROOT / lesson).read_text(encoding="utf-8")) if figure[3].startswith("build/")]


def check(lesson: Path, only_list: bool) -> int:
    lines = (ROOT / lesson).read_text(encoding="utf-8").splitlines()
    problems = tables.check_tables(lesson, lines)[0] + tables.check_figures(lesson) + lesson_tests.check_named(lesson)
    for problem in problems:
        say(f"WRONG {problem}")
    wrong, outputs = len(problems), {}
    for one in lesson_tests.named_in(lesson):
        again = f'build/tests/{one.program} "{one.spec}"'
        say(f"{lesson}:{one.line}: {lines[one.line - 1].strip()}")
        if only_list:
            say(f"    {again}")
        elif again not in outputs:
            outputs[again] = output, code = ran(again)
            for line in output.splitlines():
                if not INTERESTING.match(line):
                    say(f"    | {line}")
            if code:
                wrong += 1
                say(f"WRONG {lesson}:{one.line}: {again} ended with {code}")
    for line, number, unit, source in [] if only_list else commands(lesson):
        command, _, pattern = source.rpartition("#")
        pattern, _, options = pattern.partition(";")
        if command not in outputs:
            outputs[command] = ran(command)
        output = outputs[command][0]
        found, wanted = tables.printed(output, pattern.strip()), tables.selection(options)
        found = None if found is None else float(wanted.get("scale", 1)) * found
        right = found is not None and tables.agrees(number, found, wanted.get("tolerance", ""))
        say(f"{'' if right else 'WRONG '}{lesson}:{line}: the text says {number}{unit}, "
            f"{'nothing printed' if found is None else f'found {found:g}'}: {command}")
        wrong += not right
    return wrong


def check_commands(chapter: str, only_list: bool) -> int:
    """Prints the commands for a chapter's program that are wrong, or lists all of them. How many are wrong."""
    if only_list:
        for one in lesson_commands.printed():
            if one.chapter == chapter:
                say(str(one))
        return 0
    wrong = lesson_commands.wrong_of(chapter)
    for problem in wrong:
        say(f"WRONG {problem}")
    return len(wrong)


def ran(command: str) -> tuple[str, int]:
    words = shlex.split(command)
    words[0] = str(BUILD / Path(words[0]).relative_to("build"))
    done = subprocess.run(words, cwd=ROOT, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, errors="replace")
    none = "No test" in done.stdout and "No tests ran" in done.stdout
    return done.stdout, done.returncode or (4 if none else 0)


def test_of(chapter: str) -> list[str]:
    """As a test, of a chapter with built programs: a line for each wrong figure."""
    wrong = sum(check(lesson, False) for lesson in lesson_tests.of_chapters(lessons()) if lesson.stem.startswith(chapter[:2]))
    wrong += check_commands(chapter, False)
    return [f"{wrong} figures or commands of chapter {chapter} are wrong; ./course docs --check {chapter[:2]} shows them"] if wrong else []


if __name__ == "__main__":
    run_on_chapter(test_of)
