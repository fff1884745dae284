"""Goldens: the accepted pictures of shots, and the allowed difference.

tests/NN_name/shots.json lists a chapter's shots. The chapter's executable reads it for --shot, Python for the tests:

    {"best": "bunny",                           the gallery and the menu show it first, the window opens on it; else the first
     "shots": [{
        "name": "bunny",                        the golden is tests/NN_name/golden/bunny.png
        "caption": "One sentence.",             for the gallery and the report
        "scene": "assets/models/bunny.obj",     for --scene, from the root; without it the chapter's own
        "size": [960, 540],                     pixels
        "time_s": 0, "frames": 1,               as --time and --frames
        "set": {"method": "phong"},             knobs
                                                -- from here on for the tests alone; the executable passes over it --
        "exercises": ["02.phong"],              this picture shows these: it must reject the starter of each
        "rejects": [{"chapter": "01_obj"},      it must also reject the same scene as an earlier chapter draws it,
                    {"set": {"method": "none"}},         or with other knobs,
                    {"use": "exercise"}]                 or with another --use
    }]}

Only "name" and "caption" are required.

How much a picture may differ nobody writes: FLIP's mean and 99th percentile, and the most that any channel of any pixel
differs, in steps of 1/255, have the limits LIMITS, or MARGIN times the difference between drivers measured by `./course accept`
if that is more. Its measurements are in tests/NN_name/golden/distances.json:

    {"SHOT": {"sse4.1": {"flip_mean": 0.0001, "flip_p99": 0.002, "max_diff": 3}}}

A picture that differs by NEVER_FAILS steps at most is right, for any FLIP: so much do the roundings of two makers'
processors differ.

A hardware device (`./course test --device`) has limits of its own, HARDWARE_LIMITS. step_p999 is the step that at least one pixel
in a thousand reaches: the largest step would be that of a single texel at a silhouette. A shot that needs more has the
measured figures in distances.json as well, under a part of the device's name, with the cause in words; the limit is
HARDWARE_MARGIN times the figure:

    {"SHOT": {"NVIDIA H200": {"flip_mean": 0.0165, "cause": "filter weights of 8 bits"}}}
"""

import atexit
import functools
import json
import math
import threading
from pathlib import Path

from shots.rendering import Asked
from tree import BUILD, ROOT, Failure, relative

LIMITS = {"flip_mean": 0.002, "flip_p99": 0.05, "max_diff": 64}
MARGIN = 3
NEVER_FAILS = 2  # steps of 1/255
HARDWARE_LIMITS = {"flip_mean": 0.01, "flip_p99": 0.06, "step_p999": 32}
HARDWARE_MARGIN = 1.25
comparing = threading.Lock()


def golden_path(chapter: str, name: str) -> Path:
    return ROOT / "tests" / chapter / "golden" / f"{name}.png"


def distances_path(chapter: str) -> Path:
    return ROOT / "tests" / chapter / "golden" / "distances.json"


def recorded_distances(chapter: str) -> dict:
    """The contents of distances.json, by shot and driver or device. Empty without any."""
    path = distances_path(chapter)
    try:
        return json.loads(path.read_text(encoding="utf-8")) if path.exists() else {}
    except ValueError as error:
        raise Failure(f"{relative(path)} cannot be read: {error}; ./course accept {chapter[:2]} writes it") from None


def measured_distances(chapter: str) -> dict:
    return {name: {driver: distance for driver, distance in of.items() if "cause" not in distance}
            for name, of in recorded_distances(chapter).items()}


def hardware_distances(chapter: str, name: str) -> dict:
    """A shot's figures above HARDWARE_LIMITS with their cause, by part of a device's name."""
    return {device: distance for device, distance in recorded_distances(chapter).get(name, {}).items() if "cause" in distance}


def limits_of(chapter: str, name: str) -> dict:
    return limits_by(measured_distances(chapter).get(name, {}).values())


def limits_by(found) -> dict:
    return {key: max([limit, *(MARGIN * distance[key] for distance in found)]) for key, limit in LIMITS.items()}


def hardware_limits(chapter: str, name: str, device: str) -> tuple[dict, list[str]]:
    """A shot's limits on a hardware device, and why any is wider than HARDWARE_LIMITS."""
    found = [distance for part, distance in hardware_distances(chapter, name).items() if part in device]
    limits = {key: max([limit, *(HARDWARE_MARGIN * distance.get(key, 0) for distance in found)])
              for key, limit in HARDWARE_LIMITS.items()}
    return limits, [distance["cause"] for distance in found]


def compare(expected: Path, actual: Path, heatmap: Path | None = None) -> dict:
    """Output of build/compare --json for two pictures. Raises Failure if they cannot be compared."""
    if heatmap:
        heatmap.parent.mkdir(parents=True, exist_ok=True)
    with comparing:
        found, said, code = comparer().ask([str(expected), str(actual), *(["--heatmap", str(heatmap)] if heatmap else [])])
    if not found or "error" in found:
        raise Failure(found["error"] if found else said.strip() or f"compare ended with {code}")
    return found


@functools.cache
def comparer() -> Asked:
    """One process for all comparisons."""
    asked = Asked([BUILD / "compare", "--pairs"])
    atexit.register(asked.close)
    return asked


def unfit(metrics: dict) -> list[str]:
    """Why a picture can be no golden and equal none."""
    why = []
    if metrics["nearly_constant"]["test"]:
        why.append("the picture is nearly one colour: nothing was drawn")
    for kind in ("nan", "inf"):
        if metrics[kind]["test"]:
            why.append(f"{metrics[kind]['test']} pixels are {kind}")
    return why


def distance_of(metrics: dict) -> dict:
    """How far apart two pictures are, in the terms of LIMITS and, where it was measured, HARDWARE_LIMITS."""
    found = {"flip_mean": metrics["flip"]["mean"], "flip_p99": metrics["flip"]["p99"], "max_diff": metrics["max_diff"]["steps"]}
    return found | ({"step_p999": metrics["step_p999"]} if "step_p999" in metrics else {})


def exceeded(metrics: dict, limits: dict) -> list[str]:
    found = distance_of(metrics)
    if found["max_diff"] <= NEVER_FAILS and not any(math.isnan(value) for value in found.values()):
        return []
    why = []
    for name, limit in limits.items():
        if not found[name] <= limit:  # a NaN is over every limit
            where = f" at ({metrics['max_diff']['x']}, {metrics['max_diff']['y']})" if name == "max_diff" else ""
            why.append(f"{name} is {found[name]:.6g}{where}, at most {limit:.6g}")
    return why
