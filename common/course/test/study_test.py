"""Tests a chapter's study from a quick run of it: study_test.py NN_name. A failure is exit code 1 and a line.

Errors are asserted, times are not. Frames: a second run of one scene with one thread has the same errors; no NaN, no
infinity; the truth changes less than study.json allows when its samples are doubled, unless it is exact; and no error
grows where one knob of a curve gets better and the others stay. Better is higher, unless study.json says otherwise:

    "better": {"threshold": "lower", "angle_deg": "either"}

where nothing is asserted of "either". Loaders: the course's own read every float as it is.
"""

import json
from functools import partial
from pathlib import Path

from charts.study import SceneEntry, study_of
from shots.rendering import run_program, text
from test.need_test import run_study, sweep
from test.results import table
from tree import BUILD, ROOT, chapter_program, run_on_chapter, say

SIZE = [480, 270]  # or the study's "test_size": where its frames are slow, a test can do with fewer pixels
OWN_LOADERS = ("textbook", "scan", "parallel")


def study_to_test(chapter: str) -> dict:
    """The chapter's study, with no other scenes than "test_scenes" where it names some: for scenes that are slow."""
    study = study_of(chapter)
    if "test_scenes" in study:
        study["scenes"] = [scene for scene in study["scenes"] if SceneEntry(scene).label in study["test_scenes"]]
    return study


def quick_run(chapter: str, name: str, study: dict, **environment) -> dict:
    file = BUILD / "study" / f"{name}.{chapter}.json"
    size = "x".join(str(side) for side in study.get("test_size", SIZE))
    file.parent.mkdir(parents=True, exist_ok=True)
    options = []
    if study["scenes"] != study_of(chapter)["scenes"]:
        short = file.with_suffix(".study.json")
        short.write_text(json.dumps({key: value for key, value in study.items() if key != "charts"}), encoding="utf-8")
        options = ["--study-file", short]
    return run_study(chapter, file, "--size", size, *options, **environment)


def rows_of(chapter: str) -> list[dict]:
    study = study_to_test(chapter)
    first = quick_run(chapter, "quick", study)
    if first["subject"] == "loader":
        return loader_rows(first)
    scene = study["scenes"][-1]
    again = quick_run(chapter, "again", {**study, "scenes": [scene]}, LP_NUM_THREADS="1")
    errors = [[(point["scene"], point["method"], point["error"]) for point in run["points"]
               if point["scene"] == SceneEntry(scene).label] for run in (first, again)]
    differ = [a for a, b in zip(*errors) if a != b]
    rows = [{"case": "a second run, with one thread", "inputs": f"{len(errors[0])} points", "worst": len(differ),
             "bound": "0 differ", "ok": not differ and len(errors[0]) == len(errors[1]),
             "text": f"{differ[0][0]} {differ[0][1]} differs" if differ else "the same errors"}]
    whole = [ROOT / "chapters" / chapter / "study.json"] if "test_scenes" in study else []
    whole += sorted((ROOT / "chapters" / chapter).glob("study_*.json"))
    return [*rows, *map(partial(whole_row, chapter), whole), *frame_rows(study, first)]


def whole_row(chapter: str, file: Path) -> dict:
    """A study that this test does not run, or not with all of its scenes, can be read: zero rounds are refused only after
    reading."""
    done = run_program([chapter_program(chapter), "--study", BUILD / "study" / f"whole.{chapter}.json",
                        "--study-rounds", "0", "--study-file", file])
    read = "--study-rounds 0" in done.stderr
    return {"case": f"{file.name} with all of its scenes", "inputs": "1 file", "worst": "read" if read else "refused",
            "bound": "read", "ok": read, "text": "read" if read else done.stderr.strip()[-300:]}


def loader_rows(measured: dict) -> list[dict]:
    own = [point for point in measured["points"] if point["method"] in OWN_LOADERS]
    worst = max(own, key=lambda point: point["error"]["ulp"])
    return [{"case": "every float that the course's loaders read", "inputs": f"{len(own)} points", "bound": "0 ULP",
             "worst": f"{worst['error']['ulp']} ULP", "ok": worst["error"]["ulp"] == 0,
             "text": f"{worst['method']} of {worst['scene']}" if worst["error"]["ulp"] else "correctly rounded"}]


def frame_rows(study: dict, measured: dict) -> list[dict]:
    points = measured["points"]
    unfit = [point for point in points if point["error"]["nan"] or point["error"]["inf"] or
             any(value is None for value in point["error"].values())]
    rows = [] if study["truth"].get("exact") else [truth_row(study, measured)]
    rows.append({"case": "pixels that are NaN or infinite", "inputs": f"{len(points)} points", "worst": len(unfit),
                 "bound": "0 points", "ok": not unfit,
                 "text": f"{unfit[0]['scene']} {unfit[0]['method']}" if unfit else "none"})
    wanted = {(scene.label, point_key({**scene.set, **knobs})) for scene in map(SceneEntry, study["scenes"])
              for knobs in sweep(study, scene=scene.set)}
    found = {(point["scene"], point_key({"method": point["method"], **point["knobs"]})) for point in points}
    rows.append({"case": "points measured", "inputs": f"{len(wanted)} wanted", "worst": len(found),
                 "bound": len(wanted), "ok": found == wanted,
                 "text": "" if found == wanted else f"not {sorted(wanted ^ found)[0]}"})
    return rows + curve_rows(study.get("better", {}), measured)


def point_key(knobs: dict) -> str:
    """Equal for equal values, in any order and notation."""
    return " ".join(f"{name}={text(value)}" for name, value in sorted(knobs.items()))


def truth_row(study: dict, measured: dict) -> dict:
    change, most = measured["truth"]["doubling_change"], study["truth"]["most_change"]
    return {"case": "the truth, with its samples doubled", "inputs": f"{len(study['scenes'])} scenes", "worst": change,
            "bound": most, "ok": change <= most, "text": f"change of {measured['error_metric']}"}


def curve_rows(better: dict, measured: dict) -> list[dict]:
    """One for each line of points that differ in one knob, which has an order, alone."""
    metric, lines = measured["error_metric"], {}
    for point in measured["points"]:
        for name, value in point["knobs"].items():
            if metric in point["error"] and isinstance(value, (int, float)) and better.get(name) != "either":
                others = {key: other for key, other in point["knobs"].items() if key != name}
                lines.setdefault((point["scene"], point["method"], name, point_key(others)), []).append(
                    (value, point["error"][metric]))
    alone = {key[:3] for key in lines if sum(key[:3] == other[:3] for other in lines) == 1}
    rows = []
    for (scene, method, name, others), line in lines.items():
        if len({value for value, _ in line}) > 1:
            line.sort(key=lambda pair: pair[0], reverse=better.get(name) == "lower")
            among = method if (scene, method, name) in alone else f"{method}, {others}"
            rows.append(curve_row(scene, among, [error for _, error in line], name))
    return rows


def curve_row(scene: str, method: str, errors: list[float], knob: str = "samples") -> dict:
    """A better value is no worse."""
    ratios = [after / before if before else float(after > before) * 2 for before, after in zip(errors, errors[1:])]
    return {"case": f"{scene}, {method}: error over that of the {knob} before", "inputs": f"{len(errors)} points",
            "worst": max(ratios), "bound": "1", "ok": max(ratios) <= 1,
            "text": ", ".join(f"{error:.3g}" for error in errors)}


def main(chapter: str) -> list[str]:
    rows = rows_of(chapter)
    for row in rows:
        say(f"{'ok   ' if row['ok'] else 'wrong'}  {row['case']:62} {row['worst']}  {row['text']}")
    return table("stability", chapter, "study", f"./course study {chapter[:2]}", rows)


if __name__ == "__main__":
    run_on_chapter(main)
