"""Draws the errors of a chapter's studies again on lavapipe, and fails where a digit that tables print has changed.

    python3 common/course test.redrawn NN_name [--tenth]

--tenth: the scenes that a tenth of all names selects, always the same ones. Errors of a software driver are deterministic;
times are not compared. Left out, with a line that says so: a study that another version of the driver measured, and one
whose errors are of an earlier version of the code and were not measured again since (./course study NN --errors).
"""

import hashlib
import json
import re
import subprocess
import sys

from charts import measured
from charts.study import device_slug, key_of
from charts.study_file import figures
from charts.study_shards import label_of
from tree import BUILD, ROOT, chapter_program, run_on_chapter, say

NOT_ERRORS = re.compile(r"_ms$|per_s$")  # measured beside the errors, different each time


def chosen(chapter: str, label: str, tenth: bool) -> bool:
    return not tenth or hashlib.sha256(f"{chapter} {label}".encode()).digest()[0] % 10 == 0


def redrawn(chapter: str, study: dict, request: dict, labels: list[str], name: str) -> dict:
    part = {key: value for key, value in request.items() if key == "title" or key not in measured.UNMEASURED}
    part["scenes"] = [scene for scene in request["scenes"] if label_of(scene) in labels]
    folder = BUILD / "study"
    folder.mkdir(parents=True, exist_ok=True)
    file, out = folder / f"redrawn.{name}.study.json", folder / f"redrawn.{name}.json"
    file.write_text(json.dumps(part), encoding="utf-8")
    out.with_name(out.name + ".partial").unlink(missing_ok=True)
    done = subprocess.run([chapter_program(chapter), "--study", out, "--study-file", file, "--study-rounds", "1",
                           "--size", "x".join(map(str, study["size"]))], cwd=ROOT, stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
    if done.returncode:
        return {"points": [], "failed": done.stdout.strip()[-300:]}
    return json.loads(out.read_text(encoding="utf-8"))


def compared(name: str, study: dict, again: dict, labels: list[str]) -> list[str]:
    if "failed" in again:
        return [f"{name}: it could not be drawn again: {again['failed']}"]
    new, wrong = {key_of(point): point for point in again["points"]}, []
    for point in study["points"]:
        if point["scene"] not in labels:
            continue
        row = f"{name}: {point['scene']}, {point['method']}, {json.dumps(point['knobs'])}"
        if key_of(point) not in new:
            wrong.append(f"{row}: the study no longer has this row")
            continue
        for metric, value in new[key_of(point)]["error"].items():
            old = point["error"].get(metric)
            if not NOT_ERRORS.search(metric) and None not in (old, value) and figures(old) != figures(value):
                wrong.append(f"{row}: {metric} is {figures(old)}, the program gives {figures(value)}")
    return wrong


def wrong_of(chapter: str, tenth: bool) -> list[str]:
    wrong = []
    for file in sorted((ROOT / "docs/studies").glob(f"{chapter}.*.json")):
        study = json.loads(file.read_text(encoding="utf-8"))
        request = ROOT / measured.request_of(study)
        if device_slug(study) != "lavapipe" or not {"truth", "size"} <= set(study) or not request.exists():
            continue
        if "errors_measured" not in study and measured.is_of_earlier(file):
            say(f"{file.stem}: errors of an earlier version; {study['command']}, with --errors, measures them again")
            continue
        asked = json.loads(request.read_text(encoding="utf-8"))
        labels = [label for label in map(label_of, asked["scenes"]) if label in study.get("scenes", {}) and chosen(chapter, label, tenth)]
        if not labels:
            continue
        again = redrawn(chapter, study, asked, labels, file.stem)
        if again.get("device", study["device"]) != study["device"]:
            say(f"{file.stem}: measured on {study['device']}, this is {again['device']}")
            continue
        wrong += compared(file.stem, study, again, labels)
    return wrong


def test_of(chapter: str) -> list[str]:
    found = wrong_of(chapter, TENTH)
    return found + [f"{len(found)} figures are of earlier code; the study's own command, with --errors, measures them again"] if found else []


TENTH = "--tenth" in sys.argv[2:]

if __name__ == "__main__":
    sys.argv = [word for word in sys.argv if word != "--tenth"]
    run_on_chapter(test_of)
