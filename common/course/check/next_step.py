"""Names one next step: the first exercise, in the order of the lessons, that is not solved."""

from build.build import build
from check.check import check, grades, in_order
from check.starters import untouched
from check.verdicts import Verdicts, version
from tree import chapters, exercises, relative, say

ALONE = True
HELP = """Names one next step: the first exercise that is not solved, its lesson and its file.

An exercise that you have changed since it was checked last is checked now. Exit code 0."""


def add_arguments(parser):
    parser.add_argument("--next", action="store_true", help="name one next step")


def run(_arguments, _rest) -> int:
    new, verdicts = untouched(), Verdicts()
    for chapter in chapters():
        for exercise in in_order(chapter):
            path = exercises(chapter)[exercise]
            found = None
            if exercise not in new:
                solved = verdicts.is_solved(exercise, path)
                if solved is None:
                    build([f"check_{chapter}"])
                    of = version(path.read_bytes())
                    found = check(chapter, exercise)
                    verdicts.keep(exercise, of, found)
                    solved = found["ok"]
                if solved:
                    continue
            return say_step(chapter, exercise, path, found, exercise in new)
    say("every exercise is solved")
    return 0


def say_step(chapter: str, exercise: str, path, found: dict | None, is_new: bool) -> int:
    grade = grades(chapter).get(exercise)
    say(f"next: {exercise}{f' ({grade})' if grade else ''}{'' if is_new else ', which is begun and not right yet'}")
    if found and found["first_failure"]:
        say(f"  {found['first_failure']}")
    say(f"  read   docs/{chapter}.md, \"{exercise}\"")
    say(f"  edit   {relative(path)}")
    say(f"  then   ./course check {exercise}{'' if is_new else ' --hint'}")
    return 0
