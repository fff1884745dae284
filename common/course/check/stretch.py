"""Judges the stretch task of a chapter: the error of the reference, or less than the task names, in less time.

tests/NN_name/stretch.json:

    {"exercise": "02.blinn_phong", "task": "a sentence",
     "options": ["--scene", "assets/scenes/statue.json", "--size", "960x540"],
     "truth": ["--method", "exact"],   -- more options, for the picture that errors are measured against; default: none
     "pass": "shade",                  -- the timed pass
     "error": 0.001,                   -- FLIP's mean, at most; where it is missing: the reference's own
     "margin": 0.9}                    -- of the reference's time, at most

The error is of pictures drawn here and now, and the same each time. The time is the median over ROUNDS rounds of both versions,
drawn alternately, and the margin exceeds the difference of two runs of one version on a quiet machine.
"""

import json
import statistics

from build.build import build
from shots.golden import compare
from shots.rendering import render, run_program
from tree import BUILD, ROOT, Failure, UsageError, exercises, find_chapter, has_solutions, say

HELP = """Judges a chapter's stretch task: an exercise that reaches the error of the reference, in less time.

  ./course study 02 --stretch   your version against the reference, drawn alternately

It prints the error and the time of both, and what is still missing. Exit code 1 while the task is not met."""
ROUNDS, FRAMES = 7, 5


def add_arguments(parser):
    parser.add_argument("chapter", metavar="NN")
    parser.add_argument("--stretch", action="store_true", help="judge the stretch task")
    parser.add_argument("--json", action="store_true", help="print a JSON object")


def run(arguments, _rest) -> int:
    chapter = find_chapter(arguments.chapter)
    path = ROOT / "tests" / chapter / "stretch.json"
    if not path.exists():
        raise UsageError(f"chapter {chapter[:2]} has no stretch task")
    if not has_solutions():
        raise UsageError("this copy of the course has no reference to compare with")
    task = json.loads(path.read_text(encoding="utf-8"))
    if task["exercise"] not in exercises(chapter):
        raise Failure(f"{path.relative_to(ROOT)}: there is no exercise '{task['exercise']}'")
    build([chapter, "compare"])
    found = measure(chapter, task)
    why = missing(task, found)
    if arguments.json:
        say(json.dumps(found | {"missing": why}))
        return 1 if why else 0
    say(f"{task['exercise']}: {task['task']}")
    for who in ("reference", "yours"):
        one = found[who]
        say(f"  {who:9}  error {one['error']:.6f}  pass {task['pass']} {one['time_ms']:.3f} ms "
            f"({one['q1_ms']:.3f} to {one['q3_ms']:.3f})")
    say(f"  reached on {found['device']}" if not why else f"  {why}")
    return 1 if why else 0


def measure(chapter: str, task: dict, rounds: int = ROUNDS, frames: int = FRAMES) -> dict:
    """Errors and times of the reference and of the student's version of the task's exercise."""
    uses = {"reference": "solution", "yours": f"solution,{task['exercise']}=exercise"}
    folder = BUILD / "stretch" / chapter
    truth = folder / "truth.png"
    render(chapter, [*task["options"], *task.get("truth", []), "--use", "solution"], truth)
    found = {who: {"times": []} for who in uses}
    for who, use in uses.items():
        render(chapter, [*task["options"], "--use", use], folder / f"{who}.png")
        found[who]["error"] = compare(truth, folder / f"{who}.png")["flip"]["mean"]
    for _ in range(rounds):
        for who, use in uses.items():
            out = folder / "timings.json"
            done = run_program([BUILD / "chapters" / chapter, *task["options"], "--use", use, "--frames", frames,
                                "--timings", out])
            if done.returncode:
                raise Failure(done.stderr.strip())
            timings = json.loads(out.read_text(encoding="utf-8"))
            times = [one["gpu_ms"] for one in timings["passes"] if one["name"] == task["pass"]]
            if not times:
                raise Failure(f"there is no pass '{task['pass']}' in {chapter}")
            found[who]["times"].append(times[0])
            found["device"] = timings["device"]
    for who in uses:
        q1, median, q3 = statistics.quantiles(found[who].pop("times"), n=4)
        found[who] |= {"time_ms": median, "q1_ms": q1, "q3_ms": q3}
    return found


def missing(task: dict, found: dict) -> str:
    """The reason the task is not reached, in words; empty: none."""
    budget = task.get("error", found["reference"]["error"])
    if not found["yours"]["error"] <= budget:
        return f"its error is {found['yours']['error']:.6f}, at most {budget:.6f} is allowed"
    share = found["yours"]["time_ms"] / found["reference"]["time_ms"]
    if share > task["margin"]:
        return f"it takes {100 * share:.0f} % of the reference's time, at most {100 * task['margin']:.0f} % counts as less"
    return ""
