"""Reports right exercises, the faults of the others, and a student's progress.

A chapter's checks are a program, build/tests/check_NN_name, which tests/NN_name is to give:

    check_NN_name [--exercise NN.name] [--use exercise|solution]

It checks one exercise or all of the chapter, the student's version unless told otherwise, and prints one JSON object
per exercise on a line of its own:

    {"exercise": "02.phong", "ok": false, "passed": 11, "failed": 3,
     "first_failure": "phong(n·h = 0, shininess = 0) gave NaN, expected 0", "hint": "a sentence"}

first_failure and hint are null or missing if there is none; "note" lists skipped parts. A file
that does not compile is a failure like any other; first_failure then holds the compiler's line. Exit code 0 if all are
right, 1 if not, 2 if there is no such exercise. A program that prints nothing, or dies, or runs for more than half a minute per exercise, counts as open.

No verdict without a control: where an exercise that was worked on is open, its reference passes and its starter fails by the
same program, on the same driver, or this machine cannot judge it: exit code 3, and nothing is kept. "lost" marks a verdict
that rests on a process that ended or was late; it is tried once more.

The numbers come first. If they are right the exercise's pictures are drawn too (shots that name it in
"exercises", shots.py), twice: with the student's version of this one exercise, and with the references alone. Both are
drawn here and now, so that no processor and no driver makes a difference. The limits are wide: a right answer's
choices, such as the rounding of a doubtful case, show in a picture too.

GLSL cannot crash a driver without a fault of the driver's own: after a crash the numbers decide, and the note says so.

In a handout there is no reference to draw with. There a picture shows the student's version of every exercise of the
chapter and the earlier ones. It is compared with the golden, within the same limits, once the numbers of all of those
are right; until then the numbers decide, and the open exercises are named.
"""

import functools
import json
import os
import re
import subprocess
import tempfile
from pathlib import Path

from build.build import build
from check.glsl_answer import Refused, plain
from check.starters import digest, untouched
from check.verdicts import Verdicts
from progress import Progress
from shots.golden import compare, exceeded, golden_path, unfit
from shots.rendering import Crashed, render_shot
from tree import (BUILD, FULL, ROOT, Failure, Unjudged, UsageError, chapters, exercises, find_chapter, has_solutions, lessons, nearest,
                  relative, say, shots, unjudged)

ALONE = True
HELP = """Checks your exercises: lists the solved ones, and the first error of each of the others.

  ./course check               all chapters
  ./course check 02            one chapter
  ./course check 02.phong      one exercise
  ./course check 02 --hint     with a hint for each unsolved exercise
  ./course check --progress    one line per chapter: how many exercises are solved
  ./course check --next        one next step: the first unsolved exercise

Exit code 1 while an exercise is unsolved, 3 where this machine cannot judge: where the reference does not pass here."""
TIMEOUT_S = 30  # of a whole check; a call that does not return is found after 5 s
# For a picture with correct numbers. A light more or less per object, which 03.light_reaches_box leaves open, is
# 0.0018 and 0.055; of the starters' pictures the nearest to the reference is 0.013.
PICTURE_LIMITS = {"flip_mean": 0.01, "flip_p99": 0.25}


def add_arguments(parser):
    parser.add_argument("what", nargs="?", default="all", metavar="NN | NN.name | all")
    parser.add_argument("--hint", action="store_true", help="print a hint for each unsolved exercise")
    parser.add_argument("--progress", action="store_true", help="print one line per chapter")
    parser.add_argument("--next", action="store_true", help="name one next step")
    parser.add_argument("--json", action="store_true", help="print one JSON object per exercise")


def run(arguments, _rest) -> int:
    if arguments.next:
        if arguments.what != "all" or arguments.progress or arguments.hint or arguments.json:
            raise UsageError("--next names one step of the whole course: leave out what else was given")
        return next_step()
    if arguments.progress and arguments.hint:
        raise UsageError("--progress counts, and prints no hints: one of --progress and --hint")
    selected = select(arguments.what)
    named = sorted({chapter for chapter, _ in selected})
    forget_ended_compilers(named)
    build([f"check_{chapter}" for chapter in named])
    results, verdicts = [], Verdicts()
    with Progress("checking") as progress:
        for number, (chapter, exercise) in enumerate(selected):
            if progress.terminal or arguments.progress:  # elsewhere each result is a line
                progress.show(number, len(selected), exercise)
            results.append(judged(chapter, exercise, verdicts))
            if not arguments.progress:
                progress.clear()
                show(results[-1], arguments)
    if arguments.progress:
        show_progress(named, results, arguments.json)
    elif not arguments.json:
        say(summary(results))
    return 0 if all(result["ok"] for result in results) else 1


def select(what: str) -> list[tuple[str, str]]:
    """(chapter, exercise id) for all, 02 or 02.phong. Raises UsageError."""
    known = {chapter: in_order(chapter) for chapter in chapters()}
    if what == "all":
        selected = [(chapter, exercise) for chapter in known for exercise in known[chapter]]
    else:
        word, dot, name = what.partition(".")
        chapter = find_chapter(word)
        if dot and not name:
            raise UsageError(f"'{what}' names no exercise; {word} means all of a chapter")
        selected = [(chapter, exercise) for exercise in known[chapter]
                    if not name or exercise == f"{chapter[:2]}.{name}"]
        if name and not selected:
            raise UsageError(f"there is no exercise '{what}'; {nearest(what, known[chapter])}; "
                             f"./course run {chapter[:2]} --list exercises lists all")
    if not selected:
        raise UsageError(f"there is no exercise in {what}")
    return selected


@functools.cache
def grades(chapter: str) -> dict[str, str]:
    """The exercises in the lessons' order, and how hard they call each: "### 02.phong (medium)". One that uses what a later
    chapter teaches stands on its page."""
    text = "\n".join((ROOT / page).read_text(encoding="utf-8") for page in lessons())
    return dict(re.findall(rf"^### ({chapter[:2]}\.\w+) \((easy|medium|hard)\)$", text, re.M))


def in_order(chapter: str) -> list[str]:
    order = list(grades(chapter))
    return sorted(exercises(chapter), key=lambda name: order.index(name) if name in order else len(order))


def judged(chapter: str, exercise: str, verdicts: Verdicts) -> dict:
    """The verdict, which is kept, after a control. Raises Unjudged."""
    try:
        return judge_one(chapter, exercise, verdicts)
    except OSError as error:
        if error.errno not in FULL:
            raise
        raise unjudged(exercise, f"{error.filename or tempfile.gettempdir()}: {error.strerror}") from None


def judge_one(chapter: str, exercise: str, verdicts: Verdicts) -> dict:
    of = digest(exercises(chapter)[exercise].read_bytes())
    if said := ended_compiler(chapter, exercise):
        raise unjudged(exercise, f"its compiler was ended: {said}; ./course check {exercise} compiles it again")
    result = check(chapter, exercise)
    if result.pop("lost", False):
        control(chapter, exercise)
        result = check(chapter, exercise)
        result.pop("lost", None)
        control(chapter, exercise)
    elif not result["ok"] and exercise not in untouched():
        control(chapter, exercise)
    elif result["ok"] and chapter not in controlled:
        control(chapter, exercise)
    verdicts.keep(exercise, of, result)
    return result


controlled = set()  # chapters of which a control passed in this run


def control(chapter: str, exercise: str):
    """Raises Unjudged unless the reference passes and the starter fails, as far as this tree has them."""
    path = exercises(chapter)[exercise]
    if (path.parent.parent / "solution" / path.name).exists() and not (found := check_numbers(chapter, exercise, "solution")).get("ok"):
        raise unjudged(exercise, f"its reference does not pass: {found['first_failure']}")
    if path.suffix == ".glsl":
        from check.reset import starter_of
        try:
            starter = starter_of(path)
        except Failure:  # neither a handout nor a history
            starter = None
        if starter is not None:
            with tempfile.TemporaryDirectory(prefix="lightwalk.") as made:
                place = Path(made) / path.relative_to(ROOT)
                place.parent.mkdir(parents=True)
                place.write_bytes(starter)
                found = check_numbers(chapter, exercise, LIGHTWALK_OVERLAY=made)
            if found.get("ok") or found.get("lost"):
                raise unjudged(exercise, f"its starter {'passes' if found.get('ok') else 'reaches no verdict'}: {found['first_failure']}")
    controlled.add(chapter)


# What compile_exercise.sh leaves beside the object: where the machine ended the compiler, and where the exercise does not compile.
ENDED, ERROR = ".ended", ".error"


def objects_of(chapter: str) -> Path:
    return BUILD / "CMakeFiles" / f"exercises_{chapter}.dir"


def compiler_left(chapter: str, exercise: str, ending: str) -> list[str] | None:
    """The lines of ENDED or ERROR; None where the compiler left no such file."""
    path = objects_of(chapter) / f"{relative(exercises(chapter)[exercise])}.o{ending}"
    return path.read_text(encoding="utf-8", errors="replace").strip().splitlines() if path.is_file() else None


def forget_ended_compilers(named: list[str]):
    """Their objects are made again."""
    for chapter in named:
        for path in objects_of(chapter).rglob(f"*{ENDED}"):
            path.with_suffix("").unlink(missing_ok=True)
            path.unlink(missing_ok=True)


def ended_compiler(chapter: str, exercise: str) -> str:
    lines = compiler_left(chapter, exercise, ENDED)
    return "" if lines is None else (lines or ["without a word"])[-1]


def check(chapter: str, exercise: str) -> dict:
    """The verdict on one exercise: the protocol's object, with "file" and "chapter"."""
    result = {"exercise": exercise, "ok": False, "passed": 0, "failed": 0, "first_failure": None, "hint": None}
    result |= check_numbers(chapter, exercise)
    if said := compiler_said(chapter, exercise):
        result["first_failure"] = f"it does not compile: {said}"
    if result["ok"]:
        note_what_grading_refuses(exercises(chapter)[exercise], result)
        check_pictures(chapter, exercise, result)
    if exercise in untouched():  # results of the starter are nobody's work
        result |= {"passed": 0, "failed": result["failed"] + result["passed"]}
    return result | {"chapter": chapter, "file": relative(exercises(chapter)[exercise])}


def add_note(result: dict, words: str):
    result["note"] = "; ".join(filter(None, (result.get("note"), words)))


def note_what_grading_refuses(path: Path, result: dict):
    try:
        if path.suffix == ".glsl":
            plain(path.read_bytes(), path)
    except Refused as why:
        add_note(result, f"handed in like this it would be refused: {why}")


def compiler_said(chapter: str, exercise: str) -> str:
    """The first error in a C++ exercise that does not compile, else nothing."""
    lines, file = compiler_left(chapter, exercise, ERROR), relative(exercises(chapter)[exercise])
    if lines is None:
        return ""
    wrong = next((line for line in lines if "error" in line), lines[0] if lines else "no word why")
    return file + wrong.partition(file)[2] if file in wrong else wrong


def check_numbers(chapter: str, exercise: str, use: str = "exercise", **environment) -> dict:
    """The protocol's object, or a substitute if the program gave none."""
    program = BUILD / "tests" / f"check_{chapter}"
    try:
        done = subprocess.run([program, "--exercise", exercise, "--use", use], cwd=ROOT, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, errors="replace",
                              env=os.environ | environment, timeout=TIMEOUT_S)
    except OSError as error:
        raise Unjudged(f"this machine cannot judge: {relative(program)}: {error.strerror}") from None
    except subprocess.TimeoutExpired:
        return {"first_failure": f"it did not end within {TIMEOUT_S} s", "lost": True}
    for line in done.stdout.splitlines():
        try:
            found = json.loads(line)
        except ValueError:
            continue
        if isinstance(found, dict) and found.get("exercise") == exercise:
            return found | {"ok": found.get("ok") is True and done.returncode == 0}
    words = done.stderr.strip().splitlines()
    why = f"it was ended by signal {-done.returncode}" if done.returncode < 0 else \
        f"its check ended with {done.returncode}"
    return {"first_failure": f"{why}: {words[-1]}" if words else why, "lost": True}


@functools.cache
def numbers_are_right(chapter: str, exercise: str) -> bool:
    return check_numbers(chapter, exercise).get("ok") is True


def still_open(chapter: str, exercise: str) -> list[str]:
    """Other unfinished exercises visible in a picture of this chapter: a handout has no references to replace them. What was
    right when it was last checked is not checked again until its file changes."""
    known = Verdicts()
    others = [(earlier, other) for earlier in chapters() if earlier <= chapter for other, path in exercises(earlier).items()
              if other != exercise and not known.is_solved(other, path)]
    if others:  # without a target all would be built
        build([f"check_{earlier}" for earlier in sorted({earlier for earlier, _ in others})])
    return [other for earlier, other in others if not numbers_are_right(earlier, other)]


@functools.cache
def reference_picture(chapter: str, name: str, size: str = "", **environment) -> Path:
    if not has_solutions():
        return golden_path(chapter, name)
    picture = checked_path(chapter, name, size)
    shot = next(shot for shot in shots(chapter) if shot["name"] == name)
    render_shot(chapter, shot, picture, size=size, **environment)
    return picture


def check_pictures(chapter: str, exercise: str, result: dict):
    """Where the numbers are right the picture must be."""
    wanted = [shot for shot in shots(chapter) if exercise in shot.get("exercises", [])]
    if not wanted:
        return
    if not has_solutions():
        new = untouched()  # untouched exercises are known without a build
        waiting = [other for earlier in chapters() if earlier <= chapter for other in exercises(earlier) if other in new]
        if not waiting:
            waiting = still_open(chapter, exercise)
        if waiting:
            more = f" and of {len(waiting) - 3} more" if len(waiting) > 3 else ""
            add_note(result, f"its picture is compared once the numbers of {', '.join(waiting[:3])}{more} are right")
            return
    build([chapter, "compare"])
    for shot in wanted:
        try:
            why = wrong_picture(chapter, exercise, shot)
        except Crashed as failure:
            if exercises(chapter)[exercise].suffix == ".glsl":  # C++ of a student's crashes by itself
                add_note(result, f"judged by its numbers alone: there is no picture of {shot['name']}, with which the driver crashed")
                continue
            why = str(failure)
        if why:
            result |= {"ok": False, "failed": result["failed"] + 1, "first_failure": why,
                       "hint": "every number that was tried is right, so look for an input that only the picture has: "
                               "the file that ends in .flip.png is bright where the picture is wrong"}
            return
        result["passed"] += 1


def checked_path(chapter: str, name: str, size: str) -> Path:
    return BUILD / "check" / chapter / size / f"{name}.png"


def wrong_picture(chapter: str, exercise: str, shot: dict, overlay: str = "", size: str = "", **environment) -> str:
    """The fault in the exercise's picture; empty if none. `overlay` is the folder of another answer than the student's,
    `size` WxH overrides the shot's own. Raises Crashed, and Unjudged where the reference has no picture here either."""
    picture = checked_path(chapter, f"{shot['name']}.{exercise}", size)
    heatmap = picture.with_suffix(".flip.png")
    use = f"solution,{exercise}=exercise" if has_solutions() else "exercise"
    instead = {"LIGHTWALK_OVERLAY": overlay} if overlay else {}

    def drawn() -> str:
        """Why there is no picture; empty where there is one."""
        try:
            render_shot(chapter, shot, picture, use, size, **environment, **instead)
            return ""
        except Crashed:
            raise
        except Failure as failure:
            return str(failure)

    try:
        if drawn():
            reference_picture.cache_clear()  # a control is drawn now
            reference_picture(chapter, shot["name"], size, **environment)
            if why := drawn():
                return why
        metrics = compare(reference_picture(chapter, shot["name"], size, **environment), picture, heatmap)
    except Crashed:
        raise
    except Failure as failure:
        raise unjudged(exercise, f"there is no picture of {shot['name']} to compare with: {failure}") from None
    return picture_words(shot["name"], metrics, picture, heatmap)


def picture_words(name: str, metrics: dict, picture: Path, heatmap: Path) -> str:
    look = f"look at {relative(picture)} and, for where it differs, {relative(heatmap)}"
    wrong = unfit(metrics)
    if wrong:
        return f"the numbers are right, the picture of {name} is not: {wrong[0]}; {look}"
    if not exceeded(metrics, PICTURE_LIMITS):
        return ""
    most = metrics["max_diff"]
    return (f"the numbers are right, the picture of {name} is not: {most['pixels']} pixels differ from the reference's, "
            f"most the one at ({most['x']}, {most['y']}); {look}")


def show(result: dict, arguments):
    if arguments.json:
        say(json.dumps(result, ensure_ascii=False))
        return
    grade = grades(result["chapter"]).get(result["exercise"])
    counted = f"{result['passed']} of {result['passed'] + result['failed']} checks"
    say(f"{'ok  ' if result['ok'] else 'open'}  {result['exercise']}  {counted}  {result['file']}"
        + (f"  ({grade})" if grade else ""))
    if not result["ok"] and result["first_failure"]:
        say(f"      {result['first_failure']}")
    if result.get("note"):
        say(f"      {result['note']}")
    if not result["ok"] and arguments.hint:
        say(f"      hint: {result['hint'] or 'there is none'}")


def show_progress(named: list[str], results: list[dict], as_json: bool):
    for chapter in named:
        of_chapter = [result for result in results if result["chapter"] == chapter]
        done = sum(result["ok"] for result in of_chapter)
        if as_json:
            say(json.dumps({"chapter": chapter, "done": done, "exercises": len(of_chapter),
                            "open": [result["exercise"] for result in of_chapter if not result["ok"]]}))
        else:
            say(f"{chapter:24} [{'#' * done}{'.' * (len(of_chapter) - done)}] {done} of {len(of_chapter)}")
    if not as_json:
        say(summary(results))


def summary(results: list[dict]) -> str:
    opened = [result["exercise"] for result in results if not result["ok"]]
    return f"{len(results) - len(opened)} of {len(results)} exercises are solved" + \
        (f"; next: {opened[0]}" if opened else "")


def next_step() -> int:
    """Names the first exercise, in the order of the lessons, that is not solved; one that was changed since it was checked last is checked
    now."""
    new, verdicts = untouched(), Verdicts()
    for chapter in chapters():
        for exercise in in_order(chapter):
            found = None
            if exercise not in new:
                solved = verdicts.is_solved(exercise, exercises(chapter)[exercise])
                if solved is None:
                    build([f"check_{chapter}"])
                    found = judged(chapter, exercise, verdicts)
                    solved = found["ok"]
                if solved:
                    continue
            say_step(chapter, exercise, found, exercise in new)
            return 0
    say("every exercise is solved")
    return 0


def say_step(chapter: str, exercise: str, found: dict | None, is_new: bool):
    grade = grades(chapter).get(exercise)
    say(f"next: {exercise}{f' ({grade})' if grade else ''}{'' if is_new else ', which is begun and not right yet'}")
    if found and found["first_failure"]:
        say(f"  {found['first_failure']}")
    say(f"  read   docs/{chapter}.md, \"{exercise}\"")
    say(f"  edit   {relative(exercises(chapter)[exercise])}")
    say(f"  then   ./course check {exercise}{'' if is_new else ' --hint'}")
