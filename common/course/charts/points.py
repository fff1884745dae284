"""The picture behind a point of a study's chart: the request for a chapter's program."""

import json

from tree import chapters


def can_draw(study: dict) -> bool:
    """True if the points are pictures of scenes in the course."""
    return study["subject"] == "frame" and bool(study.get("scenes")) and "truth" in study and study["chapter"] in chapters()


def request_of(study: dict, point: dict, truth: bool = False) -> tuple[str, dict[str, str]] | None:
    """The scene's file and the knobs of a point, or of the truth beside it; None where the point has no scene."""
    scene = study["scenes"].get(point["scene"], {})
    if not scene.get("file"):
        return None
    own = study["truth"] if truth else point
    method = {study.get("method_knob", "method"): own["method"]} if own.get("method") else {}
    return scene["file"], method | {name: text(value) for part in (scene.get("set", {}), own.get("knobs", {})) for name, value in part.items()}


def words_of(study: dict, point: dict) -> tuple[str, ...]:
    """The same as words of a command line; none where the point has no scene."""
    request = request_of(study, point)
    return ("--scene", request[0], *(word for knob in request[1].items() for word in ("--set", "=".join(knob)))) if request else ()


def text(value) -> str:
    """A knob's value as --set takes it."""
    return "on" if value is True else "off" if value is False else value if isinstance(value, str) else json.dumps(value)
