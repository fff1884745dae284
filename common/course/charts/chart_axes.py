"""The axes of a chart: positions and labels. Nothing here draws."""
import math

from charts.study_file import METRICS, StudyError, number

LOG_FROM = 10  # a knob's axis is logarithmic where its largest value is at least that many times the smallest above 0


class Axis:
    """Quantity of one axis: "time", a metric (`kind` "error") or "knob NAME"."""

    def __init__(self, study, text, points, scale=None, words=None, added=""):
        self.study, self.text, self.words, self.added = study, text, words, added
        self.kind = "time" if text == "time" else "knob" if text.startswith("knob ") else "error"
        self.name = text.removeprefix("knob ")
        if self.kind == "knob":
            self.check_knob(points)
        elif self.kind == "error" and not any(text in p.data["error"] for p in points):
            raise StudyError(f'no point has the error "{text}"; there are {", ".join(study.metrics)}')
        self.log = scale == "log" if scale else self.kind != "knob" or self.spans_decades(points)

    def check_knob(self, points):
        values = [p.knobs[self.name] for p in points if self.name in p.knobs]
        if not values:
            raise StudyError(f'no point sets the knob "{self.name}"')
        for value in values:
            if isinstance(value, (bool, str)):
                raise StudyError(f'the knob "{self.name}" has the value "{value}", which no axis can show')

    def spans_decades(self, points):
        values = [p.knobs[self.name] for p in points if self.name in p.knobs]
        above = [value for value in values if value > 0]
        return bool(above) and min(values) >= 0 and max(above) >= LOG_FROM * min(above)

    def has(self, point):
        """False where the point has no such thing at all."""
        return {"time": True, "knob": self.name in point.knobs, "error": self.name in point.data["error"]}[self.kind]

    def spread(self, point):
        """(lower quartile, value, upper quartile); all the same where there is one value, NaN where there is none."""
        if self.kind == "time":
            return point.time
        value = number((point.knobs if self.kind == "knob" else point.data["error"]).get(self.name))
        return value, value, value

    def value(self, point):
        return self.spread(point)[1]

    def can_show(self, point):
        value = self.value(point)
        return math.isfinite(value) and (value > 0 or not self.log or (value == 0 and (self.kind != "time" or bool(self.added))))

    def is_zero(self, point):
        """True for values in a strip beside a log axis: 0, and errors below a tenth of the truth's uncertainty, which are
        indistinguishable from 0."""
        if not self.log or self.kind == "time" and not self.added:
            return False
        doubt = self.study.doubling_change(point.scene, self.name) or 0 if self.kind == "error" else 0
        return self.value(point) == 0 or self.kind == "error" and self.value(point) < doubt / 10

    @property
    def zero_text(self):
        return "≈ 0" if any(self.is_zero(p) and self.value(p) for p in self.study.points if self.has(p)) else "0"

    def label(self, upright=False):
        better = ("↓", "↑") if upright else ("←", "→")
        if self.words:
            return self.words
        if self.kind == "time":
            words = f'{"CPU" if self.study.software else "GPU"} time {self.added}, ms' if self.added else self.study.time_label
            return f"{words}  ({better[self.study.higher_is_faster]} faster)"
        if self.kind == "knob":
            return self.name.replace("_", " ")
        words = f"error: {METRICS[self.name][0]}" if self.name in METRICS else self.study.metric_label(self.name)
        return f"{words}  ({better[0]} less is better)"


class Rows:
    """The upright axis of a chart that has a row for each of its curves instead of an error."""

    kind, name, log, zero_text = "method", "method", False, "0"

    def __init__(self, chart):
        self.chart = chart

    def has(self, _):
        return True

    def value(self, point):
        return self.chart.names.index(self.chart.name_of(point))

    def spread(self, point):
        return (self.value(point),) * 3

    def can_show(self, _):
        return True

    def is_zero(self, _):
        return False

    def label(self, upright=False):
        return ""
