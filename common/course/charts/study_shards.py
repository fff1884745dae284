"""A study in shards: cut by the scenes of study.json, because the truth of a scene serves all of its points and their times are
taken in turns. A loader's study is one piece. Times of two machines never meet in one file: a merge refuses them.
"""

import json
import re
from pathlib import Path

from charts.study_file import SOFTWARE
from many import shards
from tree import BUILD, Failure, UsageError, write_atomically

# Descriptive fields of a measured study, repeated in each of its pieces.
OF_ALL = ("title", "subject", "device", "driver", "stage", "size", "command", "truth", "error_metric", "metrics", "time_unit")


def labels(study: dict) -> list[str]:
    """The pieces of a study: its scenes, or "" for one that cannot be cut."""
    if "truth" not in study:
        return [""]
    return [label_of(scene) for scene in study["scenes"]]


def label_of(scene) -> str:
    scene = scene if isinstance(scene, dict) else {"scene": scene}
    return scene.get("label") or Path(scene["scene"]).stem


def taken(chapter: str, study: dict, shard: shards.Shard) -> list[str]:
    return [label for label in labels(study) if shard.takes(f"{chapter} {label}")]


def part_of(chapter: str, study: dict, taken_labels: list[str], shard: shards.Shard) -> Path | None:
    """A study.json with these scenes alone; None for the chapter's own. Charts are drawn of the whole."""
    if taken_labels == [""]:
        return None
    part = {key: value for key, value in study.items() if key != "charts"}
    part["scenes"] = [scene for scene in study["scenes"] if label_of(scene) in taken_labels]
    file = BUILD / "study" / f"{chapter}.{shard.number}-of-{shard.of}.study.json"
    write_atomically(file, json.dumps(part, indent=1))
    return file


def entries(chapter: str, measured: dict) -> dict[str, dict]:
    of_all = {key: measured[key] for key in OF_ALL if key in measured} | {"machine": machine(measured)}
    if measured.get("subject") == "loader":
        return {f"{chapter}/": {"study": of_all, "whole": measured}}
    return {f"{chapter}/{label}": {"study": of_all, "scene": scene,
                                   "points": [point for point in measured["points"] if point["scene"] == label]}
            for label, scene in measured["scenes"].items()}


def machine(measured: dict) -> str:
    """Conditions of a time: the device and its driver, and of a software driver the processor."""
    device = f"{measured.get('device', '')}, {measured.get('driver', '')}".strip(", ")
    if device and not any(name in device.lower() for name in SOFTWARE):
        return device
    found = re.search(r"^model name\s*:\s*(.*)$", Path("/proc/cpuinfo").read_text(encoding="utf-8"), re.M)
    return ", ".join(word for word in (device, found[1] if found else "") if word)


def whole(chapter: str, study: dict, made: shards.Merged) -> dict | None:
    """The chapter's measured study, as one run would have written it; None where no shard has a piece of it. Raises
    UsageError for times of two machines, Failure where the chapter has other scenes by now."""
    parts = {name.partition("/")[2]: entry for name, entry in made.entries.items() if name.partition("/")[0] == chapter}
    if not parts:
        return None
    by_machine = {entry["study"]["machine"]: made.came_from[f"{chapter}/{label}"] for label, entry in parts.items()}
    if len(by_machine) > 1:
        said = " and ".join(f"{file.name} on {name}" for name, file in sorted(by_machine.items())[:2])
        raise UsageError(f"{chapter} was measured in {said}: times of two machines are never in one chart; make one of them "
                         "again where the other was made")
    if set(parts) != set(labels(study)):
        raise Failure(f"{chapter}: the shards have {', '.join(sorted(parts))}, its study {', '.join(labels(study))}")
    if "" in parts:
        return parts[""]["whole"]
    of_all = next(iter(parts.values()))["study"]
    result = {"chapter": chapter} | {key: value for key, value in of_all.items() if key != "machine"}
    result["truth"] = {key: value for key, value in of_all["truth"].items() if key != "doubling_change"}
    if "exact" not in result["truth"]:
        result["truth"]["doubling_change"] = max(part["scene"]["doubling"][of_all["error_metric"]] for part in parts.values())
    result["scenes"] = {label: parts[label]["scene"] for label in labels(study)}
    result["points"] = [point for label in labels(study) for point in parts[label]["points"]]
    if "charts" in study:
        result["charts"] = study["charts"]
    return dict(sorted(result.items()))
