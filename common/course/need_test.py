"""Tests a need rule over scenes that it was not fitted on: need_test.py NN_name. A failure is exit code 1 and a line.

    tests/NN_name/needs.json  {"size": [480, 270], "budgets": [0.002, 0.01], "scenes": ["assets/scenes/bunny.json"]}

where a scene is written as in study.json: a file, or {"scene": FILE, "set": {KNOB: VALUE}, "label": TEXT}. For each scene and budget the chapter chooses by itself (--method auto --budget E --explain). The picture that it then
draws may differ from the truth of the chapter's study by a mean FLIP of at most E, unless the rule said that no choice
would do and no point of the study's sweep does. How much more than needed the choice costs is reported: its predicted
cost, as --explain prints it, over that of the cheapest point of that sweep whose measured error is within the budget.
"""

import itertools
import json
import re
import statistics
from pathlib import Path

from results import table
from shots import compare, render, run_program, text
from study import SceneEntry, study_of
from tree import BUILD, ROOT, Failure, chapter_program, run_on_chapter, say

# "blinn_phong   samples 1: error 0.03545 predicted, 0.02403 million evaluations"
PREDICTED = re.compile(r"^(\S+)\s+(.*): error (\S+) predicted, (\S+) ")
CHOICE = re.compile(r"^choice: (.*?), ")
AIM = 1.25  # times the cost of the cheapest that would have done, in the median


def sweep(study: dict) -> list[dict]:
    """The study's points, each as the knobs that it sets."""
    points = []
    for curve in study["curves"]:
        knobs = {name: values if isinstance(values, list) else [values]
                 for name, values in curve.get("set", {}).items()}
        points += [{"method": curve["method"], **dict(zip(knobs, values))}
                   for values in itertools.product(*knobs.values())]
    return points


def label(knobs: dict) -> str:
    return " ".join([knobs["method"], *(f"{name} {text(value)}" for name, value in knobs.items() if name != "method")])


def set_options(knobs: dict) -> list[str]:
    return [word for name, value in knobs.items() for word in ("--set", f"{name}={text(value)}")]


class Explained:
    """What --explain printed: the choice as a label, each choice's predicted cost, and whether none would do."""

    def __init__(self, printed: str):
        self.cost, chosen = {}, None
        for line in printed.splitlines():
            if match := PREDICTED.match(line):
                self.cost[f"{match[1]} {match[2]}".strip()] = float(match[4])
            elif match := CHOICE.match(line):
                chosen = dict(word.split("=", 1) for word in match[1].split())
                self.none_would_do = "would be none" in line
        if not chosen:
            raise Failure(f"--explain names no choice: {printed.strip()[-300:]}")
        self.choice = label(chosen)

    def cost_of(self, wanted: str) -> float:
        """Of a point of the sweep, which need not name every knob that the explanation does."""
        words = wanted + " "
        return next(cost for name, cost in self.cost.items() if (name + " ").startswith(words))


class SceneNeeds:
    """One scene: its truth, and the measured error of each point of the sweep."""

    def __init__(self, chapter: str, study: dict, needs: dict, scene: SceneEntry):
        self.chapter = chapter
        self.name = scene.label
        self.folder = BUILD / "needs" / chapter
        self.file = re.sub(r"[^\w.-]", "_", scene.label)
        self.view = ["--scene", scene.file, "--size", "x".join(str(side) for side in needs["size"]),
                     *set_options(scene.set)]
        self.truth = self.picture("truth", study["truth"]["set"])
        self.errors = {label(knobs): self.error(self.picture(f"point{i}", knobs))
                       for i, knobs in enumerate(sweep(study))}

    def picture(self, name: str, knobs: dict) -> Path:
        path = self.folder / f"{self.file}.{name}.png"
        render(self.chapter, [*self.view, *set_options(knobs)], path)
        return path

    def error(self, picture: Path) -> float:
        return compare(self.truth, picture)["flip"]["mean"]

    def row(self, budget: float) -> dict:
        """How the rule did with a budget, as a row of the report; "ratio" is None where no point is within it."""
        picture = self.folder / f"{self.file}.auto{budget:g}.png"
        picture.unlink(missing_ok=True)
        done = run_program([chapter_program(self.chapter), *self.view, "--method", "auto", "--budget", budget,
                            "--explain", "--screenshot", picture])
        if done.returncode:
            raise Failure(f"{self.chapter} ended with {done.returncode}: {done.stderr.strip()[-500:]}")
        explained, error = Explained(done.stdout), self.error(picture)
        enough = [point for point, measured in self.errors.items() if measured <= budget]
        best = min(enough, key=explained.cost_of, default=None)
        ratio = explained.cost_of(explained.choice) / explained.cost_of(best) if best else None
        said = f"{explained.choice}; "
        said += f"{ratio:.2f}x the cost of {best}" if best else "no point of the sweep is within"
        if explained.none_would_do:
            said += "; the rule said that none would do"
        return {"case": f"{self.name}, budget {budget:g}", "inputs": f"{len(self.errors)} points in the sweep",
                "worst": error, "bound": budget, "text": said, "ratio": ratio,
                "ok": error <= budget or (explained.none_would_do and not enough)}


def main(chapter: str) -> list[str]:
    study = study_of(chapter)
    needs = json.loads((ROOT / "tests" / chapter / "needs.json").read_text())
    rows = [scene.row(budget) for scene in (SceneNeeds(chapter, study, needs, SceneEntry(entry))
                                    for entry in needs["scenes"])
            for budget in needs["budgets"]]
    ratios = [row["ratio"] for row in rows if row["ratio"] is not None]
    if ratios:
        rows.append({"case": "cost over that of the cheapest that would do, median",
                     "inputs": f"{len(ratios)} choices, worst {max(ratios):.2f}x",
                     "worst": statistics.median(ratios), "bound": f"aim: {AIM}", "ok": True,
                     "text": "reported, not asserted"})
    for row in rows:
        say(f"{'ok  ' if row['ok'] else 'OVER'}  {row['case']:28} {row['worst']:8.5f}  {row['text']}")
    again = f"build/chapters/{chapter} --scene FILE --method auto --budget E --explain --screenshot FILE"
    return table("stability", chapter, "need", again, rows)


if __name__ == "__main__":
    run_on_chapter(main)
