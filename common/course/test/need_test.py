"""Tests a chapter's need rule on scenes of its own: need_test.py NN_name. A failure is exit code 1 and a line.

    tests/NN_name/needs.json  {"size": [320, 180], "budgets": [0.002, 0.01], "scenes": ["assets/scenes/bunny.json"],
                               "more_scenes": ["assets/scenes/lava.json"],
                               "large": {"size": [640, 360], "scenes": ["assets/scenes/cups.json"]}}

where a scene is written as in study.json: a file, or {"scene": FILE, "set": {KNOB: VALUE}, "label": TEXT}. In one
process, a study, the chapter chooses for each scene and budget, and every candidate is drawn and timed. The error of the
choice's whole picture may be above the budget only where the rule said that none would do, and none would. The time of
the choice over that of the cheapest candidate that would have done is asserted in the median: times on a machine that
does other things too are noisy. --all adds "more_scenes" and the chapter's further studies, too slow for a
suite: "studies": {"study_NAME.json": {"size": ..., "budgets": ..., "scenes": ...}}. It writes all choices to
build/needs/NN_name.auto.json, which a lesson quotes from docs/studies/tables. Under "large" the rule may not draw whole
pictures where crops decide. The first scene also tests --explain --json.
"""

import json
import os
import sys
import statistics
from pathlib import Path

from charts.measured import here
from charts.study import SceneEntry
from charts.timings import request_of
from shots.golden import compare
from shots.rendering import render, run_program, text
from test.results import table
from tree import BUILD, ROOT, Failure, chapter_program, run_on_chapter, say, write_atomically

AIM = 1.15    # times the cost of the cheapest that would have done, in the median
SLACK = 1.3  # times that much is not a failure: the rule and this test time frames for themselves
TRIES = 3     # of the times, where the median is above: a busy machine slows single frames
SAME = 1e-6   # a mean FLIP: how far a picture redrawn may be from the one that was judged


def label(method: str, knobs: dict) -> str:
    return " ".join([method, *(f"{name} {text(value)}" for name, value in sorted(knobs.items()))])


def set_options(knobs: dict) -> list[str]:
    return [word for name, value in knobs.items() for word in ("--set", f"{name}={text(value)}")]


def measure(chapter: str, needs: dict, crops: bool, of: str = "study.json") -> dict:
    """The study `of` the scenes of `needs`: all candidates, and the rule's choice for each budget."""
    study = request_of(chapter, of)
    asked = {**study, "size": needs["size"], "scenes": needs["scenes"], "budgets": needs["budgets"], "crops": crops,
             "curves": study.get("candidates", study["curves"]), "error_metric": "flip_mean",
             "truth": {"set": study["truth"]["set"], "exact": True}}
    for key in ("charts", "candidates"):
        asked.pop(key, None)
    folder = BUILD / "needs"
    folder.mkdir(parents=True, exist_ok=True)
    name = f"{chapter}.{Path(of).stem}.{'large' if crops else 'small'}"
    file, out = folder / f"{name}.asked.json", folder / f"{name}.json"
    file.write_text(json.dumps(asked, indent=1), encoding="utf-8")
    out.with_name(out.name + ".partial").unlink(missing_ok=True)
    # A time is that of the whole rasteriser, which filling unwritten memory would slow.
    done = run_program([chapter_program(chapter), "--study", out, "--study-file", file, "--study-rounds", "1"], MALLOC_PERTURB_="0",
                       LP_NUM_THREADS=str(os.cpu_count() or 1))
    if done.returncode:
        raise Failure(f"the study of {chapter} ended with {done.returncode}: {done.stderr.strip()[-500:]}")
    return json.loads(out.read_text(encoding="utf-8"))


def rows_of_study(measured: dict) -> list[dict]:
    rows = []
    for scene, entry in measured["scenes"].items():
        points = {label(point["method"], {name: value for name, value in point["knobs"].items()
                                          if name not in entry["set"]}): point
                  for point in measured["points"] if point["scene"] == scene}
        rows += [row(scene, points, choice) for choice in entry["choices"]]
    return rows


def row(scene: str, points: dict, said: dict) -> dict:
    """How the rule did with a budget, as a row of the report; "ratio" is None where no candidate is within it."""
    budget, chosen = said["budget"], label(said["choice"]["method"], said["choice"]["knobs"])
    time = {name: point["time_ms"]["median"] for name, point in points.items()}
    error = points[chosen]["error"]["flip_mean"]
    enough = [name for name, point in points.items() if point["error"]["flip_mean"] <= budget]
    best = min(enough, key=time.get, default=None)
    ratio = time[chosen] / time[best] if best else None
    words = f"{chosen}; "
    words += f"{ratio:.2f}x the time of {best}" if best else "no candidate is within"
    if said["none_would_do"]:
        words += "; the rule said that none would do"
    return {"case": f"{scene}, budget {budget:g}", "inputs": f"{len(points)} candidates, {said['crops']} crops",
            "worst": error, "bound": budget, "text": words, "ratio": ratio, "choosing_ms": said["choosing_ms"],
            "crops": said["crops"], "truth_ms": said["truth_ms"],
            "ok": error <= budget and not said["none_would_do"] if enough else said["none_would_do"]}


def median_row(rows: list[dict]) -> dict:
    ratios = [row["ratio"] for row in rows if row["ratio"] is not None]
    return {"case": "time over that of the cheapest that would do, median",
            "inputs": f"{len(ratios)} choices, worst {max(ratios):.2f}x", "worst": statistics.median(ratios),
            "bound": f"{AIM}, asserted {AIM * SLACK:.2f}", "ok": statistics.median(ratios) <= AIM * SLACK,
            "text": "each frame timed once"}


def command_line_row(chapter: str, needs: dict) -> dict:
    """--method auto --explain --json reports its actual choice, and the picture has that error."""
    scene, budget = SceneEntry(needs["scenes"][0]), needs["budgets"][-1]
    folder = BUILD / "needs" / chapter
    folder.mkdir(parents=True, exist_ok=True)
    view = ["--scene", scene.file, "--size", "x".join(map(str, needs["size"])), *set_options(scene.set)]
    done = run_program([chapter_program(chapter), *view, "--method", "auto", "--budget", budget, "--explain", "--json",
                        "--screenshot", folder / "auto.png"])
    if done.returncode:
        raise Failure(f"{chapter} ended with {done.returncode}: {done.stderr.strip()[-500:]}")
    said = json.loads(done.stdout)
    choice = said["choice"]
    render(chapter, [*view, "--method", choice["method"], *set_options(choice["knobs"])], folder / "chosen.png")
    error = compare(folder / "auto.png", folder / "chosen.png")["flip"]["mean"]
    return {"case": f"{scene.label}, budget {budget:g}, from the command line",
            "inputs": f"{len(said['candidates'])} candidates", "worst": error, "bound": SAME,
            "ok": error <= SAME and choice in said["candidates"] and choice["enough"],
            "text": f"draws {label(choice['method'], choice['knobs'])}"}


def choices(chapter: str, measured: dict) -> dict:
    """A point for each scene and budget, with the method chosen in words and the error of its whole picture."""
    rows = rows_of_study(measured)
    said = [(scene, choice) for scene, entry in measured["scenes"].items() for choice in entry["choices"]]
    points = [{"scene": scene, "method": choice["choice"]["method"], "knobs": {"budget": choice["budget"]},
               "choice": ", ".join([choice["choice"]["method"], *(f"{text(value)} {name}" for name, value in choice["choice"]["knobs"].items())]),
               "error": {"flip_mean": row["worst"]}}
              for (scene, choice), row in zip(said, rows)]
    return {"chapter": chapter, "measured": here(chapter),
            "command": f"python3 common/course test.need_test {chapter} --all",
            **{key: measured[key] for key in ("device", "driver", "size")}, "points": points}


def measured_rows(chapter: str, needs: dict, everything: bool) -> list[dict]:
    measured = measure(chapter, needs, crops=False)
    rows = rows_of_study(measured)
    if everything:
        write_atomically(BUILD / "needs" / f"{chapter}.auto.json", json.dumps(choices(chapter, measured), indent=1) + "\n")
    if "large" in needs:
        large = rows_of_study(measure(chapter, {**needs, **needs["large"]}, crops=True))
        rows += [{**row, "case": row["case"] + ", large"} for row in large]
    for study, more in needs.get("studies", {}).items():
        rows += [{**row, "case": row["case"] + f", {study}"} for row in rows_of_study(measure(chapter, more, False, study))]
    return rows + [median_row(rows)]


def main(chapter: str, everything: bool = False) -> list[str]:
    needs = json.loads((ROOT / "tests" / chapter / "needs.json").read_text(encoding="utf-8"))
    if everything:
        needs["scenes"] += needs.get("more_scenes", [])
    else:
        needs.pop("studies", None)
    for _ in range(TRIES):
        rows = measured_rows(chapter, needs, everything)
        if rows[-1]["ok"]:
            break
    rows.append(command_line_row(chapter, needs))
    for row in rows:
        say(f"{'ok  ' if row['ok'] else 'OVER'}  {row['case']:44} {row['worst']:8.5f}  {row['text']}")
    again = f"build/chapters/{chapter} --scene FILE --method auto --budget E --explain --screenshot FILE"
    return table("stability", chapter, "need", again, rows)


if __name__ == "__main__":
    everything = "--all" in sys.argv
    sys.argv = [word for word in sys.argv if word != "--all"]
    run_on_chapter(lambda chapter: main(chapter, everything))
