"""Times of single passes that lessons quote, measured as chapters/NN_name/timings.json says.

    {
      "size": [1920, 1080], "frames": 40,
      "runs": [
        {"scene": "nebula", "words": "--scene scenes/nebula.json", "knob": "volume.method", "methods": ["midpoint", "skipping"]},
        {"scene": "colonnade", "program": "05_shadow_maps", "methods": {"raster": "", "visibility": "--set objects.shaded=visibility"}}
      ]
    }

A run is a program (the chapter's own where none is named) with `words`, drawn once for each method: a value of `knob`, or a name
with words of its own. `size` and `frames` of a run replace those of the file. The result is docs/studies/tables/NN_name.DEVICE.json:
points as in a study, whose `error` has what the chapter counts ("5177 mixed" is {"mixed": 5177}). pages/tables.py reads it.
"""

import json
import re
import shlex
import subprocess
import tempfile
from pathlib import Path

from charts.measured import here
from tree import ROOT, Failure, chapter_program, find_chapter, relative, say, warn, write_atomically

FOLDER = ROOT / "docs" / "studies" / "tables"


def request_of(chapter: str, file: str = "timings.json") -> dict:
    """What such a file of a chapter says; {} where it has none. Raises Failure where it cannot be used."""
    path = ROOT / "chapters" / chapter / file
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        return {}
    except ValueError as error:
        raise Failure(f"{relative(path)} is not JSON: {error}") from None


def programs(chapter: str) -> list[str]:
    return sorted({find_chapter(run.get("program", chapter)) for run in request_of(chapter)["runs"]})


def methods(run: dict) -> dict[str, str]:
    if isinstance(run["methods"], dict):
        return run["methods"]
    return {str(value): f"--set {run['knob']}={value}" for value in run["methods"]}


def point_of(scene: str, method: str, found: dict) -> dict:
    # A pass that is recorded several times in a frame has as many samples.
    passes = {one["name"]: one["gpu_ms"] * max(1, round(one["frames"] / found["frames"]))
              for one in found["passes"] if not one["name"].startswith("read back")}
    counts = {word: int(number.replace(",", "")) for line in found["status"] for number, word in re.findall(r"\b(\d[\d,]*) ([a-z]+)", str(line))}
    return {"scene": scene, "method": method, "knobs": {}, "error": counts,
            "time_ms": {"median": sum(passes.values()), "per_pass": passes,
                        "once": {one["name"]: one["gpu_ms"] for one in found["once"]}}}


def measure(chapter: str, device: str | None, size: str | None) -> dict:
    request, points, found = request_of(chapter), [], {}
    for run in request["runs"]:
        for method, own in methods(run).items():
            warn(f"{chapter}: {run['scene']}, {method}")
            pixels = size or "{}x{}".format(*run.get("size", request["size"]))
            with tempfile.TemporaryDirectory() as folder:
                out = Path(folder, "timings.json")
                command = [chapter_program(find_chapter(run.get("program", chapter))), *shlex.split(f"{run.get('words', '')} {own}"),
                           "--size", pixels, "--frames", str(run.get("frames", request["frames"])), "--timings", out,
                           *(["--device", device] if device else [])]
                if subprocess.run(command, cwd=ROOT, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL).returncode:
                    raise Failure(f"it failed: {shlex.join(map(str, command))}")
                found = json.loads(out.read_text(encoding="utf-8"))
            points.append(point_of(run["scene"], method, found))
    asked = f" --size {size}" if size else ""
    measured = "+".join(here(name, f"chapters/{chapter}/timings.json") for name in programs(chapter))
    return {"chapter": chapter, "programs": programs(chapter), "measured": measured,
            "command": f"./course study {chapter[:2]} --timings{asked}",
            "device": found["device"], "driver": found["driver"], "size": found["size"], "points": points}


def run(named: list[str], device: str | None, size: str | None, folder: Path, slug) -> None:
    """Measures the chapters that have such a file; `slug` names a device in a file's name."""
    for chapter in named:
        timed = measure(chapter, device, size)
        file = folder / f"{chapter}.{slug(timed)}.json"
        file.parent.mkdir(parents=True, exist_ok=True)
        write_atomically(file, json.dumps(timed, indent=1, ensure_ascii=False) + "\n")
        say(relative(file))
