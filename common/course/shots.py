"""Shots: named pictures, and the tests that compare them with their goldens.

tests/NN_name/shots.json says what they are. The chapter's executable reads it for --shot, this file for the tests:

    {"shots": [{
        "name": "bunny",                        the golden is tests/NN_name/golden/bunny.png
        "caption": "One sentence.",             for the gallery and the report
        "scene": "assets/models/bunny.obj",     what --scene takes, from the root; without it the chapter's own
        "size": [960, 540],                     pixels
        "time_s": 0, "frames": 1,               as --time and --frames
        "set": {"method": "phong"},             knobs
                                                -- from here on for this file alone; the executable passes over it --
        "exercises": ["02.phong"],              this picture shows these: it must reject the starter of each
        "rejects": [{"chapter": "01_obj"},      it must also reject the same scene as an earlier chapter draws it,
                    {"set": {"method": "none"}},         or with other knobs,
                    {"use": "exercise"}]                 or with another --use
    }]}

Only "name" and "caption" are required.

How much a picture may differ nobody writes: FLIP's mean and 99th percentile, and the most that any channel of any pixel
differs, in steps of 1/255, have the limits LIMITS, or MARGIN times what `./course accept` measured between drivers where
that is more. It keeps what it measured in tests/NN_name/golden/distances.json:

    {"SHOT": {"sse4.1": {"flip_mean": 0.0001, "flip_p99": 0.002, "max_diff": 3}}}

A picture that differs by NEVER_FAILS steps at most is right, whatever FLIP says: so much do the roundings of two makers'
processors differ. As a test (ctest runs these; a failure is exit code 1 and a line that says why):

    shots.py check NN_name SHOT    the reference's picture against the golden
    shots.py teeth NN_name SHOT    the golden against pictures that it must reject

Each writes what it found to build/results/shot.NN.SHOT.json or teeth.NN.SHOT.json, from which the report is made:

    {"kind": "shot" | "teeth", "chapter", "name", "caption", "ok": bool, "why": [lines], "again": a command,
     "seconds", "limits", "pictures": [{"name", "ok", "expected", "actual", "heatmap", "metrics"}]}

where metrics is what `compare --json` printed, or null, and paths count from the root. A shot has one picture, called
like the shot; teeth have one for each picture to be rejected ("02.phong as handed out", "drawn by 01_obj").
"""

import json
import math
import os
import sys
import time
from pathlib import Path

from draw_shots import render_unless_drawn, right_picture, wrong_pictures
from rendering import run_program
from tree import BUILD, ROOT, Failure, find_shots, relative, say, warn, write_atomically

LIMITS = {"flip_mean": 0.002, "flip_p99": 0.05, "max_diff": 64}
MARGIN = 3
NEVER_FAILS = 2  # steps of 1/255


def golden_path(chapter: str, name: str) -> Path:
    return ROOT / "tests" / chapter / "golden" / f"{name}.png"


def distances_path(chapter: str) -> Path:
    return ROOT / "tests" / chapter / "golden" / "distances.json"


def measured_distances(chapter: str) -> dict:
    """What ./course accept measured, by shot and driver. Empty where it did not."""
    path = distances_path(chapter)
    try:
        return json.loads(path.read_text()) if path.exists() else {}
    except ValueError as error:
        raise Failure(f"{relative(path)} cannot be read: {error}; ./course accept {chapter[:2]} writes it") from None


def limits_of(chapter: str, name: str) -> dict:
    found = measured_distances(chapter).get(name, {}).values()
    return {key: max([limit, *(MARGIN * distance[key] for distance in found)]) for key, limit in LIMITS.items()}


def compare(expected: Path, actual: Path, heatmap: Path | None = None) -> dict:
    """What build/compare --json says of two pictures. Raises Failure where they cannot be compared."""
    if heatmap:
        heatmap.parent.mkdir(parents=True, exist_ok=True)
    done = run_program([BUILD / "compare", expected, actual, "--json", *(["--heatmap", heatmap] if heatmap else [])])
    if done.returncode:
        raise Failure(done.stderr.strip() or f"compare ended with {done.returncode}")
    return json.loads(done.stdout)


def unfit(metrics: dict) -> list[str]:
    """Why a picture can be no golden and equal none, whatever it is compared with."""
    why = []
    if metrics["nearly_constant"]["test"]:
        why.append("the picture is nearly one colour: nothing was drawn")
    for kind in ("nan", "inf"):
        if metrics[kind]["test"]:
            why.append(f"{metrics[kind]['test']} pixels are {kind}")
    return why


def distance_of(metrics: dict) -> dict:
    """How far apart two pictures are, in the terms of LIMITS."""
    return {"flip_mean": metrics["flip"]["mean"], "flip_p99": metrics["flip"]["p99"],
            "max_diff": metrics["max_diff"]["steps"]}


def exceeded(metrics: dict, limits: dict) -> list[str]:
    """The limits that a comparison is over, one line each."""
    found = distance_of(metrics)
    if found["max_diff"] <= NEVER_FAILS and not any(math.isnan(value) for value in found.values()):
        return []
    why = []
    for name, limit in limits.items():
        if not found[name] <= limit:  # a NaN is over every limit
            where = f" at ({metrics['max_diff']['x']}, {metrics['max_diff']['y']})" if name == "max_diff" else ""
            why.append(f"{name} is {found[name]:.6g}{where}, at most {limit:.6g}")
    return why


def check(chapter: str, shot: dict) -> dict:
    """The reference's picture against the golden."""
    name, program, options, actual = right_picture(chapter, shot)
    heatmap = actual.with_suffix(".flip.png")
    golden = golden_path(chapter, name)
    metrics, why = None, []
    try:
        render_unless_drawn(chapter, program, options, actual)
        if golden.exists():
            metrics = compare(golden, actual, heatmap)
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
            metrics = compare(golden, actual, heatmap)
            ok = bool(exceeded(metrics, limits_of(chapter, shot["name"])))
            if not ok:
                why.append(f"the golden does not reject the picture: {name}")
        except Failure as failure:
            ok = False
            why.append(f"{name}: {failure}")
        pictures.append(picture_entry(name, ok, golden, actual, heatmap, metrics))
    return {"ok": not why, "why": why, "pictures": pictures}


def picture_entry(name, ok, golden, actual, heatmap, metrics) -> dict:
    return {"name": name, "ok": ok, "metrics": metrics,
            "expected": relative(golden) if golden.exists() else None,
            "actual": relative(actual) if actual.exists() else None,
            "heatmap": relative(heatmap) if metrics and heatmap.exists() else None}


def main(words: list[str]) -> int:
    if len(words) != 3 or words[0] not in ("check", "teeth"):
        warn("usage: shots.py check|teeth NN_name SHOT")
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
