"""A chart's statement, a sentence above it: the study's own ("says"), or one derived from its points."""
from collections import Counter

from charts.study_file import METRICS


def said_by(chart) -> str:
    """Empty where nothing short is true of all panels."""
    if "says" in chart.entry:
        return chart.entry["says"]
    if (chart.x.kind, chart.y.kind) == ("time", "method"):
        return rows_said(chart)
    if chart.x.kind == "knob":
        return knob_said(chart)
    return front_said(chart)


def front_said(chart) -> str:
    """Which method, or which row, is enough; and which has the smallest error where none is: below a limit none is ranked. Of two
    errors the level one stands for the time."""
    two_errors = (chart.x.kind, chart.y.kind) == ("error", "error")
    work = chart.x.value if two_errors else lambda p: p.time[1]

    def enough_of(points):
        verdict = chart.verdict(points)
        known = two_errors and all(verdict.limits.values())
        return min(verdict.enough, key=work, default=None) if known else chart.enough_of(points)

    panels = [[p for p in chart.drawable if p.scene in scenes] for scenes in chart.panels]
    panels = [points for points in panels if points]
    fastest = [enough_of(points) for points in panels]
    best = [min(points, key=lambda p: (chart.verdict(points).error(p), work(p))) for points in panels]
    chosen = [a or b for a, b in zip(fastest, best)]
    several = {chart.name_of(p) for p in chosen if any(chart.name_of(p) == chart.name_of(q) and p.knobs != q.knobs for q in chosen)}

    def name(point):
        """The method, with its knobs where panels differ in them."""
        label = chart.label_of(point) if chart.name_of(point) in several else ""
        return f"{point.method} {label}" if label else chart.name_of(point)

    words = []
    if any(fastest):
        least = f"at the least {chart.x.label().partition('  (')[0]}" if two_errors else "in the least time"
        words.append(f"Enough {least}: {counted([name(p) for p in fastest if p], len(chart.panels))}.")
    if not all(fastest):
        where = "Smallest error where none is enough" if any(fastest) else "Smallest error"
        words.append(f"{where}: {counted([name(b) for a, b in zip(fastest, best) if not a], len(chart.panels))}.")
    return " ".join(words)


def counted(methods: list[str], panels: int) -> str:
    """The two most frequent, "a (in 3 of 4 panels), b (in 1 of 4 panels)"; the name alone where there is one for all."""
    count = Counter(methods)
    if panels == 1 or list(count.values()) == [panels]:
        return ", ".join(count)
    return ", ".join(f"{name} (in {times} of {panels} panels)" for name, times in count.most_common(2))


def knob_said(chart) -> str:
    """By how much the curves grow or fall from the left end to the right one: the least and the most of all panels."""
    changes = []
    for scenes in chart.panels:
        for _, curve in chart.curves([p for p in chart.drawable if p.scene in scenes]):
            ends = curve[0], curve[-1]
            if len(curve) > 1 and not any(chart.y.is_zero(p) for p in ends):
                name = chart.name_of(curve[0])
                changes.append((chart.y.value(ends[1]) / chart.y.value(ends[0]),
                                name if len(chart.panels) == 1 else f"{name}, {chart.panel_title(scenes)}"))
    if not changes:
        return ""
    what = "time" if chart.y.kind == "time" else "error" if chart.y.name in METRICS else "value"
    ends = [chart.x.value(p) for p in chart.drawable]
    knob, comma, unit = chart.x.label().partition(":")[0].partition(", ")
    return f"From {knob} {min(ends):,g} to {max(ends):,g}{comma[1:]}{unit} the {what} {between(min(changes), max(changes))}."


def between(least: tuple[float, str], most: tuple[float, str]) -> str:
    """Effects on a value, by factors, from the smallest to the largest, each with its owner."""
    if (kind(least[0]), amount(least[0])) == (kind(most[0]), amount(most[0])):
        return f"{kind(least[0])}{amount(least[0])}"
    if kind(least[0]) == kind(most[0]):
        return f"{kind(least[0])}{amount(least[0])} ({least[1]}) to {amount(most[0]).strip()} ({most[1]})"
    return f"{kind(least[0])}{amount(least[0])} ({least[1]}) or {kind(most[0])}{amount(most[0])} ({most[1]})"


def kind(factor: float) -> str:
    return "falls to" if factor < 0.95 else "grows by a factor of" if factor > 1.05 else "hardly changes"


def amount(factor: float) -> str:
    """Two digits: a share where the value falls, the factor where it grows."""
    if kind(factor) == "hardly changes":
        return ""
    return f" {float(f'{100 * factor:.2g}'):,g}%" if factor < 1 else f" {float(f'{factor:.2g}'):,g}"


def rows_said(chart) -> str:
    """The fastest row, and the fastest of those with the smallest error."""
    sign = -1 if chart.study.higher_is_faster else 1
    fastest = min(chart.drawable, key=lambda p: sign * p.time[1])
    exact = min(chart.drawable, key=lambda p: (p.error, sign * p.time[1]))
    if chart.name_of(fastest) == chart.name_of(exact):
        return f"{chart.name_of(fastest)} is the fastest, and none has a smaller error."
    return f"{chart.name_of(fastest)} is the fastest; {chart.name_of(exact)} is the fastest of those with the smallest error."
