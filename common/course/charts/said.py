"""What a chart says, in a sentence that stands over it: the study's own ("says"), or one that follows from its points."""
from collections import Counter

from charts.study_file import METRICS, figures


def said_by(chart) -> str:
    """Empty where nothing short is true of all panels."""
    if "says" in chart.entry:
        return chart.entry["says"]
    if chart.y.kind == "method":
        return rows_said(chart)
    if chart.x.kind == "knob":
        return knob_said(chart)
    return front_said(chart)


def front_said(chart) -> str:
    """Which method has the least error, and which is enough."""
    panels = [[p for p in chart.drawable if p.scene in scenes] for scenes in chart.panels]
    error = chart.y if chart.y.kind == "error" else chart.x
    words = []
    enough = [found.method for points in panels if (found := chart.enough_of(points))]
    if enough:
        words.append(f"Enough in the least time: {counted(enough, len(panels))}.")
    best = [min(points, key=lambda p: (error.value(p), p.time[1])).method for points in panels if points]
    words.append(f"Least error: {counted(best, len(panels))}.")
    return " ".join(words)


def counted(methods: list[str], panels: int) -> str:
    """The two most frequent, "a (in 3 of 4 panels), b (in 1 of 4 panels)"; the name alone where there is one for all."""
    count = Counter(methods)
    if panels == 1 or list(count.values()) == [panels]:
        return ", ".join(count)
    return ", ".join(f"{name} (in {times} of {panels} panels)" for name, times in count.most_common(2))


def knob_said(chart) -> str:
    """By how much each curve grows or falls from the left end to the right one; of many, the least and the most. Over
    several panels these are the least and the largest change of all their curves."""
    changes = []
    for scenes in chart.panels:
        for method, curve in chart.curves([p for p in chart.drawable if p.scene in scenes]):
            ends = curve[0], curve[-1]
            if len(curve) > 1 and not any(chart.y.is_zero(p) for p in ends):
                name = chart.curve_name(method, curve)
                changes.append((chart.y.value(ends[1]) / chart.y.value(ends[0]),
                                name if len(chart.panels) == 1 else f"{name}, {chart.panel_title(scenes)}"))
    if not changes:
        return ""
    what = "times" if chart.y.kind == "time" else "errors" if chart.y.name in METRICS else "values"
    ends = [chart.x.value(p) for p in chart.drawable]
    shown = [min(changes), max(changes)] if len(changes) > 1 else changes
    return (f"From {chart.x.label()} {figures(min(ends))} to {figures(max(ends))} the {what} become "
            + ", ".join(f"{figures(change)} times as large ({name})" for change, name in shown) + ".")


def rows_said(chart) -> str:
    """The fastest row, and the fastest of those with the least error."""
    sign = -1 if chart.study.higher_is_faster else 1
    fastest = min(chart.drawable, key=lambda p: sign * p.time[1])
    exact = min(chart.drawable, key=lambda p: (p.error, sign * p.time[1]))
    if fastest is exact:
        return f"{fastest.method} is the fastest, and none has a smaller error."
    return f"{fastest.method} is the fastest; {exact.method} is the fastest of those with the least error."
