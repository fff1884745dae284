"""Studies: reading and checking the JSON of `--study`, and values derived from its points.

docs/study_format.md has the format. Nothing here draws.
"""
import json
import math
import pathlib
from functools import cached_property

from charts.verdict import verdict_of

METRICS = {  # key in a point's "error": (label on an axis, value for one 8-bit step at mid grey)
    "flip_mean": ("FLIP, mean", 0.0299),
    "flip_p99": ("FLIP, 99th percentile", 0.0299),
    "rmse": ("RMSE, linear light", 0.00367),
    "relative_rmse": ("relative RMSE", 0.0154),
    "max": ("largest error, linear light", 0.00367),
    "ulp": ("largest error, ULP", None),
}
SOFTWARE = ("llvmpipe", "lavapipe", "swiftshader", "softpipe")


class StudyError(Exception):
    """An unusable study; the text is one line with the fault and the remedy."""


class Point:
    """One measured way to do a thing. `time` is (q1, median, q3) in the study's unit, `error` the study's metric."""

    def __init__(self, data, metric, unit):
        self.data = data
        self.scene = data["scene"]
        self.method = data["method"]
        self.knobs = data.get("knobs", {})
        self.error = number(data["error"].get(metric))
        spread = data["mb_per_s" if unit == "MB/s" else "time_ms"]
        self.time = tuple(number(spread[key]) for key in ("q1", "median", "q3"))
        self.nan, self.inf = data["error"].get("nan", 0), data["error"].get("inf", 0)

    @property
    def drawable(self):
        return math.isfinite(self.error) and math.isfinite(self.time[1]) and self.time[1] > 0


class Study:
    """A checked study. `higher_is_faster` where time is a throughput (MB/s)."""

    def __init__(self, data, methods_beside=()):
        self.data, self.methods_beside = data, methods_beside
        for key in ("chapter", "title", "subject", "device", "driver", "stage", "command", "error_metric", "points"):
            if key not in data:
                raise StudyError(f'has no "{key}"; docs/study_format.md says what a study holds')
        if data["subject"] not in ("frame", "loader"):
            raise StudyError(f'"subject" is "{data["subject"]}", expected "frame" or "loader"')
        self.metric = data["error_metric"]
        self.unit = data.get("time_unit", "ms")
        if self.unit not in ("ms", "MB/s"):
            raise StudyError(f'"time_unit" is "{self.unit}", expected "ms" or "MB/s"')
        self.higher_is_faster = self.unit == "MB/s"
        if not data["points"]:
            raise StudyError("has no points")
        for i, point in enumerate(data["points"]):
            if point.get("device", data["device"]) != data["device"]:
                raise StudyError(f'point {i} was measured on "{point["device"]}", the study on "{data["device"]}": '
                                 "times of two devices never share an axis, write two studies")
        try:
            self.points = [Point(p, self.metric, self.unit) for p in data["points"]]
        except (KeyError, TypeError, AttributeError) as error:
            raise StudyError(f"has a point without {error}; docs/study_format.md says what a point holds") from None
        if self.metric not in METRICS and self.metric not in self.metrics:
            raise StudyError(f'"error_metric" is "{self.metric}", expected one of '
                             f'{", ".join(dict.fromkeys([*METRICS, *self.metrics]))}')

    @property
    def software(self):
        """True where the frame was rasterised by the CPU. Its times are CPU times."""
        names = f'{self.data["device"]} {self.data["driver"]}'.lower()
        return self.data["subject"] == "frame" and any(name in names for name in SOFTWARE)

    def size_text(self, before):
        """", 960 × 540", after `before`; empty if the study does not say."""
        return f"{before}{self.data['size'][0]} × {self.data['size'][1]}" if "size" in self.data else ""

    # Cached, since a chart reads them thousands of times.
    @cached_property
    def scenes(self):
        return list(dict.fromkeys(p.scene for p in self.points))

    @cached_property
    def methods(self):
        return list(dict.fromkeys(p.method for p in self.points))

    @cached_property
    def colour_order(self):
        """The methods of all studies of the chapter that lie beside this one: a method has one colour in all of them."""
        return list(dict.fromkeys([*self.methods_beside, *self.methods]))

    @cached_property
    def metrics(self):
        """The points' errors, those of pictures first."""
        measured = dict.fromkeys(name for p in self.points for name in p.data["error"])
        own = [name for name in measured if name not in METRICS and name not in ("nan", "inf")]
        return [name for name in METRICS if name in measured] + own

    def metric_label(self, metric):
        return METRICS[metric][0] if metric in METRICS else self.data.get("metrics", {}).get(metric,
                                                                                             metric.replace("_", " "))

    def set_by(self, scene):
        return self.data.get("scenes", {}).get(scene, {}).get("set", {})

    @cached_property
    def scene_knobs(self):
        return list(dict.fromkeys(name for scene in self.scenes for name in self.set_by(scene)))

    @property
    def time_label(self):
        if self.unit == "MB/s":
            return "throughput, MB/s"
        return "CPU time (software rasteriser), ms" if self.software else "GPU time, ms"

    def one_step(self, scene, metric):
        """(error one 8-bit step makes, whether it was measured on this scene's truth), or (None, False)."""
        if metric not in METRICS:
            return None, False
        of_scene = self.data.get("scenes", {}).get(scene, {}).get("one_step")
        measured = (of_scene or self.data.get("one_step", {})).get(metric)
        return (measured, True) if measured else (METRICS[metric][1], False)

    def doubling_change(self, scene, metric):
        """How far doubling the truth's samples moves it in a scene; None where not stated."""
        of_scene = self.data.get("scenes", {}).get(scene, {}).get("doubling")
        if of_scene is not None:
            return of_scene.get(metric)
        return self.data.get("truth", {}).get("doubling_change") if metric == self.metric else None


def number(value):
    """A JSON number; null, which is how JSON writes NaN and infinity, is NaN."""
    return math.nan if value is None else float(value)


def methods_beside(path):
    """The methods of the studies of the same chapter in the same folder, in the order of the files' names; unreadable ones
    have none."""
    names = []
    for file in sorted(path.parent.glob(f"{path.name.split('.')[0]}.*json")):
        try:
            names += [point["method"] for point in json.loads(file.read_text(encoding="utf-8"))["points"]]
        except (OSError, ValueError, KeyError, TypeError):
            continue
    return list(dict.fromkeys(names))


def load(path):
    """Reads and checks a study file. Raises StudyError with the file's name in its one line."""
    path = pathlib.Path(path)
    try:
        return Study(json.loads(path.read_text(encoding="utf-8")), methods_beside(path))
    except OSError as error:
        raise StudyError(f"{path}: cannot be read: {error.strerror}") from None
    except (json.JSONDecodeError, UnicodeDecodeError) as error:
        raise StudyError(f"{path}: is not JSON: {error}") from None
    except StudyError as error:
        raise StudyError(f"{path}: {error}") from None


def figures(value, digits=3):
    """A number for a table: `digits` significant digits, NaN and infinity by name."""
    if math.isnan(value):
        return "NaN"
    if math.isfinite(value) and abs(value) >= 10**digits:
        return f"{round(value, digits - 1 - math.floor(math.log10(abs(value)))):.0f}"
    return "0" if value == 0 else f"{value:.{digits}g}"


def markdown_table(study):
    """The points as a Markdown table: scene, method, knobs, time and errors; with marks for the Pareto front."""
    loader = study.data["subject"] == "loader"
    # A loader's errors other than METRICS are not distances from the truth.
    keys = [study.metric] + [k for k in study.metrics if k != study.metric and (k in METRICS or not loader)]
    time = "MB/s" if loader and study.higher_is_faster else ("CPU ms" if study.software else
                                                           "ms" if loader else "GPU ms")
    rows = [["", "scene", "method", "knobs", f"{time} (median)", "quartiles"] + [study.metric_label(k) for k in keys]
            + ["NaN", "Inf"]]
    rows.append(["---"] * 4 + ["---:"] * (len(rows[0]) - 4))
    on_front = {id(p) for scene in study.scenes for p in verdict_of(study, scene).front}
    for p in study.points:
        spread = f"{figures(p.time[0])}–{figures(p.time[2])}"
        named = ", ".join(f"{name} {value}" for name, value in p.knobs.items())
        rows.append(["●" if id(p) in on_front else "", p.scene, p.method, named, figures(p.time[1]), spread]
                    + [figures(number(p.data["error"][k])) if k in p.data["error"] else "" for k in keys] + [str(p.nan), str(p.inf)])
    lines = ["| " + " | ".join(cell.replace("|", "\\|") for cell in row) + " |" for row in rows]
    d = study.data
    version = "".join(f"{words} {d[key]}" for key, words in (("measured", " with code"), ("errors_measured", ", errors with")) if key in d)
    note = f'● on the Pareto front; errors that are small enough are not ranked. {d["device"]}, {d["driver"]}; {d["stage"]}{study.size_text(", ")}. Made by `{d["command"]}`{version}.'
    return "\n".join(lines) + "\n\n" + note + "\n"
