"""The ranges of a chart's axes, and the lines that they have to hold. Nothing here draws."""
import math


class Limits:
    """The axes that all panels share: (low, high), or None where every value is 0 and stands in a strip."""

    def __init__(self, chart):
        drawable = chart.drawable
        self.zero_x = any(chart.x.is_zero(p) for p in drawable)
        self.zero_y = any(chart.y.is_zero(p) for p in drawable)
        rows = chart.y.kind == "method"
        upright = [line for scenes in chart.panels for line in lines_of(chart, scenes, chart.x)[:1] if line] if rows else []
        self.x = limits_of(chart.x, drawable, upright, *room_beside(chart))
        lines = [line for scenes in chart.panels for line in lines_of(chart, scenes, chart.y)[:2]]
        self.y = limits_of(chart.y, drawable, [line for line in lines if line], 0.10, 0.30 if chart.x.kind == "time" else 0.12)
        if rows:
            self.y = len(chart.names) - (0.2 if upright else 0.4), -0.6  # the first above; room for a line's words below


def room_beside(chart):
    """Space for labels left and right of the curves, as shares of their span: over a knob all labels are on the right."""
    if chart.y.kind == "method":
        longest = max(len(line) for p in chart.drawable for line in chart.row_text(p).split("\n"))
        label = min((14 + 5.4 * longest) / (600 / chart.columns), 0.6)
        return 0.08, label / (1 - label)
    if chart.x.kind != "knob":
        return 0.26, 0.22
    longest = max(len(chart.name_of(p)) for p in chart.drawable)
    label = (24 + 7.6 * longest) / (600 / chart.columns)
    return 0.05, label / (1 - min(label, 0.6))


def limits_of(axis, points, lines, below, above):
    """The range of all values, their quartiles, and of those lines that are less than a decade away: others would
    squeeze the points. `below` and `above`: the room for labels at the ends, as a share of the whole."""
    values = [value for p in points for value in axis.spread(p)
              if math.isfinite(value) and (value > 0 or not axis.log) and not axis.is_zero(p)]
    if not values:
        return None
    if not axis.log:
        low, high = min(values), max(values)
        room = (high - low) or abs(high) or 1
        return low - 0.6 * below * room, high + above * room
    low, high = min(values), max(values)
    shown = values + [line for line in lines if low / 10 <= line <= high * 10]
    return widened(min(shown), max(shown), below, above)


def widened(low: float, high: float, below: float, above: float) -> tuple[float, float]:
    """A log range with a share of its decades added on either side, and at least a decade wide."""
    decades = max(math.log10(high / low), 0.6)
    centre_gap = (decades - math.log10(high / low)) / 2
    return low / 10 ** (below * decades + centre_gap), high * 10 ** (above * decades + centre_gap)


def lines_of(chart, scenes, axis):
    """(error of one 8-bit step, truth's uncertainty, whether the step was measured) of a panel with an error axis: over
    several scenes the smallest step and the largest uncertainty. None if there is none."""
    if axis.kind != "error":
        return None, None, False
    steps = [(chart.enough["at"], True) if chart.enough else chart.study.one_step(scene, axis.name)
             for scene in scenes]
    step, measured = min(steps, key=lambda pair: pair[0] or math.inf)
    doubts = [chart.study.doubling_change(scene, axis.name) or 0 for scene in scenes]
    return step, max(doubts) or None, measured
