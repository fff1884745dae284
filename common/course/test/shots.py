"""Tests of shots against their goldens; a failure is exit code 1 and a line that says why.

    python3 common/course test.shots check NN_name SHOT    the reference's picture against the golden
    python3 common/course test.shots teeth NN_name SHOT    the golden against pictures that it must reject

Each writes its result to build/results/shot.NN.SHOT.json or teeth.NN.SHOT.json, from which the report is made:

    {"kind": "shot" | "teeth", "chapter", "name", "caption", "ok": bool, "why": [lines], "again": a command,
     "seconds", "limits", "pictures": [{"name", "ok", "expected", "actual", "heatmap", "metrics"}]}

where metrics is the output of `compare --json`, or null, and paths count from the root. A shot has one picture, called
like the shot; teeth have one for each picture to be rejected ("the starter of 02.phong", "drawn by 01_obj"), which is removed
once it is rejected. A heat map is written where pictures differ, or are not rejected.
"""

import json
import sys
import time

from shots.draw_shots import render_unless_drawn, right_picture, wrong_pictures
from shots.golden import compare, exceeded, golden_path, limits_of, unfit
from tree import BUILD, Failure, find_shots, relative, say, warn, write_atomically


def check(chapter: str, shot: dict) -> dict:
    """The reference's picture against the golden."""
    name, program, options, actual = right_picture(chapter, shot)
    heatmap = actual.with_suffix(".flip.png")
    golden = golden_path(chapter, name)
    metrics, why = None, []
    try:
        heatmap.unlink(missing_ok=True)
        render_unless_drawn(chapter, program, options, actual)
        if golden.exists():
            metrics = compared(golden, actual, heatmap, lambda found: found["max_diff"]["steps"] == 0)
            why = unfit(metrics) + exceeded(metrics, limits_of(chapter, name))
        else:
            why = [f"there is no {relative(golden)}; look at {relative(actual)}, then ./course accept "
                   f"{chapter[:2]}.{name}"]
    except Failure as failure:
        why = [str(failure)]
    return {"ok": not why, "why": why,
            "pictures": [picture_entry(name, not why, golden, actual, heatmap, metrics)]}


def teeth(chapter: str, shot: dict) -> dict:
    """The golden against pictures that are wrong: each must be over a limit."""
    golden = golden_path(chapter, shot["name"])
    why, pictures = [], []
    for name, program, options, actual in wrong_pictures(chapter, shot):
        heatmap = actual.with_suffix(".flip.png")
        metrics = None
        try:
            render_unless_drawn(chapter, program, options, actual)
            limits = limits_of(chapter, shot["name"])
            metrics = compared(golden, actual, heatmap, lambda found: exceeded(found, limits))
            ok = bool(exceeded(metrics, limits))
            if ok:
                actual.unlink()  # the report has its figures alone, and all of them are 150 MB
            else:
                why.append(f"the golden does not reject the picture: {name}")
        except Failure as failure:
            ok = False
            why.append(f"{name}: {failure}")
        pictures.append(picture_entry(name, ok, golden, actual, heatmap, metrics))
    return {"ok": not why, "why": why, "pictures": pictures}


def compared(golden, actual, heatmap, is_enough) -> dict:
    """compare(), with a heat map unless the figures are enough: writing one takes longer than computing it."""
    metrics = compare(golden, actual)
    return metrics if is_enough(metrics) else compare(golden, actual, heatmap)


def picture_entry(name, ok, golden, actual, heatmap, metrics) -> dict:
    return {"name": name, "ok": ok, "metrics": metrics,
            "expected": relative(golden) if golden.exists() else None,
            "actual": relative(actual) if actual.exists() else None,
            "heatmap": relative(heatmap) if metrics and heatmap.exists() else None}


def main(words: list[str]) -> int:
    if len(words) != 3 or words[0] not in ("check", "teeth"):
        warn("usage: test.shots check|teeth NN_name SHOT")
        return 2
    kind, chapter, name = words
    [(_, shot)] = find_shots(f"{chapter}.{name}")
    start = time.monotonic()
    result = check(chapter, shot) if kind == "check" else teeth(chapter, shot)
    label = "shot" if kind == "check" else "teeth"
    result = {"kind": label, "chapter": chapter, "name": name, "caption": shot.get("caption", ""),
              "again": f"./course run {chapter[:2]} --shot {name}", "seconds": round(time.monotonic() - start, 3),
              "limits": limits_of(chapter, name), **result}
    write_atomically(BUILD / "results" / f"{label}.{chapter[:2]}.{name}.json", json.dumps(result, indent=1) + "\n")
    for line in result["why"]:
        say(f"{chapter}.{name}: {line}")
    for picture in result["pictures"]:
        if picture["metrics"]:
            flip = picture["metrics"]["flip"]
            say(f"{picture['name']}: FLIP mean {flip['mean']:.6f}, p99 {flip['p99']:.6f}, "
                f"largest step {picture['metrics']['max_diff']['steps']}")
        if not result["ok"]:
            for key in ("expected", "actual", "heatmap"):
                say(f"  {key:8} {picture[key] or 'none'}")
    return 0 if result["ok"] else 1


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except Failure as error:
        warn(str(error))
        sys.exit(1)
