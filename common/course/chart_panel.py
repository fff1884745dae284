"""One panel of a chart: its axes, with a strip for what is 0, its curves, and what stands at them."""
import math

from matplotlib.gridspec import GridSpecFromSubplotSpec
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from chart_labels import Labels

# Okabe and Ito's colours, which colour-blind people can tell apart, darkened to be read as text on white.
COLOURS = ["#0072b2", "#c04a00", "#00805f", "#a8327f", "#5b4fc2", "#8a6a00", "#2b7a9e", "#9c2b2b"]
MARKERS = "osD^vPX*"
INK, QUIET, FRONT = "#1d2129", "#66707d", "#f0b429"


class Limits:
    """The axes that all panels share: (low, high), or None where every value is 0 and stands in a strip."""

    def __init__(self, chart):
        drawable = chart.drawable
        self.zero_x = any(chart.x.is_zero(p) for p in drawable)
        self.zero_y = any(chart.y.is_zero(p) for p in drawable)
        self.x = limits_of(chart.x, drawable, [], 0.22, 0.22)
        lines = [line for scenes in chart.panels for line in lines_of(chart, scenes)[:2]]
        self.y = limits_of(chart.y, drawable, [line for line in lines if line], 0.10, 0.18)


def limits_of(axis, points, lines, below, above):
    """The range of all values, their quartiles, and of those lines that are less than a decade away: others would
    squeeze the points. `below` and `above`: the room for labels at the ends, as a share of the whole."""
    values = [value for p in points for value in axis.spread(p) if math.isfinite(value) and (value > 0 or not axis.log)]
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


def lines_of(chart, scenes):
    """(what one 8-bit step makes, below what the truth is not sure, whether the step was measured) of a panel whose
    upright axis is an error: over several scenes the least step and the largest doubt. None where there is none."""
    if chart.y.kind != "error":
        return None, None, False
    steps = [chart.study.one_step(scene, chart.y.name) for scene in scenes]
    step, measured = min(steps, key=lambda pair: pair[0] or math.inf)
    doubts = [chart.study.doubling_change(scene, chart.y.name) or 0 for scene in scenes]
    return step, max(doubts) or None, measured


class Panel:
    """A pair of axes for the points that lie on both, and strips for those that are 0 on a log axis."""

    def __init__(self, figure, place, chart, scenes: list, limits: Limits):
        self.chart, self.scenes, self.limits = chart, scenes, limits
        columns = [True] * limits.zero_x + [False] * bool(limits.x)  # True: the strip
        rows = [False] * bool(limits.y) + [True] * limits.zero_y
        if len(columns) * len(rows) == 1:
            places = [place]
        else:
            sizes = {"height_ratios": [1 if zero else 8 for zero in rows], "hspace": 0.06}
            if len(columns) > 1:
                sizes |= {"width_ratios": [1 if zero else 11 for zero in columns], "wspace": 0.03}
            grid = GridSpecFromSubplotSpec(len(rows), len(columns), subplot_spec=place, **sizes)
            places = [grid[i] for i in range(len(rows) * len(columns))]
        cells = [(zero_x, zero_y) for zero_y in rows for zero_x in columns]
        self.cells = {cell: figure.add_subplot(at) for cell, at in zip(cells, places)}
        self.first_column, self.last_row, self.columns, self.rows = columns[0], rows[-1], columns, rows
        self.main = self.cells.get((False, False))

    def draw(self, points: list, title: str, x_label: bool, y_label: bool):
        self.prepare(x_label, y_label)
        if title:
            self.cells[self.columns[0], self.rows[0]].set_title(title, loc="left", fontsize=12, weight="bold")
        front = self.chart.front(points)
        self.draw_front(front)
        curves = []
        for method, curve in self.chart.curves(points):
            i = self.chart.study.methods.index(method)
            self.draw_curve(curve, COLOURS[i % len(COLOURS)], MARKERS[i % len(MARKERS)])
            curves.append((method, curve, COLOURS[i % len(COLOURS)]))
        self.label(curves, front, self.draw_lines(points))

    def prepare(self, x_label: bool, y_label: bool):
        for (zero_x, zero_y), axis in self.cells.items():
            axis.grid(True, which="major", color="#e7eaee", linewidth=0.8)
            axis.set_axisbelow(True)
            if zero_x or zero_y:
                axis.set_facecolor("#f4f6f8")
            prepare_direction(axis, "x", None if zero_x else self.limits.x, self.chart.x.log, 2.5)
            prepare_direction(axis, "y", None if zero_y else self.limits.y, self.chart.y.log, 2)
            if zero_y != self.last_row:
                axis.tick_params(labelbottom=False, bottom=False, which="both")
                axis.spines["bottom"].set_visible(False)
            if zero_x != self.first_column:
                axis.tick_params(labelleft=False, left=False, which="both")
                axis.spines["left"].set_visible(False)
        if x_label:
            self.cells[self.columns[-1], self.last_row].set_xlabel(self.chart.x.label())
        if y_label:
            self.cells[self.first_column, self.rows[0]].set_ylabel(self.chart.y.label(upright=True))

    def axis_of(self, point):
        return self.cells[self.chart.x.is_zero(point), self.chart.y.is_zero(point)]

    def at(self, point):
        return self.chart.x.value(point), self.chart.y.value(point)

    def anchor(self, point):
        """What chart_labels needs to stay clear of a point and its bars."""
        ends = []
        for axis in (self.chart.x, self.chart.y):
            low, value, high = axis.spread(point)
            ends.append([end if math.isfinite(end) else value for end in (low, high)])
        return self.axis_of(point), *self.at(point), *ends

    def draw_front(self, front: list):
        """A soft band along the points that nothing beats, and a ring around each."""
        if set((self.chart.x.kind, self.chart.y.kind)) != {"time", "error"}:
            return
        for axis in self.cells.values():
            at = [self.at(p) for p in front if self.axis_of(p) is axis]
            x, y = [x for x, _ in at], [y for _, y in at]
            axis.plot(x, y, color=FRONT, alpha=0.35, linewidth=9, solid_capstyle="round", solid_joinstyle="round",
                      zorder=1.5)
            axis.scatter(x, y, s=150, facecolor="none", edgecolor=FRONT, linewidth=2.2, zorder=4)

    def draw_curve(self, curve: list, colour: str, marker: str):
        for axis in self.cells.values():
            part = [p for p in curve if self.axis_of(p) is axis]
            if not part:
                continue
            x, y = [self.at(p)[0] for p in part], [self.at(p)[1] for p in part]
            axis.plot(x, y, color=colour, linewidth=1.8, zorder=2)
            bars = {}
            for key, shown in (("xerr", self.chart.x), ("yerr", self.chart.y)):
                if shown.kind == "time":
                    spreads = [shown.spread(p) for p in part]
                    bars[key] = [[max(s[1] - s[0], 0) for s in spreads], [max(s[2] - s[1], 0) for s in spreads]]
            axis.errorbar(x, y, **bars, fmt=marker, markersize=6.5, color=colour, ecolor=colour, elinewidth=1.2,
                          capsize=3, markeredgecolor="white", markeredgewidth=0.8, zorder=3)

    def draw_lines(self, points: list) -> list:
        """The error that one 8-bit step makes, and the truth's own uncertainty. Returns what is written there."""
        if not self.main:
            return []
        notes = []
        low, high = self.limits.y
        step, doubling, measured = lines_of(self.chart, self.scenes)
        if step and low < step < high:
            self.main.axhline(step, color=QUIET, linewidth=1, dashes=(5, 3), zorder=1)
            where = "" if measured else " at mid grey"
            notes.append(self.note(f"one 8-bit step{where}", ((1, step, 0, 3), (0, step, 0, 3)), 9.5, points))
        if doubling and low < doubling < high:
            self.main.axhspan(low, doubling, facecolor="#eef0f3", zorder=0)
            places = ((1, doubling, -3, -12), (0, doubling, 3, -12), (1, low, -3, 4), (0, low, 3, 4))
            notes.append(self.note("below: less than the truth is sure of", places, 9, points))
        return notes

    def note(self, text: str, places: tuple, size: float, points: list):
        """Words about a line, at the first of the places (share of the width, value, and from there in points) where
        they cover no point; where there is none, at the first."""
        renderer = self.main.figure.canvas.get_renderer()
        at = [self.main.transData.transform(self.at(p)) for p in points if self.axis_of(p) is self.main]
        for i, (side, height, *offset) in enumerate((*places, places[0])):
            note = self.main.annotate(text, (side, height), xycoords=("axes fraction", "data"), xytext=offset,
                                      textcoords="offset points", ha="right" if side else "left", fontsize=size,
                                      color=QUIET)
            box = note.get_window_extent(renderer).padded(5)
            if i == len(places) or not any(box.contains(*pixel) for pixel in at):
                return note
            note.remove()

    def label(self, curves: list, front: list, notes: list):
        """Methods at an end of their curve, knob values at the points where there is room, the front's name. Over a
        knob the other knobs' values stand at the ends of the curves."""
        labels = Labels(list(self.cells.values()))
        labels.avoid_texts(notes)
        for _, curve, _ in curves:
            labels.avoid_curve([self.anchor(p) for p in curve])
        for method, colour in dict.fromkeys((method, colour) for method, _, colour in curves):
            ends = [end for name, curve, _ in curves if name == method for end in (curve[-1], curve[0])]
            labels.place(method, [self.anchor(p) for p in ends], colour, size=11.5,
                         weight="bold", must=True)
        if len(front) > 1:
            ends = [front[0], front[-1]]
            labels.place("Pareto front", [self.anchor(p) for p in ends], "#9a6b00", size=9.5, weight="normal",
                         must=False)
        for _, curve, colour in curves:
            if self.chart.x.kind == "knob":
                labels.place(self.chart.label_of(curve[0]), [self.anchor(p) for p in (curve[-1], curve[0])], colour,
                             size=8.5, weight="normal", must=False)
            elif len(curve) > 1:
                for p in curve:
                    labels.place(self.chart.label_of(p), [self.anchor(p)], colour, size=8.5, weight="normal",
                                 must=False)


def prepare_direction(axis, direction: str, limits, log: bool, few_decades: float):
    """Scale, ends and ticks of one direction; without limits it is a strip's, on which only 0 lies."""
    ticks = axis.xaxis if direction == "x" else axis.yaxis
    set_limits, set_scale = getattr(axis, f"set_{direction}lim"), getattr(axis, f"set_{direction}scale")
    if limits is None:
        set_limits(-1, 1)
        getattr(axis, f"set_{direction}ticks")([0], ["0"])
        axis.grid(False, axis=direction)
        return
    if log:
        set_scale("log")
    set_limits(limits)
    ticks.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    ticks.set_minor_formatter(NullFormatter())
    if log and math.log10(limits[1] / limits[0]) < few_decades:
        ticks.set_major_locator(LogLocator(10, subs=(1, 2, 5)))
