"""Draws a study as SVG and PNG, with a Markdown table beside them.

    python3 common/course/chart.py STUDY.json [--out FOLDER]

writes FOLDER/STUDY.svg, .png and .md (FOLDER: the study's own), and STUDY.NAME.svg and .png for every chart after the
first. Without "charts" in the study it is one: time against error on log axes. One panel per scene, all with the same
axes, or one in all where the x axis is a knob that the scenes set; one curve per method; bars are quartiles. The files
depend on the study and on matplotlib alone: no date, no random ids, text as outlines. Exit codes: 0; 2 with one line
where the study cannot be used.
"""

import argparse
import io
import math
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

from chart_panel import INK, QUIET, Limits, Panel  # noqa: E402
from study_charts import Chart, chart_paths, charts_of  # noqa: E402
from study_file import StudyError, figures, load, markdown_table  # noqa: E402
from tree import warn, write_atomically  # noqa: E402

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
            files[suffix] = data.getvalue()
        plt.close(figure)
    return files


def build_figure(chart: Chart):
    panels = chart.panels
    columns = 1 if len(panels) == 1 else 2
    rows = math.ceil(len(panels) / columns)
    height = 6.75 if rows == 1 else 1.9 + 4.3 * rows
    figure = plt.figure(figsize=(12, height))
    top, bottom = 1 - 1.05 / height, 1.2 / height
    grid = figure.add_gridspec(rows, columns, left=0.085, right=0.975, top=top, bottom=bottom, wspace=0.12,
                               hspace=0.28)
    limits = Limits(chart)
    for i, scenes in enumerate(panels):
        panel = Panel(figure, grid[i // columns, i % columns], chart, scenes, limits)
        panel.draw([p for p in chart.drawable if p.scene in scenes], title=scenes[0] if len(panels) > 1 else "",
                   x_label=i + columns >= len(panels), y_label=i % columns == 0)
    heading(figure, chart, height)
    return figure


def heading(figure, chart: Chart, height: float):
    """What it shows, where it was measured, and how to measure it again."""
    study, d, kinds = chart.study, chart.study.data, (chart.x.kind, chart.y.kind)
    figure.text(0.022, 1 - 0.33 / height, chart.title, fontsize=17, weight="bold", va="center")
    figure.text(0.022, 1 - 0.65 / height, f'{d["device"]} · {d["driver"]} · {d["stage"]}{study.size_text(" · ")}',
                color=QUIET, va="center")
    notes = ["Points: median, bars: quartiles."] if "time" in kinds else []
    if d.get("truth") and "error" in kinds:
        notes.append(truth_note(chart))
    if len(chart.point_knobs) == 1:
        notes.append(f"Small numbers: {chart.point_knobs[0]}.")
    notes += [f"All with {name} {values[0]}, where it applies." for name, values in chart.kept.items() if len(values) == 1]
    for why, methods in chart.missing().items():
        notes.append(f"Not drawn: {', '.join(methods)} ({why}).")
    figure.text(0.022, 0.40 / height, "  ".join(notes), fontsize=9.5, color=QUIET, va="center")
    figure.text(0.022, 0.18 / height, d["command"], fontsize=9, color=QUIET, family="DejaVu Sans Mono", va="center")


def truth_note(chart: Chart) -> str:
    """What the errors are measured against, and how sure that is."""
    truth = chart.study.data["truth"]
    knobs = ", ".join(f"{name} {value}" for name, value in truth.get("knobs", {}).items())
    named = f'Truth: {truth["method"]}{" (" + knobs + ")" if knobs else ""}'
    change = truth.get("doubling_change")
    if truth.get("exact"):
        return f"{named}, by definition."
    return f"{named}, doubling it changes {figures(change)}." if change else f"{named}."


def main(words: list[str]) -> int:
    parser = argparse.ArgumentParser(description="Draws a study as SVG and PNG, with a table in Markdown.")
    parser.add_argument("study", type=Path)
    parser.add_argument("--out", type=Path, help="the folder to write to; default: the study's")
    arguments = parser.parse_args(words)
    try:
        study = load(arguments.study)
        beside = (arguments.out or arguments.study.parent) / arguments.study.stem
        drawn = [(path, draw(chart)) for path, chart in zip(chart_paths(study.data, beside), charts_of(study))]
        for path, files in drawn:
            for suffix, data in files.items():
                write_atomically(path.with_name(path.name + suffix), data)
        write_atomically(beside.with_name(beside.name + ".md"), markdown_table(study))
    except (StudyError, OSError) as error:
        warn(f"chart: {error}")
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
