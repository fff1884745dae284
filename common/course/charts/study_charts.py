"""Contents of each chart of a study: axes, panels and curves. Nothing here draws.

docs/study_format.md has the keys of "charts". A study without them has one chart, its time against its error_metric.
"""
import copy
from functools import cached_property

from charts.chart_axes import Axis, Rows
from charts.study_file import StudyError, figures
from charts.verdict import verdict_of

KEYS = ("name", "title", "says", "x", "y", "scenes", "methods", "knobs", "x_scale", "x_label", "y_label", "panel", "enough",
        "over", "passes")


class Chart:
    """One chart. `points` are its subject, `drawable` the ones with a position on both axes."""

    def __init__(self, study, entry):
        self.study, self.entry = study, entry
        try:
            self.read(entry)
        except StudyError as error:
            raise StudyError(f'chart "{entry["name"]}": {error}' if "name" in entry else str(error)) from None
        self.drawable = [p for p in self.points if self.x.can_show(p) and self.y.can_show(p)]

    def read(self, entry):
        study = self.study
        for key in entry:
            if key not in KEYS:
                raise StudyError(f'has "{key}", which is unknown here; known: {", ".join(KEYS)}')
        for key, known in (("scenes", study.scenes), ("methods", study.methods)):
            for name in entry.get(key, []):
                if name not in known:
                    raise StudyError(f'has "{name}" among its {key}; there are {", ".join(known)}')
        if entry.get("x_scale", "log") not in ("log", "linear"):
            raise StudyError(f'"x_scale" is "{entry["x_scale"]}", expected "log" or "linear"')
        self.title = entry.get("title", study.data["title"])
        # Over a knob that scenes set: only scenes that set it.
        knob = str(entry.get("x", "")).partition("knob ")[2]
        default = [scene for scene in study.scenes if knob in study.set_by(scene)] or study.scenes
        self.scenes = [scene for scene in study.scenes if scene in entry.get("scenes", default)]
        self.methods = [method for method in study.methods if method in entry.get("methods", study.methods)]
        self.points = [p for p in study.points if p.scene in self.scenes and p.method in self.methods]
        for name in self.kept:
            self.keep(name)
        self.points = self.timed(self.points)
        if str(entry.get("y", "")).startswith("knob "):
            raise StudyError(f'"y" is "{entry["y"]}", expected "time" or a metric')
        self.enough = entry.get("enough")
        self.x = Axis(study, entry.get("x", "time"), self.points, entry.get("x_scale"), entry.get("x_label"), self.added)
        self.y = Rows(self) if entry.get("y") == "method" else \
            Axis(study, entry.get("y", study.metric), self.points, words=entry.get("y_label"), added=self.added)
        if self.y.kind == "method" and self.x.kind == "knob":
            raise StudyError(f'"y" is "method", which needs "x": "time" or a metric, not "{self.x.text}"')
        if self.enough is not None and (not isinstance(self.enough, dict) or set(self.enough) != {"at", "text"}):
            raise StudyError(f'"enough" is {self.enough}, expected {{"at": NUMBER, "text": WORDS}}')

    @property
    def added(self):
        """The time axis's note about times other than the whole frame's; else empty."""
        if "over" in self.entry:
            return f'beyond {self.entry["over"]}'
        return f'of {", ".join(self.entry["passes"])}' if "passes" in self.entry else ""

    def timed(self, points):
        """The points with the method's added time instead of the whole frame's: beyond that of another method in the same
        scene ("over"), or of the passes with names starting with one of "passes"."""
        if not self.added:
            return points
        if self.study.unit != "ms" or {"over", "passes"} <= set(self.entry):
            raise StudyError('"over" or "passes", one of them, stands for milliseconds')
        names = {name for p in points for name in p.data["time_ms"].get("per_pass", {})}
        for start in self.entry.get("passes", []):
            if not any(name.startswith(start) for name in names):
                raise StudyError(f'no pass begins with "{start}"; there are: {", ".join(sorted(names))}')
        changed = [copy.copy(p) for p in points]
        for p in changed:
            if "passes" in self.entry:
                passes = p.data["time_ms"].get("per_pass", {})
                total = sum(ms for name, ms in passes.items() if name.startswith(tuple(self.entry["passes"])))
                p.time = (total,) * 3
            else:
                others = [o.time[1] for o in self.study.points if (o.scene, o.method) == (p.scene, self.entry["over"])]
                if not others:
                    raise StudyError(f'"over" is "{self.entry["over"]}", which was not measured in scene "{p.scene}"')
                p.time = tuple(time - min(others) for time in p.time)
                if p.time[0] <= 0 or p.time[1] < 0.01 * min(others):  # not known to take longer, or nothing to speak of
                    p.time = 0.0, 0.0, 0.0
        return changed

    @property
    def kept(self):
        """{knob: the values of it that the chart shows}"""
        return {name: values if isinstance(values, list) else [values]
                for name, values in self.entry.get("knobs", {}).items()}

    def keep(self, name):
        """Removes points that set the knob to another value; points that do not set it stay."""
        for value in self.kept[name]:
            if not any(p.knobs.get(name) == value for p in self.points):
                raise StudyError(f'no point sets the knob "{name}" to {value}')
        self.points = [p for p in self.points if name not in p.knobs or p.knobs[name] in self.kept[name]]

    @cached_property
    def over_scenes(self):
        """True where x is a knob that the scenes set: all of them are in one panel."""
        return self.x.kind == "knob" and self.x.name in self.study.scene_knobs

    @property
    def panels(self):
        """The scenes of each panel."""
        return [self.scenes] if self.over_scenes else [[scene] for scene in self.scenes]

    @cached_property
    def point_knobs(self):
        """The knobs that distinguish points of one panel, without the one on the x axis."""
        panels = [[p.knobs for p in self.points if p.scene in scenes] for scenes in self.panels]
        names = dict.fromkeys(name for p in self.points for name in p.knobs)
        names = [name for name in names
                 if any(len({str(knobs[name]) for knobs in panel if name in knobs}) > 1 for panel in panels)]
        return [name for name in names if (self.x.kind, self.x.name) != ("knob", name)]

    def label_of(self, point):
        """The values that tell a point from its neighbours: "16", or "taps 16, radius 2.5" where two knobs vary, or
        "volumes on". Over a knob all points of a curve have the same. What a scene sets for all of a method tells nothing."""
        curve = [p.knobs for p in self.points if (p.scene, p.method) == (point.scene, point.method)]
        values = {name: value for name, value in point.knobs.items()
                  if name in self.point_knobs and (name not in self.study.scene_knobs or any(knobs.get(name) != value for knobs in curve))}
        short = {name: f"{value:g}" if isinstance(value, float) else str(value) for name, value in values.items()}
        return ", ".join(value if len(self.point_knobs) == 1 and value not in ("on", "off") else f"{name} {value}"
                         for name, value in short.items())

    def name_of(self, point):
        """Name of a point's curve or row: its method, unless all share one and knobs distinguish them, and the values of
        knobs with a curve for each value."""
        label = self.label_of(point) if self.apart else ""
        return ", ".join(word for word in ("" if label and self.one_method else point.method, label) if word)

    @cached_property
    def one_method(self):
        """True if only knob values differ, and all points have these knobs."""
        return len({p.method for p in self.points}) == 1 and all(self.label_of(p) for p in self.points)

    @cached_property
    def names(self):
        ordered = sorted(self.points, key=lambda p: self.methods.index(p.method))
        return list(dict.fromkeys(self.name_of(p) for p in ordered))

    @property
    def apart(self):
        """True where points of a method that differ in other knobs are curves, or rows, of their own."""
        return self.x.kind == "knob" or self.y.kind == "method"

    def colour_number(self, point):
        """A method has one colour in all studies of a chapter; where there is one, its curves differ."""
        if self.apart and self.one_method:
            return self.names.index(self.name_of(point))
        return self.study.colour_order.index(point.method)

    def curves(self, points):
        """(method, its points in order). Over a knob a method has one for each value of its other knobs, from left to
        right."""
        found = {}
        for p in points:
            found.setdefault((p.method, self.label_of(p) if self.apart else ""), []).append(p)
        return [(method, sorted(curve, key=self.x.value) if self.x.kind == "knob" else curve)
                for (method, _), curve in sorted(found.items(), key=lambda item: self.methods.index(item[0][0]))]

    def front(self, points):
        """The points that no other beats in time and error, fastest first; none where the axes are not these two."""
        if {self.x.kind, self.y.kind} != {"time", "error"} or not points:
            return []
        return self.verdict(points).front

    def verdict(self, points):
        """The verdict on one panel's points, by the error on an axis, the upright one of two, and the chart's limit or one 8-bit step."""
        error = next((axis.name for axis in (self.y, self.x) if axis.kind == "error"), self.study.metric)
        at = self.enough["at"] if self.enough else None
        return verdict_of(self.study, points[0].scene, [p for p in points if p in self.drawable], error, at)

    @property
    def columns(self):
        """How many panels stand side by side: with three, words are too small on a page."""
        return min(len(self.panels), 2)

    def panel_title(self, scenes):
        """A panel's title: "panel" with the scene's name inserted, else the name alone."""
        if len(self.panels) == 1:
            return ""
        knobs = next(p.knobs for p in self.points if p.scene == scenes[0])
        return self.entry.get("panel", "{scene}").format(scene=scenes[0], **knobs)

    def row_text(self, point):
        """A row's text for its point: time and error, the axis's own quantity first."""
        if self.x.kind == "error":
            return f"{figures(self.x.value(point))}\n{figures(point.time[1])} {self.study.unit}"
        unit = "ULP" if self.study.metric == "ulp" else self.study.metric_label(self.study.metric)
        error = "no error" if point.error == 0 else f"off by {figures(point.error)} {unit}"
        return f"{figures(point.time[1])} {self.study.unit}\n{error}"

    @property
    def enough_words(self):
        return self.enough["text"] if self.enough else ""

    def enough_of(self, points):
        """The cheapest point that is enough. None where none is, or it is not known what is, or no axis is the time."""
        if {self.x.kind, self.y.kind} not in ({"time", "method"}, {"time", "error"}) or not points:
            return None
        verdict = self.verdict(points)
        return verdict.cheapest if self.enough or all(verdict.limits.values()) else None

    def missing(self):
        """{why: methods} of points that have no place in the chart."""
        why = {}
        for p in self.points:
            if p in self.drawable:
                continue
            lacking = [axis.name for axis in (self.x, self.y) if not axis.has(p)]
            why.setdefault(f"no {lacking[0]}" if lacking else "error is not finite", {})[p.method] = True
        return {reason: list(methods) for reason, methods in why.items()}


def charts_of(study):
    """The study's charts in order. Raises StudyError where one cannot be drawn."""
    entries = study.data.get("charts") or [{}]
    names = [entry.get("name") for entry in entries]
    if "charts" in study.data and (None in names or len(set(names)) < len(names)):
        raise StudyError("each chart needs a \"name\" of its own")
    charts = [Chart(study, entry) for entry in entries]
    for chart in charts:
        if not chart.drawable:
            named = f'chart "{chart.entry["name"]}" ' if "name" in chart.entry else ""
            raise StudyError(f"{named}has no point with a finite error and time")
    return charts


def chart_paths(data, beside):
    """Where each chart of a study's JSON goes, without its suffix: FILE for the first, FILE.NAME for the others."""
    entries = data.get("charts") or [{}]
    return [beside] + [beside.with_name(f"{beside.name}.{entry['name']}") for entry in entries[1:]]
