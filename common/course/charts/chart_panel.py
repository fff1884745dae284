"""One panel of a chart: the ranges of its axes, a strip for 0, curves, and their labels."""
import math

from matplotlib.gridspec import GridSpecFromSubplotSpec
from matplotlib.patches import Rectangle
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from charts.chart_labels import Labels

# Okabe and Ito's colours, which colour-blind people can tell apart, darkened to be read as text on white.
COLOURS = ["#0072b2", "#c04a00", "#00805f", "#a8327f", "#5b4fc2", "#8a6a00", "#2b7a9e", "#9c2b2b", "#4a4f57", "#5c7a00"]
MARKERS = "osD^vPX*ph"
INK, QUIET, FRONT = "#1d2129", "#66707d", "#f0b429"


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


class Panel:
    """A pair of axes for points on both, and strips for values of 0 on a log axis."""

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
        self.step = None  # where a dashed line is drawn

    def draw(self, points: list, title: str, x_label: bool, y_label: bool):
        self.prepare(x_label, y_label)
        if title:
            self.cells[self.columns[0], self.rows[0]].set_title(title, loc="left", y=1, fontsize=12, weight="bold")
        front = self.chart.front(points)
        self.draw_front(front)
        curves = []
        for method, curve in self.chart.curves(points):
            i = self.chart.colour_number(curve[0])
            colour = COLOURS[i % len(COLOURS)]
            self.draw_curve(curve, colour, MARKERS[i % len(MARKERS)])
            curves.append((method, curve, colour))
        enough = self.chart.enough_of(points)
        if enough:
            self.axis_of(enough).scatter(*[[value] for value in self.at(enough)], s=210, facecolor="none",
                                         edgecolor=INK, linewidth=2, zorder=4.2)
        notes = self.draw_lines(points)
        if self.chart.y.kind == "method":
            self.draw_row_line()
            self.label_rows(points)
        elif self.chart.x.kind == "knob":
            Labels(list(self.cells.values())).column(
                [(self.chart.name_of(curve[0]), self.anchor(curve[-1]), colour) for _, curve, colour in curves])
        else:
            self.label(curves, front, notes, enough)

    def prepare(self, x_label: bool, y_label: bool):
        for (zero_x, zero_y), axis in self.cells.items():
            axis.set_title("", y=1)  # to place titles by itself, matplotlib makes all ticks once more
            axis.grid(True, which="major", color="#e7eaee", linewidth=0.8)
            axis.set_axisbelow(True)
            if zero_x or zero_y:  # behind all of the panel, into which labels of its neighbours reach
                axis.patch.set_visible(False)
                axis.figure.add_artist(Rectangle((0, 0), 1, 1, transform=axis.transAxes, facecolor="#f4f6f8", zorder=-1))
            axis.set_zorder(1 if zero_x else 0)
            prepare_direction(axis, "x", None if zero_x else self.limits.x, self.chart.x, 2.5)
            prepare_direction(axis, "y", None if zero_y else self.limits.y, self.chart.y, 2)
            if self.chart.y.kind == "method":
                self.name_rows(axis, y_label)
            if zero_y != self.last_row:
                axis.tick_params(labelbottom=False, bottom=False, which="both")
                axis.spines["bottom"].set_visible(False)
            if zero_x != self.first_column or not y_label:  # panels share their axes
                axis.tick_params(labelleft=False, left=zero_x == self.first_column, which="both")
            if zero_x != self.first_column:
                axis.spines["left"].set_visible(False)
        if x_label:
            self.cells[self.columns[-1], self.last_row].set_xlabel(self.chart.x.label())
        if y_label:
            self.cells[self.first_column, self.rows[0]].set_ylabel(self.chart.y.label(upright=True))

    def axis_of(self, point):
        return self.cells[self.chart.x.is_zero(point), self.chart.y.is_zero(point)]

    def at(self, point):
        """Where a point lies; in a strip, in its middle."""
        x, y = self.chart.x, self.chart.y
        return 0 if x.is_zero(point) else x.value(point), 0 if y.is_zero(point) else y.value(point)

    def anchor(self, point):
        """Obstacles for chart_labels around a point: the point and its bars."""
        ends = []
        for axis in (self.chart.x, self.chart.y):
            low, value, high = (0, 0, 0) if axis.is_zero(point) else axis.spread(point)
            ends.append([end if math.isfinite(end) else value for end in (low, high)])
        return self.axis_of(point), *self.at(point), *ends

    def draw_front(self, front: list):
        """A line through the points that nothing beats, and a ring around each."""
        if set((self.chart.x.kind, self.chart.y.kind)) != {"time", "error"}:
            return
        for axis in self.cells.values():
            at = [self.at(p) for p in front if self.axis_of(p) is axis]
            x, y = [x for x, _ in at], [y for _, y in at]
            axis.plot(x, y, color=FRONT, linewidth=3.5, solid_capstyle="round", solid_joinstyle="round", zorder=1.5)
            axis.scatter(x, y, s=95, facecolor="none", edgecolor=FRONT, linewidth=1.6, zorder=4)

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
        """The error of one 8-bit step, and the truth's own uncertainty. Returns their labels."""
        if not self.main:
            return []
        notes = []
        low, high = self.limits.y
        step, doubling, measured = lines_of(self.chart, self.scenes, self.chart.y)
        right = 0 if self.chart.x.kind == "knob" else 1  # where curves are named at the right
        if step and low < step < high:
            self.main.axhline(step, color=QUIET, linewidth=1, dashes=(5, 3), zorder=1)
            self.step = step
            words = "one 8-bit step" if measured else "one 8-bit step at mid grey"
            words = self.chart.enough_words or words
            notes.append(self.note(words, ((right, step, 0, 3), (1 - right, step, 0, 3)), 9.5, points))
        if doubling and low < doubling < high:
            self.main.axhspan(low, doubling, facecolor="#eef0f3", zorder=0)
            places = ((1, doubling, -3, -12), (0, doubling, 3, -12), (1, low, -3, 4), (0, low, 3, 4), (1, doubling, -3, 3),
                      (0, doubling, 3, 3))
            if self.pixels(doubling) - self.pixels(low) < 20:  # too thin for the words: they stand on it
                places = places[4:]
            places = places if right else places[1::2]
            notes.append(self.note("below: less than the truth is sure of", places, 9, points, notes))
        return notes

    def pixels(self, error: float) -> float:
        """The height at which an error lies in the figure."""
        return self.main.transData.transform((self.main.get_xlim()[0], error))[1]

    def note(self, text: str, places: tuple, size: float, points: list, others: list = ()):
        """Words about a line, at the first of those places (share of the width, value, and from there in points) where
        they cover none of the other words, the fewest points and the least of the curves."""
        renderer = self.main.figure.canvas.get_renderer()
        at, between = self.pixels_of(points)
        best = None
        for side, height, *offset in places:
            note = self.main.annotate(text, (side, height), xycoords=("axes fraction", "data"), xytext=offset,
                                      textcoords="offset points", ha="right" if side else "left", fontsize=size,
                                      color=QUIET, gid="label")
            box = note.get_window_extent(renderer)
            covered = (sum(box.overlaps(other.get_window_extent(renderer)) for other in others),
                       sum(box.padded(11).contains(*pixel) for pixel in at),
                       sum(box.contains(*pixel) for pixel in between))
            if best is None or covered < best[0]:
                if best:
                    best[1].remove()
                best = covered, note
            else:
                note.remove()
        return best[1]

    def pixels_of(self, points: list) -> tuple[list, list]:
        at, between = [], []
        for _, curve in self.chart.curves(points):
            pixels = [self.main.transData.transform(self.at(p)) for p in curve if self.axis_of(p) is self.main]
            at += pixels
            between += [one + (two - one) * k / 50 for one, two in zip(pixels, pixels[1:]) for k in range(1, 50)]
        return at, between

    def label(self, curves: list, front: list, notes: list, enough):
        """Methods at an end of their curve, knob values at points with space, and the sufficient method."""
        labels = Labels(list(self.cells.values()))
        labels.avoid_texts(notes)
        if self.step:
            labels.avoid_line(self.main, self.step)
        for _, curve, _ in curves:
            labels.avoid_curve([self.anchor(p) for p in curve])
        labels.avoid_front([self.anchor(p) for p in front])
        for method, curve, colour in curves:
            anchors = [self.anchor(p) for p in dict.fromkeys((curve[-1], curve[0], curve[len(curve) // 2]))]
            alone = curve == [enough]
            labels.want(f"{method}: enough" if alone else method, anchors, colour, size=10, weight="bold", must=True)
            if enough in curve and not alone:
                labels.want(f"enough: {method} {self.chart.label_of(enough)}", [self.anchor(enough)], INK, size=9,
                            weight="bold", must=True)
        for _, curve, colour in curves:
            for p in dict.fromkeys((curve[0], curve[-1], *curve)) if len(curve) > 1 else ():
                labels.want(self.chart.label_of(p), [self.anchor(p)], colour, size=8, weight="normal", must=False)
        labels.write()

    def name_rows(self, axis, named: bool):
        names = self.chart.names
        axis.set_yticks(range(len(names)), names if named else [""] * len(names))
        axis.tick_params(axis="y", length=0)
        axis.grid(False, axis="y")
        numbers = {self.chart.name_of(p): self.chart.colour_number(p) for p in self.chart.points}
        for name, tick in zip(names, axis.get_yticklabels()):
            tick.set(color=COLOURS[numbers[name] % len(COLOURS)], fontsize=11.5, weight="bold")

    def draw_row_line(self):
        step, _, measured = lines_of(self.chart, self.scenes, self.chart.x)
        if self.main and step and self.limits.x[0] < step < self.limits.x[1]:
            self.main.axvline(step, color=QUIET, linewidth=1, dashes=(5, 3), zorder=1)
            words = self.chart.enough_words or ("one 8-bit step" if measured else "one 8-bit step at mid grey")
            self.main.annotate(words, (step, 0), xycoords=("data", "axes fraction"), xytext=(4, 4), fontsize=9.5, color=QUIET,
                               textcoords="offset points", gid="label")

    def label_rows(self, points: list):
        for p in points:
            right = self.chart.x.spread(p)[2]
            self.axis_of(p).annotate(self.chart.row_text(p), (right, self.chart.y.value(p)), xytext=(11, 0),
                                     textcoords="offset points", va="center", fontsize=9.5, color=INK, gid="label",
                                     bbox={"facecolor": "white", "edgecolor": "none", "pad": 1})


def prepare_direction(axis, direction: str, limits, shown, few_decades: float):
    """Scale, ends and ticks of one direction; without limits it is a strip's, on which only 0 lies."""
    ticks = axis.xaxis if direction == "x" else axis.yaxis
    set_limits, set_scale = getattr(axis, f"set_{direction}lim"), getattr(axis, f"set_{direction}scale")
    if limits is None:
        set_limits(-1, 1)
        getattr(axis, f"set_{direction}ticks")([0], [shown.zero_text])
        axis.grid(False, axis=direction)
        return
    if shown.log:
        set_scale("log")
    set_limits(limits)
    ticks.set_major_formatter(FuncFormatter(lambda value, _: tick_text(value)))
    ticks.set_minor_formatter(NullFormatter())
    if shown.log and math.log10(limits[1] / limits[0]) < few_decades:
        ticks.set_major_locator(LogLocator(10, subs=(1, 2, 5)))


def tick_text(value: float) -> str:
    """0.001, and 10⁻⁵ where there would be more zeros."""
    if 0 < abs(value) < 0.99e-3 or abs(value) > 1.01e5:
        exponent = math.floor(math.log10(abs(value)) + 1e-9)
        power = "10" + str(exponent).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
        factor = f"{value / 10 ** exponent:g}"
        return power if factor == "1" else f"{factor}·{power}"
    return f"{value:,.0f}" if abs(value) >= 1000 else f"{value:g}"
