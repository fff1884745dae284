"""The report's card of a picture and its error: expected, actual, heat map, and the figures beside their limits."""

import json
from pathlib import Path

from pages.page import data_uri
from tree import ROOT

FIGURES = (("flip_mean", "FLIP mean", lambda m: m["flip"]["mean"]),
           ("flip_p99", "p99", lambda m: m["flip"]["p99"]),
           ("step_p999", "step of one pixel in a thousand", lambda m: m.get("step_p999")),
           ("max_diff", "largest step", lambda m: m["max_diff"]["steps"]))


class Pictures:
    def __init__(self):
        self.count = 0

    def image(self, path: str | None, alt: str, lossless: bool) -> dict:
        """alt, and uri and id, or an error that names the missing file."""
        try:
            if not path:
                raise OSError("there is none")
            uri = data_uri(ROOT / path, lossless)
        except OSError as error:
            return {"alt": alt, "error": error}
        self.count += 1
        return {"alt": alt, "uri": uri, "id": f"picture{self.count}"}

    def compare(self, picture: dict, lossless: bool) -> dict:
        """The images expected, actual and heat; no heat where they are equal, which are embedded once."""
        metrics, name = picture.get("metrics"), picture["name"]
        equal = bool(metrics) and metrics["max_diff"]["steps"] == 0
        expected = self.image(picture.get("expected"), f"{name}, expected", lossless)
        if equal and "id" in expected:
            actual = {"alt": f"{name}, actual", "same": expected["id"]}
        else:
            actual = self.image(picture.get("actual"), f"{name}, actual", lossless)
        both = "error" not in expected and "error" not in actual
        heat = self.image(picture.get("heatmap"), f"{name}, FLIP error", lossless) if both and not equal else None
        return {"name": name, "expected": expected, "actual": actual, "heat": heat}


def figures(metrics: dict | None, limits: dict | None) -> list[tuple]:
    measured = [(label, value_of(metrics), (limits or {}).get(key)) for key, label, value_of in FIGURES] if metrics else []
    return [figure for figure in measured if figure[1] is not None]


def read_result(path: Path) -> dict:
    """A result file, or a failed result that says why it cannot be read: the report must not lose it."""
    try:
        result = json.loads(path.read_text(encoding="utf-8"))
        if not isinstance(result, dict) or "kind" not in result or "chapter" not in result:
            raise ValueError('it needs "kind" and "chapter"')
        return result
    except (OSError, ValueError) as error:
        return {"kind": "unreadable", "chapter": "tests", "name": path.name, "ok": False,
                "why": [f"{path.name} cannot be used: {error}"]}
