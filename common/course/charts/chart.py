"""Draws a study as SVG and PNG, with a Markdown table beside them.

    python3 common/course charts.chart STUDY.json [--out FOLDER]

writes FOLDER/STUDY.svg, .png and .md (FOLDER: the study's own), and STUDY.NAME.svg and .png for every chart after the
first. Of a study in docs/studies only the table and the PNGs that a lesson shows go there, the others into build/charts. Without "charts" in the study it is one: time against error on log axes. One panel per scene, all with the same
axes, or one in all where the x axis is a knob that the scenes set; one curve per method; bars are quartiles. The files
depend on the study and on matplotlib alone: no date, no random ids, text as outlines. Exit codes: 0; 2 with one line
where the study cannot be used.
"""

import argparse
import io
import math
import sys
import textwrap
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

from PIL import Image  # noqa: E402

from charts.chart_panel import INK, QUIET, Limits, Panel  # noqa: E402
from charts.drawn import STUDIES, shown_by_lessons  # noqa: E402
from charts.said import said_by  # noqa: E402
from charts.study_charts import Chart, chart_paths, charts_of  # noqa: E402
from charts.study_file import StudyError, figures, load, markdown_table  # noqa: E402
from tree import BUILD, warn, write_atomically  # noqa: E402

WIDTH_IN = 10  # of every chart: shown at a page's 800 pixels, 11 points are 12 pixels high
LETTERS = 120  # of a command's line in its usual size
STYLE = {"font.family": "DejaVu Sans", "font.size": 11, "axes.edgecolor": "#9aa3ad", "axes.linewidth": 0.8,
         "axes.labelcolor": INK, "xtick.color": QUIET, "ytick.color": QUIET, "text.color": INK,
         "svg.hashsalt": "lightwalk", "svg.fonttype": "path", "axes.spines.top": False, "axes.spines.right": False}


def draw(chart: Chart) -> dict:
    """The chart's files by their suffix."""
    with plt.rc_context(STYLE):
        figure = build_figure(chart)
        files = {}
        for suffix, options in ((".svg", {"format": "svg", "metadata": {"Date": None, "Creator": None}}),
                                (".png", {"format": "png", "dpi": 150, "metadata": {"Software": None}})):
            data = io.BytesIO()
            figure.savefig(data, facecolor="white", **options)
            files[suffix] = data.getvalue() if suffix == ".svg" else with_palette(data)
        plt.close(figure)
    return files


def with_palette(png: io.BytesIO) -> bytes:
    """A third of the bytes, with colours that no eye tells apart from the original ones."""
    out = io.BytesIO()
    with Image.open(png) as picture:
        picture.convert("RGB").quantize(128, dither=Image.Dither.NONE).save(out, "PNG", optimize=True)
    return out.getvalue()


def place_of(file: Path, shown: set[str]) -> Path:
    """Where a drawn file goes: out of the tree, unless a lesson shows it."""
    return BUILD / "charts" / file.name if file.parent.resolve() == STUDIES and file.name not in shown else file


def build_figure(chart: Chart, made: list | None = None):
    """The figure; its panels, and the points of each, are added to `made`."""
    panels = chart.panels
    columns = chart.columns
    rows = math.ceil(len(panels) / columns)
    says = textwrap.wrap(said_by(chart), 112)
    d = chart.study.data
    measured = textwrap.wrap(f'{d["device"]} · {d["driver"]} · {d["stage"]}{chart.study.size_text(" · ")}', 132)
    notes = textwrap.wrap("  ".join(notes_of(chart)), 140)
    height = (max(3.4, 0.45 * len(chart.names)) if chart.y.kind == "method" else 4.3) * rows + 1.9 + 0.2 * (len(notes) + len(says) + len(measured))
    figure = plt.figure(figsize=(WIDTH_IN, height))
    top, bottom = 1 - (0.87 + 0.24 * len(says) + 0.18 * len(measured)) / height, (1.0 + 0.2 * len(notes)) / height
    left = max(0.14, 0.011 * max(len(name) for name in chart.names)) if chart.y.kind == "method" else 0.095
    grid = figure.add_gridspec(rows, columns, left=left, right=0.975, top=top, bottom=bottom,
                               wspace=0.06, hspace=0.2)
    limits = Limits(chart)
    for i, scenes in enumerate(panels):
        panel = Panel(figure, grid[i // columns, i % columns], chart, scenes, limits)
        points = [p for p in chart.drawable if p.scene in scenes]
        panel.draw(points, title=chart.panel_title(scenes), x_label=i + columns >= len(panels), y_label=i % columns == 0)
        if made is not None:
            made.append((panel, points))
    heading(figure, chart, height, says, measured)
    for i, line in enumerate(reversed(notes)):
        figure.text(0.022, (0.40 + 0.2 * i) / height, line, fontsize=9.5, color=QUIET, va="center")
    return figure


def heading(figure, chart: Chart, height: float, says: list[str], measured: list[str]):
    figure.text(0.022, 1 - 0.33 / height, chart.title, fontsize=15, weight="bold", va="center")
    for i, line in enumerate(says):
        figure.text(0.022, 1 - (0.64 + 0.24 * i) / height, line, fontsize=11.5, va="center")
    for i, line in enumerate(measured):
        figure.text(0.022, 1 - (0.66 + 0.24 * len(says) + 0.18 * i) / height, line, color=QUIET, va="center", fontsize=9.5)
    command = chart.study.data["command"]
    figure.text(0.022, 0.18 / height, command, fontsize=9 * min(1, LETTERS / len(command)), color=QUIET, family="DejaVu Sans Mono",
                va="center")


def notes_of(chart: Chart) -> list[str]:
    d, kinds = chart.study.data, (chart.x.kind, chart.y.kind)
    notes = ["Points: median, bars: quartiles."] if "time" in kinds else []
    if d.get("truth") and "error" in kinds:
        notes.append(truth_note(chart))
    if chart.front(chart.points):
        notes.append("Yellow: the Pareto front, which no other beats in both.")
    if any(chart.enough_of([p for p in chart.drawable if p.scene in scenes]) for scenes in chart.panels):
        notes.append(f"Ringed: enough, the fastest {below(chart)}.")
    if len(chart.point_knobs) == 1 and not any(chart.point_knobs[0] in chart.label_of(p) for p in chart.drawable):
        if not chart.apart:
            notes.append(f"Small numbers: {chart.point_knobs[0]}.")
        elif not chart.one_method:
            notes.append(f"Behind a method's name: {chart.point_knobs[0]}.")
    if (chart.x.kind, chart.y.kind) == ("error", "method"):
        notes.append("Beside each point: its error and the median of its times.")
    notes += [f"All with {name} {values[0]}, where it applies." for name, values in chart.kept.items() if len(values) == 1]
    others = [scene for scene in chart.study.scenes if scene not in chart.scenes]
    if {"scenes", "over"} <= set(chart.entry) and others:
        notes.append(f"The other {len(others)} scenes are in the table.")
    if chart.entry.get("over"):
        notes.append(f"0: as fast as {chart.entry['over']}, within its quartiles or 1%.")
    for why, methods in chart.missing().items():
        notes.append(f"Not drawn: {', '.join(methods)} ({why}).")
    return notes


def below(chart: Chart) -> str:
    if not chart.enough:
        also = " (the 99th percentile, too)" if "flip_mean" in (chart.x.name, chart.y.name) else ""
        return f"with an error below that of one 8-bit step{also}"
    return f"with at most {chart.enough_words}" if chart.enough["at"] else f"with {chart.enough_words}"


def truth_note(chart: Chart) -> str:
    truth = chart.study.data["truth"]
    knobs = ", ".join(f"{name} {value}" for name, value in truth.get("knobs", {}).items())
    knobs += f", mean of {truth['pictures']} pictures" if "pictures" in truth else ""
    named = f'Truth: {truth["method"]} ({knobs})' if truth["method"] and knobs else f'Truth: {truth["method"] or knobs}'
    change = truth.get("doubling_change")
    if truth.get("exact"):
        return f"{named}, by definition."
    return f"{named}, doubling it changes {figures(change)}." if change else f"{named}."


def main(words: list[str]) -> int:
    parser = argparse.ArgumentParser(description="Draws a study as SVG and PNG, with a table in Markdown.")
    parser.add_argument("study", type=Path)
    parser.add_argument("--out", type=Path, help="folder to write to; default: that of the study")
    arguments = parser.parse_args(words)
    try:
        study = load(arguments.study)
        beside = (arguments.out or arguments.study.parent) / arguments.study.stem
        shown = shown_by_lessons()
        drawn = [(path, draw(chart)) for path, chart in zip(chart_paths(study.data, beside), charts_of(study))]
        for path, files in drawn:
            for suffix, data in files.items():
                write_atomically(place_of(path.with_name(path.name + suffix), shown), data)
        write_atomically(beside.with_name(beside.name + ".md"), markdown_table(study))
    except (StudyError, OSError) as error:
        warn(f"chart: {error}")
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
