"""Writes integrations for other platforms: an autograder for Gradescope, and a starter repository's workflow for GitHub
Classroom."""

import json
import shutil
from pathlib import Path

from grading.handout import new_folder
from grading.rules import Rules
from tree import ROOT, Failure, UsageError, chapters, exercises, find_chapter, git, say, warn, write_atomically

HELP = """Writes an autograder for platforms that collect answers themselves.

  ./course handout FOLDER --autograder                  FOLDER/gradescope and FOLDER/classroom, each with a README
  ./course handout FOLDER --autograder --chapter 02     of one chapter's exercises

What these run on their machines:

  ./course handout --autograder --prepare               build what grading takes
  ./course handout --autograder --grade SUBMISSION      grade one student's files, and print Gradescope's results.json
  ./course handout --autograder --classroom FILE        from what ./course check --json printed: GitHub Classroom's points;
                                                        --chapter 02 where that was ./course check 02 --json

Gradescope's container must allow namespaces: students' code runs in bubblewrap alone, and where that cannot be there are no
results, which Gradescope reports to you. A classroom's workflow runs in the student's repository, without references: what it
says is as good as ./course check there, and no exam."""

GROUPS = ("base", "build", "check", "grade")
# Of actions/checkout, v5.0.0: a tag can be moved.
CHECKOUT = "actions/checkout@08c6903cd8c0fde910a37f88322edcfb5dd907a8"


def add_arguments(parser):
    parser.add_argument("--autograder", action="store_true", help="write an autograder")
    parser.add_argument("folder", nargs="?", type=Path, metavar="FOLDER")
    parser.add_argument("--chapter", metavar="NN", help="only the exercises of this chapter")
    parser.add_argument("--rules", type=Path, metavar="FILE", help="weights and points, as ./course grade takes them")
    parser.add_argument("--prepare", action="store_true", help="build what grading takes")
    parser.add_argument("--grade", type=Path, metavar="SUBMISSION", help="grade one student's folder or archive")
    parser.add_argument("--classroom", type=Path, metavar="FILE", help="say the points of what ./course check --json printed")


def run(arguments, _rest) -> int:
    if sum(map(bool, (arguments.folder, arguments.prepare, arguments.grade, arguments.classroom))) != 1:
        raise UsageError("one of FOLDER, --prepare, --grade and --classroom; see ./course handout --autograder --help")
    named = [find_chapter(arguments.chapter)] if arguments.chapter else chapters()
    wanted = {exercise: chapter for chapter in named for exercise in exercises(chapter)}
    if arguments.classroom:
        if arguments.rules:
            raise UsageError("--classroom counts exercises, whatever rules say: leave out --rules")
        return say_points(arguments.classroom, wanted)
    rules = Rules(arguments.rules, wanted)
    if arguments.prepare:
        from build.build import build
        from grading.judge import targets
        build([*targets(named), *named, "compare"])
        return 0
    if arguments.grade:
        say(json.dumps(graded(arguments.grade, wanted, rules), indent=1))
        return 0
    return write(arguments, named)


def graded(path: Path, wanted: dict[str, str], rules: Rules) -> dict:
    """Gradescope's results of one submission. Raises Failure where this machine reaches no verdict."""
    from grading.grade import complete, judged, refuse_failed
    from grading.judge import Judge
    from grading.submission import Submission, printable
    if not path.exists():
        raise UsageError(f"{printable(str(path))}: there is no such file or folder")
    with Judge(wanted) as judge:
        [one] = complete(*judged([Submission("submission", path)], judge), wanted)
    refuse_failed([one])
    return results_of(one, rules)


def results_of(one: dict, rules: Rules) -> dict:
    """As gradescope-autograders.readthedocs.io, "Autograder Specifications", has them."""
    tests = []
    known = {result["exercise"]: result for result in one["results"]}
    for number, (exercise, chapter) in enumerate(rules.wanted.items(), 1):
        result = known.get(exercise) or {"exercise": exercise, "state": "missing", "ok": False, "first_failure": one["error"], "hint": None}
        word, points = rules.mark({"student": one["student"], "handed_in_s": None}, result)
        said = [word if result["ok"] else result["first_failure"] or word, f"hint: {result['hint']}" if result.get("hint") else ""]
        tests.append({"name": exercise, "number": str(number), "score": round(points or 0.0, 4), "max_score": round(rules.points[exercise], 4),
                      "status": "passed" if result["ok"] else "failed", "output": "\n".join(filter(None, said)), "output_format": "text",
                      "tags": [chapter], "visibility": "visible"})
    said = one["error"] or f"{one['right']} of {one['of']} exercises are right"
    return {"score": round(sum(test["score"] for test in tests), 4), "output": said, "output_format": "text", "visibility": "visible",
            "stdout_visibility": "hidden", "tests": tests}


def say_points(file: Path, wanted: dict[str, str]) -> int:
    """GitHub Classroom reads two notices of the job. The exit code is 1 while an exercise is open. Raises UsageError for a file that
    lacks an exercise: where the checks were stopped, or the disc was full, those before would be all there are."""
    try:
        results = [json.loads(line) for line in file.read_text(encoding="utf-8").splitlines() if line.startswith("{")]
        lines = [f"{'ok  ' if one['ok'] else 'open'}  {one['exercise']}" + (f"  {one['first_failure']}" if one.get("first_failure") else "")
                 for one in results]
        right, of = sum(bool(one["ok"]) for one in results), len(results)
    except (OSError, ValueError, KeyError, TypeError, RecursionError) as error:
        raise UsageError(f"{file}: is not what ./course check --json prints: {error}") from None
    if lacking := sorted(set(wanted) - {one["exercise"] for one in results}):
        raise UsageError(f"{file}: lacks {lacking[0]}{f' and {len(lacking) - 1} more' if lacking[1:] else ''}: it is not all that ./course check --json "
                         "prints; --chapter NN takes those of one chapter")
    for line in lines:
        say(line.replace("::", ": :"))  # which a runner would take for its own
    say(f"::notice title=Autograding complete::Points {right}/{of}")
    say("::notice title=Autograding report::" + json.dumps({"totalPoints": right, "maxPoints": of}))
    return 0 if right == of else 1


def write(arguments, named: list[str]) -> int:
    if not (ROOT / ".git").exists():
        raise Failure("an autograder has the course as it was committed, and there is no git history here")
    chapter = f" --chapter {named[0][:2]}" if arguments.chapter else ""
    rules = " --rules rules.json" if arguments.rules else ""
    with new_folder(arguments.folder) as beside:
        for name, text in (gradescope_files(chapter, rules) | classroom_files(named[0][:2] if chapter else "all")).items():
            write_atomically(beside / name, text, 0o755 if name.endswith(("setup.sh", "run_autograder")) else 0o644)
        git("archive", "--format=tar.gz", "-o", str(beside / "gradescope/course.tar.gz"), "HEAD")
        if arguments.rules:
            shutil.copyfile(arguments.rules, beside / "gradescope/rules.json")
        shutil.make_archive(str(beside / "gradescope"), "zip", beside / "gradescope")
    say(f"{arguments.folder}: gradescope.zip to upload, and classroom to add to a ./course handout")
    warn("GitHub has announced the end of GitHub Classroom; the workflow runs in any repository")
    return 0


def packages() -> str:
    return " ".join(sorted({word for group in GROUPS for word in (ROOT / "common/course/packages" / group).read_text(encoding="utf-8").split()}))


def gradescope_files(chapter: str, rules: str) -> dict[str, str]:
    return {"gradescope/setup.sh": f"""#!/usr/bin/env bash
# Run once, when the image of the autograder is made: installs what grading takes, and builds it.
set -e
export DEBIAN_FRONTEND=noninteractive
apt-get update
apt-get install -y --no-install-recommends {packages()}
mkdir -p /autograder/course
tar -xzf /autograder/source/course.tar.gz -C /autograder/course
cd /autograder/course
./course handout --autograder --prepare{chapter}
chmod -R o+rX /autograder/course
""", "gradescope/run_autograder": f"""#!/usr/bin/env bash
# Run for each submission, which lies in /autograder/submission. What this machine fails at leaves no results, which
# Gradescope reports: it is no verdict on the answer.
set -e
cd /autograder/course
{'cp /autograder/source/rules.json .' if rules else ':'}
./course handout --autograder --grade /autograder/submission{chapter}{rules} >/autograder/results/results.json.part
mv /autograder/results/results.json.part /autograder/results/results.json
""", "gradescope/README.md": """# The course as a Gradescope autograder

Upload gradescope.zip (in the folder above) as the autograder of a programming assignment. Students hand in their folders
`chapters` and `shaders`, an archive of them, or single exercise files. The container must allow namespaces (bubblewrap).
"""}


def classroom_files(what: str) -> dict[str, str]:
    return {"classroom/.github/workflows/classroom.yml": f"""# Checks the exercises after each push. GitHub Classroom reads the points from the job's notices, of this name and no other.
name: Autograding Tests
on:
  push:
  workflow_dispatch:
permissions:
  contents: read
jobs:
  run-autograding-tests:
    runs-on: ubuntu-24.04
    container: debian:bookworm
    timeout-minutes: 60
    steps:
      - name: git, to fetch the repository with
        run: apt-get update && apt-get install -y --no-install-recommends ca-certificates git
      - uses: {CHECKOUT}
        with:
          persist-credentials: false
      - name: The checks
        run: ./course check {what} --json >results.jsonl || [ $? = 1 ]  # 1: some are open; 3: this machine cannot judge
      - name: The points
        run: ./course handout --autograder --classroom results.jsonl{'' if what == 'all' else f' --chapter {what}'}
""", "classroom/README.md": """# A starter repository

    ./course handout starter                the course without its solutions, into a folder of its own
    cp -r classroom/. starter               this folder, with its workflow
    cd starter && git init && git add --all && git commit -m "The course as it is handed out"

Push it, and mark it as a template in its settings: each student's repository is made from it. The checks in it are compiled for the
system that wrote the handout, Debian 12 for the workflow as it stands.
""", "classroom/.gitignore": "/build/\n__pycache__/\n*.pyc\n*.old\n/results.jsonl\n"}
