"""Draws a study: time against error on log axes, as SVG and PNG, with a Markdown table beside them.

    python3 common/course/chart.py STUDY.json [--out FOLDER]

writes FOLDER/STUDY.svg, .png and .md (FOLDER: the study's own). One panel per scene, all with the same axes; one curve
per method through its knob values; bars are quartiles. The files depend on the study and on matplotlib alone: no date,
no random ids, text as outlines. Exit codes: 0; 2 with one line where the study cannot be used.
"""

import argparse
import io
import math
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.gridspec import GridSpecFromSubplotSpec  # noqa: E402
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter  # noqa: E402

from chart_labels import Labels  # noqa: E402
from study_file import METRICS, Study, StudyError, figures, load, markdown_table  # noqa: E402
from tree import warn, write_atomically  # noqa: E402

# Okabe and Ito's colours, which colour-blind people can tell apart, darkened to be read as text on white.
COLOURS = ["#0072b2", "#c04a00", "#00805f", "#a8327f", "#5b4fc2", "#8a6a00", "#2b7a9e", "#9c2b2b"]
MARKERS = "osD^vPX*"
INK, QUIET, FRONT = "#1d2129", "#66707d", "#f0b429"
STYLE = {"font.family": "DejaVu Sans", "font.size": 11, "axes.edgecolor": "#9aa3ad", "axes.linewidth": 0.8,
         "axes.labelcolor": INK, "xtick.color": QUIET, "ytick.color": QUIET, "text.color": INK,
         "svg.hashsalt": "lightwalk", "svg.fonttype": "path", "axes.spines.top": False, "axes.spines.right": False}


def draw(study: Study, svg: Path, png: Path):
    """Writes both files whole. Raises StudyError where there is nothing to draw."""
    drawable = [p for p in study.points if p.drawable]
    if not drawable:
        raise StudyError("has no point with a finite error and time")
    with plt.rc_context(STYLE):
        figure = build_figure(study, drawable)
        for path, options in ((svg, {"format": "svg", "metadata": {"Date": None, "Creator": None}}),
                              (png, {"format": "png", "dpi": 150, "metadata": {"Software": None}})):
            data = io.BytesIO()
            figure.savefig(data, facecolor="white", **options)
            write_atomically(Path(path), data.getvalue())
        plt.close(figure)


def build_figure(study: Study, drawable: list):
    scenes = study.scenes
    columns = 1 if len(scenes) == 1 else 2
    rows = math.ceil(len(scenes) / columns)
    height = 6.75 if rows == 1 else 1.9 + 4.3 * rows
    figure = plt.figure(figsize=(12, height))
    top, bottom = 1 - 1.05 / height, 1.2 / height
    grid = figure.add_gridspec(rows, columns, left=0.085, right=0.975, top=top, bottom=bottom, wspace=0.12,
                               hspace=0.28)
    limits = Limits(study, drawable)
    for i, scene in enumerate(scenes):
        panel = Panel(figure, grid[i // columns, i % columns], study, limits)
        panel.draw(scene, [p for p in drawable if p.scene == scene], title=scene if len(scenes) > 1 else "",
                   x_label=i + columns >= len(scenes), y_label=i % columns == 0)
    heading(figure, study, height, drawable)
    return figure


def heading(figure, study: Study, height: float, drawable: list):
    """What it shows, where it was measured, and how to measure it again."""
    d = study.data
    figure.text(0.022, 1 - 0.33 / height, d["title"], fontsize=17, weight="bold", va="center")
    figure.text(0.022, 1 - 0.65 / height, f'{d["device"]} · {d["driver"]} · {d["stage"]}', color=QUIET, va="center")
    notes = ["Points: median, bars: quartiles."]
    if d.get("truth"):
        knobs = ", ".join(f"{name} {value}" for name, value in d["truth"].get("knobs", {}).items())
        notes.append(f'Truth: {d["truth"]["method"]}{" (" + knobs + ")" if knobs else ""}'
                     + (f", doubling it changes {figures(study.doubling_change)}." if study.doubling_change else "."))
    if len(study.varied_knobs) == 1:
        notes.append(f"Small numbers: {study.varied_knobs[0]}.")
    missing = [p for p in study.points if not p.drawable]
    if missing:
        notes.append(f"Not drawn: {', '.join(dict.fromkeys(p.method for p in missing))} (error is not finite).")
    figure.text(0.022, 0.40 / height, "  ".join(notes), fontsize=9.5, color=QUIET, va="center")
    figure.text(0.022, 0.18 / height, d["command"], fontsize=9, color=QUIET, family="DejaVu Sans Mono", va="center")


class Limits:
    """The axes that all panels share."""

    def __init__(self, study: Study, drawable: list):
        times = [t for p in drawable for t in p.time if math.isfinite(t) and t > 0]
        errors = [p.error for p in drawable if p.error > 0]
        self.has_zero = any(p.error == 0 for p in drawable)
        self.x = widened(min(times), max(times), 0.10, 0.22)
        shown = list(errors)
        for line in (study.one_step[0], study.doubling_change):
            # Lines further away than a decade would squeeze the points.
            if line and errors and min(errors) / 10 <= line <= max(errors) * 10:
                shown.append(line)
        self.y = widened(min(shown), max(shown), 0.10, 0.14) if shown else None


def widened(low: float, high: float, below: float, above: float) -> tuple[float, float]:
    """A log range with a share of its decades added on either side, and at least a decade wide."""
    decades = max(math.log10(high / low), 0.6)
    centre_gap = (decades - math.log10(high / low)) / 2
    return low / 10 ** (below * decades + centre_gap), high * 10 ** (above * decades + centre_gap)


class Panel:
    """One scene: a log-log axis and, where a method is exact, a strip for error 0 below it."""

    def __init__(self, figure, place, study: Study, limits: Limits):
        self.study, self.limits = study, limits
        self.main = self.zero = None
        if limits.y and limits.has_zero:
            strips = GridSpecFromSubplotSpec(2, 1, subplot_spec=place, height_ratios=[8, 1], hspace=0.06)
            self.main, self.zero = figure.add_subplot(strips[0]), figure.add_subplot(strips[1])
        elif limits.y:
            self.main = figure.add_subplot(place)
        else:
            self.zero = figure.add_subplot(place)
        self.axes = [axis for axis in (self.main, self.zero) if axis]

    def draw(self, scene: str, points: list, title: str, x_label: bool, y_label: bool):
        self.prepare(x_label, y_label)
        if title:
            self.axes[0].set_title(title, loc="left", fontsize=12, weight="bold")
        self.draw_front(scene)
        curves = []
        for i, method in enumerate(self.study.methods):
            curve = [p for p in points if p.method == method]
            if curve:
                colour = COLOURS[i % len(COLOURS)]
                self.draw_curve(curve, colour, MARKERS[i % len(MARKERS)])
                curves.append((method, curve, colour))
        self.label(curves, self.draw_lines())

    def prepare(self, x_label: bool, y_label: bool):
        for axis in self.axes:
            axis.set_xscale("log")
            axis.set_xlim(self.limits.x)
            axis.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
            axis.xaxis.set_minor_formatter(NullFormatter())
            if math.log10(self.limits.x[1] / self.limits.x[0]) < 2.5:
                axis.xaxis.set_major_locator(LogLocator(10, subs=(1, 2, 5)))
            axis.grid(True, which="major", color="#e7eaee", linewidth=0.8)
            axis.set_axisbelow(True)
        if x_label:
            self.axes[-1].set_xlabel(self.study.time_label)
        if self.main:
            self.main.set_yscale("log")
            self.main.set_ylim(self.limits.y)
            if math.log10(self.limits.y[1] / self.limits.y[0]) < 2:
                self.main.yaxis.set_major_locator(LogLocator(10, subs=(1, 2, 5)))
            self.main.yaxis.set_minor_formatter(NullFormatter())
            self.main.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
        if self.zero:
            self.zero.set_ylim(-1, 1)
            self.zero.set_yticks([0], ["0"])
            self.zero.set_facecolor("#f4f6f8")
            self.zero.grid(False, axis="y")
        if self.main and self.zero:
            self.main.tick_params(labelbottom=False, bottom=False, which="both")
            self.main.spines["bottom"].set_visible(False)
        if y_label:
            self.axes[0].set_ylabel(f"error: {METRICS[self.study.metric][0]}")

    def axis_of(self, point):
        return self.zero if point.error == 0 else self.main

    def anchor(self, point):
        """What chart_labels needs to stay clear of a point and its bar."""
        bar = [t if math.isfinite(t) else point.time[1] for t in (point.time[0], point.time[2])]
        return self.axis_of(point), point.time[1], point.error, bar

    def draw_front(self, scene: str):
        """A soft band along the points that nothing beats, and a ring around each."""
        front = self.study.front(scene)
        for axis in self.axes:
            on_axis = [p for p in front if self.axis_of(p) is axis]
            axis.plot([p.time[1] for p in on_axis], [p.error for p in on_axis], color=FRONT, alpha=0.35, linewidth=9,
                      solid_capstyle="round", solid_joinstyle="round", zorder=1.5)
            axis.scatter([p.time[1] for p in on_axis], [p.error for p in on_axis], s=150, facecolor="none",
                         edgecolor=FRONT, linewidth=2.2, zorder=4)

    def draw_curve(self, curve: list, colour: str, marker: str):
        for axis in self.axes:
            part = [p for p in curve if self.axis_of(p) is axis]
            if not part:
                continue
            x, y = [p.time[1] for p in part], [p.error for p in part]
            axis.plot(x, y, color=colour, linewidth=1.8, zorder=2)
            bars = [[max(p.time[1] - p.time[0], 0) for p in part], [max(p.time[2] - p.time[1], 0) for p in part]]
            axis.errorbar(x, y, xerr=bars, fmt=marker, markersize=6.5, color=colour, ecolor=colour, elinewidth=1.2,
                          capsize=3, markeredgecolor="white", markeredgewidth=0.8, zorder=3)

    def draw_lines(self) -> list:
        """The error that one 8-bit step makes, and the truth's own uncertainty. Returns what is written there."""
        if not self.main:
            return []
        notes = []
        low, high = self.limits.y
        step, measured = self.study.one_step
        if step and low < step < high:
            self.main.axhline(step, color=QUIET, linewidth=1, dashes=(5, 3), zorder=1)
            where = "" if measured else " at mid grey"
            notes.append(self.main.annotate(f"one 8-bit step{where}", (1, step), xycoords=("axes fraction", "data"),
                                            xytext=(0, 3), textcoords="offset points", ha="right", fontsize=9.5,
                                            color=QUIET))
        doubling = self.study.doubling_change
        if doubling and low < doubling < high:
            self.main.axhspan(low, doubling, facecolor="#eef0f3", zorder=0)
            notes.append(self.main.annotate("below: less than the truth is sure of", (1, doubling),
                                            xycoords=("axes fraction", "data"), xytext=(-3, -12),
                                            textcoords="offset points", ha="right", fontsize=9, color=QUIET))
        return notes

    def label(self, curves: list, notes: list):
        """Methods at an end of their curve, knob values at the points where there is room, the front's name."""
        labels = Labels(self.axes[0].figure)
        labels.avoid_texts(notes)
        for _, curve, _ in curves:
            labels.avoid_curve([self.anchor(p) for p in curve])
        for method, curve, colour in curves:
            ends = [curve[-1], curve[0]]
            labels.place(method, [self.anchor(p) for p in ends], colour, size=11.5,
                         weight="bold", must=True)
        front = self.study.front(curves[0][1][0].scene) if curves else []
        if len(front) > 1:
            ends = [front[0], front[-1]]
            labels.place("Pareto front", [self.anchor(p) for p in ends], "#9a6b00", size=9.5, weight="normal",
                         must=False)
        for _, curve, colour in curves:
            if len(curve) > 1:
                for p in curve:
                    labels.place(self.study.knob_label(p), [self.anchor(p)], colour, size=8.5, weight="normal", must=False)


def main(words: list[str]) -> int:
    parser = argparse.ArgumentParser(description="Draws a study as SVG and PNG, with a table in Markdown.")
    parser.add_argument("study", type=Path)
    parser.add_argument("--out", type=Path, help="the folder to write to; default: the study's")
    arguments = parser.parse_args(words)
    try:
        study = load(arguments.study)
        beside = (arguments.out or arguments.study.parent) / arguments.study.stem
        draw(study, beside.with_name(beside.name + ".svg"), beside.with_name(beside.name + ".png"))
        write_atomically(beside.with_name(beside.name + ".md"), markdown_table(study))
    except (StudyError, OSError) as error:
        warn(f"chart: {error}")
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
