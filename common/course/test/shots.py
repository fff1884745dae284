"""Tests of a chapter's shots against their goldens; a failure is exit code 1 and a line that says why.

    python3 common/course test.shots shots NN_name    the references' pictures against the goldens
    python3 common/course test.shots wrong NN_name    the goldens against pictures that they must reject

Each shot's result goes to build/results/shot.NN.SHOT.json or wrong_picture.NN.SHOT.json, from which the report is made:

    {"kind": "shot" | "wrong_picture", "chapter", "name", "test": the ctest, "caption", "ok": bool, "why": [lines], "again": a command,
     "limits", "pictures": [{"name", "ok", "expected", "actual", "heatmap", "metrics"}]}

where metrics is the output of `compare --json`, or null, and paths count from the root. A shot has one picture, called
like the shot; a golden has one for each picture to be rejected ("the starter of 02.phong", "drawn by 01_obj"), which is removed
once it is rejected. A heat map is written where pictures differ, or are not rejected.
"""

import json
import sys
from pathlib import Path

from shots.draw_shots import Picture, draw, right_picture, wrong_pictures
from shots.golden import compare, exceeded, golden_path, limits_of, unfit
from tree import BUILD, Failure, find_shots, relative, say, warn, write_atomically


def check(golden: Path, limits: dict, picture: Picture, failure: str, again: str) -> tuple[dict, str]:
    """The reference's picture against the golden: its entry in the result, and why it is wrong."""
    name, _, _, actual = picture
    if failure:
        return picture_entry(name, False, golden, actual), failure
    if not golden.exists():
        return picture_entry(name, False, golden, actual), f"there is no {relative(golden)}; look at {relative(actual)}, then {again}"
    metrics = compared(golden, actual, lambda found: found["max_diff"]["steps"] == 0)
    why = "; ".join(unfit(metrics) + exceeded(metrics, limits))
    return picture_entry(name, not why, golden, actual, metrics), why


def reject(golden: Path, limits: dict, picture: Picture, failure: str) -> tuple[dict, str]:
    """The golden against a picture that is wrong: it must be over a limit."""
    name, _, _, actual = picture
    if failure:
        return picture_entry(name, False, golden, actual), f"{name}: {failure}"
    metrics = compared(golden, actual, lambda found: exceeded(found, limits))
    if exceeded(metrics, limits):
        actual.unlink()  # the report has its figures alone, and all of them are 150 MB
        return picture_entry(name, True, golden, actual, metrics), ""
    return picture_entry(name, False, golden, actual, metrics), f"the golden does not reject the picture: {name}"


def compared(golden: Path, actual: Path, is_enough) -> dict:
    """compare(), with a heat map unless the figures are enough: writing one takes longer than computing it."""
    heatmap = actual.with_suffix(".flip.png")
    heatmap.unlink(missing_ok=True)
    metrics = compare(golden, actual)
    return metrics if is_enough(metrics) else compare(golden, actual, heatmap)


def picture_entry(name: str, ok: bool, golden: Path, actual: Path, metrics: dict | None = None) -> dict:
    heatmap = actual.with_suffix(".flip.png")
    return {"name": name, "ok": ok, "metrics": metrics,
            "expected": relative(golden) if golden.exists() else None,
            "actual": relative(actual) if actual.exists() else None,
            "heatmap": relative(heatmap) if metrics and heatmap.exists() else None}


def judge(test: str, chapter: str, shot: dict, pictures: list[Picture], failures: dict) -> bool:
    kind, name, number = {"shots": "shot", "wrong": "wrong_picture"}[test], shot["name"], chapter[:2]
    golden, limits, entries, why = golden_path(chapter, name), limits_of(chapter, name), [], []
    for picture in pictures:
        try:
            entry, wrong = check(golden, limits, picture, failures[picture[-1]], f"./course accept {number}.{name}") if kind == "shot" \
                else reject(golden, limits, picture, failures[picture[-1]])
        except Failure as failure:
            entry, wrong = picture_entry(picture[0], False, golden, picture[-1]), str(failure)
        entries.append(entry)
        why += [wrong] if wrong else []
    result = {"kind": kind, "chapter": chapter, "name": name, "test": f"{test if kind == 'shot' else kind}.{number}",
              "caption": shot.get("caption", ""), "again": f"./course run {number} --shot {name}", "limits": limits,
              "ok": not why, "why": why, "pictures": entries}
    write_atomically(BUILD / "results" / f"{kind}.{number}.{name}.json", json.dumps(result, indent=1) + "\n")
    for line in why:
        say(f"{chapter}.{name}: {line}")
    for entry in entries if why else []:
        for key in ("expected", "actual", "heatmap"):
            say(f"  {key:8} {entry[key] or 'none'}")
    return not why


def main(words: list[str]) -> int:
    if len(words) != 2 or words[0] not in ("shots", "wrong"):
        warn("usage: test.shots shots|wrong NN_name")
        return 2
    test, chapter = words
    # Grouped by scene, which is then read once.
    shots = sorted((shot for _, shot in find_shots(chapter)), key=lambda shot: shot.get("scene", ""))
    wanted = {shot["name"]: [right_picture(chapter, shot)] if test == "shots" else wrong_pictures(chapter, shot) for shot in shots}
    failures = draw([picture for pictures in wanted.values() for picture in pictures])
    right = [judge(test, chapter, shot, wanted[shot["name"]], failures) for shot in shots if wanted[shot["name"]]]
    say(f"{sum(right)} of {len(right)} are right")
    return 0 if all(right) else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
