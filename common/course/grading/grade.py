"""Checks submissions and writes the grades: a table, CSV and JSON.

Only the exercise files of a submission are read (chapters/NN_name/exercise/*, shaders/NN_name/exercise/*), so that a
student's checks and framework have no effect. Each exercise is judged by itself (judge.py), in a sandbox (sandbox.py);
an identical answer is judged once.
"""

import argparse
import contextlib
import hashlib
import json
import math
import os
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from grading import marks
from grading.alike import alike
from grading.feedback import write_pages
from grading.gradebook import FORMATS, Book, as_csv, write_books
from grading.judge import BUDGET_S, MOST_AT_ONCE, Judge, picture_path, starters_of
from grading.roster import Roster, known_as
from grading.rules import Rules
from grading.submission import cell, find, printable, read, time_of
from many import shards, slurm
from progress import Progress
from tree import (BUILD, Failure, Unjudged, UsageError, chapters, cores, exercises, find_chapter, has_solutions, nearest, say,
                  unwritable, warn, write_atomically)

HELP = """Grades the exercises that students handed in, by the checks of this tree.

  ./course grade FOLDER             a class: a folder of folders, .zip and .tar.* files, one for each student
  ./course grade ann.zip ben        some students
  ./course grade FOLDER --chapter 02
  ./course grade FOLDER --format moodle --roster class.csv --rules rules.json
  ./course grade FOLDER --shard 3/16 --out F    part 3 of 16, into the folder F; the others may run elsewhere
  ./course grade --merge F                      the table of all parts, byte for byte that of one run
  ./course grade FOLDER --slurm                 Slurm grades the parts; --slurm='--partition=short' for sbatch's options

Prints a table, and writes grades.csv and grades.json (the failures of each exercise) to build/grades or to --out. An answer
that was judged before is not judged again: an interrupted run continues where it stopped. marks.json keeps each mark: the same
answer has the same mark whenever it is graded again, until --regrade names its exercise.

A ? in grades.csv and "look at" in the table mark an exercise without a mark until you have looked at it: its numbers are right,
but its picture crashed the driver, or operations that GLSL leaves undefined were not looked for; or its process was killed twice.

A folder's time is that of its newest file, which a student can set: --rules states others ("handed_in"), and a Moodle worksheet
as --roster has the platform's own.

Students' code is compiled and run in a sandbox (bubblewrap): it has no access to the network, other
students, references or checks, and limits on time, memory and output. Without bubblewrap nothing runs. Before the first verdict on
an exercise its reference passes and its starter fails by the same path; where they do not, "this machine cannot judge" it: it is
"not judged" in all tables, nothing of it is kept, and the exit code is 3. The exit code is 0 for any grades."""

MOST_NAMES = 12  # on one line
UNTOUCHED = ("missing", "unchanged")  # states of exercises not begun


def add_arguments(parser):
    parser.add_argument("paths", nargs="*", type=Path, metavar="PATH")
    parser.add_argument("--chapter", metavar="NN", help="grade only the exercises of this chapter")
    parser.add_argument("--json", action="store_true", help="print one JSON object per student instead of the table")
    parser.add_argument("--out", type=Path, default=None, metavar="FOLDER", help="folder for the files (build/grades)")
    parser.add_argument("--format", action="append", default=[], choices=FORMATS, metavar="FORMAT",
                        help=f"also write gradebook.FORMAT and a page for each student: {', '.join(FORMATS)}; repeatable")
    parser.add_argument("--rules", type=Path, metavar="FILE", help="weights, deadlines and points, as JSON (docs/teaching.md)")
    parser.add_argument("--roster", type=Path, metavar="FILE", help="the class as Moodle or Canvas exports it, as CSV")
    parser.add_argument("--budget", type=minutes, default=BUDGET_S / 60, metavar="MINUTES",
                        help="processor time, or a quarter of the clock's where that is more, that one student's answers may take in all, beyond "
                             "15 s for each (default: 10)")
    parser.add_argument("--regrade", action="append", default=[], metavar="NN.NAME",
                        help="judge this exercise again for everybody, and replace the marks that were given; repeatable")
    shards.add_arguments(parser)
    slurm.add_arguments(parser)


def minutes(word: str) -> float:
    """Raises ArgumentTypeError."""
    with contextlib.suppress(ValueError):
        if 0 <= (found := float(word)) < math.inf:
            return found
    raise argparse.ArgumentTypeError(f"'{word}' is no number of minutes; expected 0 or more")


def run(arguments, _rest) -> int:
    slurm.check_arguments(arguments)
    if bool(arguments.merge) == bool(arguments.paths):
        raise UsageError("--merge takes shards, which know the class: leave out its folder" if arguments.merge else
                         "name a class, a folder of submissions, or --merge and its shards")
    named = [find_chapter(arguments.chapter)] if arguments.chapter else chapters()
    wanted = {exercise: chapter for chapter in named for exercise in exercises(chapter)}
    if (arguments.rules or arguments.roster) and not arguments.format and not arguments.shard:
        raise UsageError(f"{'--rules' if arguments.rules else '--roster'} says what a gradebook holds: add --format, such as --format csv")
    if strange := [name for name in arguments.regrade if name not in wanted]:
        raise UsageError(f"there is no exercise '{strange[0]}' to regrade; {nearest(strange[0], wanted)}")
    Rules(arguments.rules, wanted)  # said before hours of grading, not behind them
    Roster(arguments.roster, [])
    if arguments.merge:
        return finish(arguments, *merged(shards.merge(arguments.merge, "grade"), wanted, not arguments.chapter))
    submissions = find(arguments.paths)
    place = Path(os.path.realpath(arguments.out or BUILD / "grades"))
    classes = set(arguments.paths) - {one.path for one in submissions}
    if inside := [path for path in classes if place.is_relative_to(os.path.realpath(path))]:
        raise UsageError(f"--out {printable(str(place))} lies in {printable(str(inside[0]))}, and would be a submission the next time; name another folder")
    if not has_solutions():
        raise UsageError("this copy of the course has no solutions to grade with")
    if arguments.shard:
        return grade_shard(arguments, submissions, wanted)
    out_folder(arguments)
    if arguments.slurm is not None:
        made = shards.merge([slurm.run("grade", arguments, sys.argv[1:], lambda: Judge(wanted))], "grade")
        slurm.finished("grade")
        return finish(arguments, *merged(made, wanted, False))
    with Judge(wanted) as judge:
        judge.fresh, judge.budget_s = set(arguments.regrade), 60 * arguments.budget
        return finish(arguments, *judged(submissions, judge), wanted)


def out_folder(arguments) -> Path:
    """Where the files go; those of a run before stay until there are new ones. Raises UsageError where none can be written."""
    out = (arguments.out or BUILD / "grades").absolute()
    try:
        out.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=out) as file:
            file.write(b"[]\n")
    except OSError as error:
        raise unwritable(out, error) from None
    return out


def finish(arguments, grades: dict[str, dict], submitted: dict[str, dict[str, bytes]], wanted: dict[str, str]) -> int:
    """Processes the grades of a whole class, from any source. Returns the exit code."""
    out, named = out_folder(arguments), list(dict.fromkeys(wanted.values()))
    changed = marks.keep(out / "marks.json", list(grades.values()), submitted, set(arguments.regrade))
    grades = complete(grades, submitted, wanted)
    write_files(out, grades, wanted)
    if arguments.format:
        write_gradebooks(arguments, out, grades, submitted, wanted)
    if arguments.json:
        for one in grades:
            say(json.dumps(one, ensure_ascii=True))
    else:
        for line in table(grades, named):
            say(line)
        warn(f"{printable(str(out / 'grades.csv'))} and grades.json have the details")
    for line in changed:
        warn(line)
    if arguments.regrade:
        warn(f"{len(changed)} marks of {', '.join(arguments.regrade)} changed")
    refuse_failed(grades)
    return 0


def write_gradebooks(arguments, out: Path, grades: list[dict], submitted: dict, wanted: dict[str, str]):
    roster = Roster(arguments.roster, [one["student"] for one in grades])
    for one in grades:
        one["handed_in_s"] = roster.handed_in_s(one["student"]) or one.get("handed_in_s")
    book = Book(grades, Rules(arguments.rules, wanted), roster)
    names = write_books(out, book, arguments.format)
    count = write_pages(out / "feedback", book, grades, submitted)
    if roster.strangers:
        warn(f"not in {arguments.roster}: {first_of(roster.strangers)}")
    known = {one["student"] for one in grades}
    if lost := [student for student in book.rules.students if student not in known]:
        warn(f"{arguments.rules}: students: nobody handed in as {first_of(lost)}")
    warn(f"{printable(str(out))}: {', '.join(names)}, and {count} pages in feedback")


def first_of(students: list[str]) -> str:
    more = f" and {len(students) - MOST_NAMES} more" if len(students) > MOST_NAMES else ""
    return ", ".join(printable(name, 60) for name in students[:MOST_NAMES]) + more


def refuse_failed(grades: list[dict]):
    failed = [(one["student"], result) for one in grades for result in one["results"] if result["state"] == "failed"]
    for student, result in failed[:5]:
        warn(f"{printable(student)}, {result['exercise']}: {result['first_failure']}")
    if failed:
        machine = any(result["first_failure"].startswith("this machine cannot judge") for _, result in failed)
        raise (Unjudged if machine else Failure)(f"{len(failed)} exercises could not be judged; the same command tries them again")


def grade_shard(arguments, submissions, wanted: dict[str, str]) -> int:
    """Grades the submissions that belong to a shard, by their own names, and writes it. The exit code."""
    shard = arguments.shard
    file = shards.file_of(arguments.out, "grade", shard)
    mine = {one.student: i for i, one in enumerate(submissions) if shard.takes(one.path.name)}
    with Judge(wanted) as judge:
        judge.fresh, judge.budget_s = set(arguments.regrade), 60 * arguments.budget
        grades, submitted = judged([one for one in submissions if one.student in mine], judge)
        head = {"exercises": list(wanted.items()), "submissions": len(submissions), "inputs": shards.digest([str(judge.seed)]),
                "class": shards.digest(sorted(f"{one.student} {stamp(one.path)}" for one in submissions)), "course": shards.course_version()}
    entries, answers = {}, {}
    for student, one in grades.items():
        names = {exercise: hashlib.sha256(data).hexdigest() for exercise, data in submitted.get(student, {}).items()}
        answers |= {name: submitted[student][exercise] for exercise, name in names.items()}
        answers |= {f"{result[key]}.png": picture_path(result[key]) for result in one["results"]
                    for key in ("picture", "picture_expected") if key in result}
        entries[student] = {"at": mine[student], "grade": one, "answers": names, "read": student in submitted}
    shards.write(file, "grade", shard, head, entries, answers)
    say(f"{printable(str(file))}: {len(mine)} of {len(submissions)} submissions")
    refuse_failed(list(grades.values()))
    return 0


def stamp(path: Path) -> str:
    """Changes where a submission is replaced by another of its name."""
    try:
        at = path.lstat()
    except OSError:
        return ""
    return f"{int(at.st_mtime)} {at.st_size if path.is_file() else ''}"


def merged(made: shards.Merged, wanted: dict[str, str], all_of_them: bool) -> tuple[dict, dict, dict]:
    """The grades of all shards as judged() has them, and the exercises, all of the shards' or those that are wanted. Raises UsageError
    where a submission is in none, and for what no shard of grades holds."""
    try:
        theirs = dict(made.head["exercises"])
        if len(made.entries) != made.head["submissions"]:
            raise UsageError(f"the shards hold {len(made.entries)} of {made.head['submissions']} submissions: make them again")
        if not all_of_them and (strange := sorted(set(wanted) - set(theirs))):
            raise UsageError(f"the shards were made without {strange[0]}")
        wanted, grades, submitted = theirs if all_of_them else wanted, {}, {}
        for student, entry in sorted(made.entries.items(), key=lambda item: item[1]["at"]):
            grades[student] = one = entry["grade"]
            one["results"] = [marks.checked(result, result["exercise"]) for result in one["results"] if result["exercise"] in wanted]
            for name in [result[key] for result in one["results"] for key in ("picture", "picture_expected") if key in result]:
                if not picture_path(shards.safe(name)).exists():
                    write_atomically(picture_path(name), made.file(student, f"{name}.png"))
            if entry["read"]:
                submitted[student] = {exercise: made.file(student, shards.safe(name)) for exercise, name in entry["answers"].items()
                                      if exercise in wanted}
        return grades, submitted, wanted
    except (ValueError, TypeError, KeyError, AttributeError) as error:
        raise UsageError(f"the shards hold what is no grade: {printable(repr(error))}; make them again") from None


def grade(submissions, judge: Judge) -> list[dict]:
    return complete(*judged(submissions, judge), judge.wanted)


def judged(submissions, judge: Judge) -> tuple[dict[str, dict], dict[str, dict[str, bytes]]]:
    submitted, grades, waiting = {}, {}, {}
    with Progress("grading") as progress, ThreadPoolExecutor(min(cores(), MOST_AT_ONCE)) as pool:
        try:
            for one in submissions:
                grades[one.student] = {"student": one.student, "path": printable(str(one.path)), "error": None,
                                       "handed_in_s": time_of(one.path, judge.names), "results": [], "alike": []}
                try:
                    notes = []
                    found = read(one, set(judge.names), {place: judge.starters[name] for place, name in judge.names.items()}, notes)
                    if notes:
                        grades[one.student]["note"] = "; ".join(notes[:MOST_NAMES])
                except Failure as failure:
                    grades[one.student]["error"] = str(failure)
                    continue
                submitted[one.student] = {judge.names[name]: data for name, data in found.items()}
                # Equal files are judged once; who else has it does not matter.
                for exercise in judge.wanted:
                    work = (exercise, submitted[one.student].get(exercise))
                    if work not in waiting:
                        waiting[work] = pool.submit(judge.verdict, *work, one.student)
            for done, one in enumerate(submissions):
                progress.show(done, len(submissions), one.student)
                if one.student in submitted:
                    grades[one.student]["results"] = [
                        waiting[exercise, submitted[one.student].get(exercise)].result() for exercise in judge.wanted]
            progress.show(len(submissions), len(submissions))
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            judge.stop()
            raise
    return grades, submitted


def complete(grades: dict[str, dict], submitted: dict[str, dict[str, bytes]], wanted: dict[str, str]) -> list[dict]:
    """Adds class-wide results: similar submissions, and the number of right answers."""
    for a, b, what in alike(submitted, starters_of(wanted)):
        if known_as(a)[1] and known_as(a)[1] == known_as(b)[1]:
            continue  # two entries of one student
        grades[a]["alike"].append({"student": b, "what": what})
        grades[b]["alike"].append({"student": a, "what": what})
    for one in grades.values():
        one["right"] = sum(result["ok"] for result in one["results"])
        one["of"] = len(wanted)
    return list(grades.values())


def write_files(out: Path, grades: list[dict], wanted: dict[str, str]):
    write_atomically(out / "grades.json", json.dumps(grades, indent=1, ensure_ascii=True) + "\n", 0o600)
    rows = [["student", "right", "of", *wanted, "error", "alike", "note"]]
    for one in grades:
        given = {result["exercise"]: "?" if result["state"] == "undecided" else "not judged" if result["state"] == "failed" else "missing" if result["state"] in UNTOUCHED else
                 int(result["ok"]) for result in one["results"]}
        same = "; ".join(f"{other['student']}: {other['what']}" for other in one["alike"][:MOST_NAMES])
        rows.append([cell(one["student"]), one["right"], one["of"], *[given.get(name, "missing") for name in wanted],
                     cell(one["error"] or ""), cell(same), cell(one.get("note", ""))])
    write_atomically(out / "grades.csv", as_csv(rows), 0o600)


def table(grades: list[dict], named: list[str]) -> list[str]:
    width = min(max([7, *[len(one["student"]) for one in grades]]), 40)
    lines = [f"{'student':{width}}  right  " + " ".join(f"{chapter[:2]:>5}" for chapter in named)]
    for one in grades:
        counts = []
        for chapter in named:
            results = [result for result in one["results"] if result["chapter"] == chapter]
            counts.append(f"{sum(result['ok'] for result in results)}/{len(results)}" if results else "-")
        said = one["error"] or one.get("note") or ("" if any(result["state"] in ("judged", "undecided") for result in one["results"]) else
                                "nothing was changed")
        lines.append(f"{printable(one['student'], width):{width}}  {one['right']:3}/{one['of']:<2} " +
                     " ".join(f"{count:>5}" for count in counts) + (f"  {said}" if said else ""))
    undrawn = [f"look at: {printable(one['student'])}, {result['exercise']}, which has no mark yet: {result['first_failure']}"
               for one in grades for result in one["results"] if result["state"] == "undecided"]
    return lines + undrawn + [f"alike: {line}" for line in groups(grades)]


def groups(grades: list[dict]) -> list[str]:
    lines, seen = [], set()
    pairs = {one["student"]: {other["student"]: other["what"] for other in one["alike"]} for one in grades}
    for first in pairs:
        group, waiting = [], [first] if pairs[first] and first not in seen else []
        while waiting:
            student = waiting.pop()
            if student not in seen:
                seen.add(student)
                group.append(student)
                waiting += pairs[student]
        if group:
            group.sort()
            more = f" and {len(group) - MOST_NAMES} more" if len(group) > MOST_NAMES else ""
            what = pairs[group[0]].get(group[1]) if len(group) == 2 else "grades.json says what"
            lines.append(f"{', '.join(group[:MOST_NAMES])}{more}: {what}")
    return lines
