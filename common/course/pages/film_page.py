"""Charts of chapter 19's film: each scene's cost on each system, on a page; and the savings if each scene is drawn by the cheapest
sufficient way.

    ./course run 19 --page PAGE.html A.json B.json        benchmarks (chapter 19's --benchmark)
    python3 common/course pages.film_page WAYS.json OUT  OUT.svg and OUT.png of chapter 19's --ways; OUT.budgets.json

The scenes' ways are judged by their mean FLIP against the first one with many samples a pixel, at three times of the scene.
"""

import io
import json
import sys
from math import fsum
from pathlib import Path
from types import SimpleNamespace

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

from charts.chart import STYLE  # noqa: E402
from charts.verdict import Verdict  # noqa: E402
from pages.film_figures import cells_of  # noqa: E402
from pages.page import page as filled  # noqa: E402
from tree import write_atomically  # noqa: E402

BUDGETS = (0.01, 0.02, 0.03, 0.05, 0.07, 0.1, 0.15, 0.2, 0.3)
SHOWN = 0.1  # the budget of the bars
BEST, ENOUGH, SET = "#b9c2cc", "#2f78b7", "#e08a2e"


def page(systems: list[dict]) -> str:
    rows = [{"name": scene["name"], "cells": [cell for one in systems for cell in cells_of(one, scene["name"])]}
            for scene in systems[0]["scenes"]]
    charts = [{"title": title, "svg": bars(of)} for title, of in
              (("Graphics processors", [one for one in systems if not one["software"]]),
               ("Software renderers", [one for one in systems if one["software"]])) if of]
    return filled("film.html", systems=systems, rows=rows, charts=charts)


def bars(systems: list[dict]) -> str:
    """Mean of each scene on each system, with a line to the 99th percentile, as the text of an SVG."""
    names = [scene["name"] for scene in systems[0]["scenes"]]
    with plt.rc_context(STYLE):
        figure, axes = plt.subplots(figsize=(10, 0.6 + 0.22 * len(names) * (1 + len(systems))))
        for i, one in enumerate(systems):
            on = {scene["name"]: scene["gpu_sum"]["mlaa"] for scene in one["scenes"]}
            places = [k + (i - (len(systems) - 1) / 2) * 0.8 / len(systems) for k, name in enumerate(names) if name in on]
            means = [on[name]["mean_ms"] for name in names if name in on]
            axes.barh(places, means, 0.7 / len(systems), label=f"{one['device']}, {one['size'][0]}×{one['size'][1]}")
            axes.hlines(places, means, [on[name]["p99_ms"] for name in names if name in on], color="#333", linewidth=1)
        axes.set_yticks(range(len(names)), names)
        axes.invert_yaxis()
        axes.set_xlabel("milliseconds of a frame; thin line: to the 99th percentile")
        axes.legend(frameon=False)
        text = io.StringIO()
        figure.savefig(text, format="svg", bbox_inches="tight", metadata={"Date": None, "Creator": None})
        plt.close(figure)
    svg = text.getvalue()
    return svg[svg.index("<svg"):]


def cheapest(scene: dict, budget: float) -> dict:
    """As chapters/19_ambiance/ways.cpp chooses."""
    points = [SimpleNamespace(way=way, time=(way["gpu_ms"],) * 3) for way in scene["ways"]]
    return Verdict(points, {"error": budget}, error_of=lambda point, metric: point.way[metric]).choice.way


def within_budgets(measured: dict) -> dict:
    """Of each budget, the scenes with a way within it, and the film's time as a share of that of the most accurate ways."""
    scenes = measured["scenes"]
    whole = fsum(scene["ways"][0]["gpu_ms"] for scene in scenes)
    points = []
    for budget in BUDGETS:
        ways = [cheapest(scene, budget) for scene in scenes]
        points.append({"method": f"{budget:g}", "within": sum(way["error"] <= budget for way in ways),
                       "share": fsum(way["gpu_ms"] for way in ways) / whole})
    return {"device": measured["device"], "driver": measured["driver"], "size": measured["size"], "points": points}


def ways_chart(measured: dict, command: str):
    """Frame time of each scene by its best way, as the film stands and by the cheapest that is enough; the whole film over budgets."""
    scenes, size = measured["scenes"], "×".join(map(str, measured["size"]))
    with plt.rc_context(STYLE):
        figure, (left, right) = plt.subplots(1, 2, figsize=(10, 5.2), width_ratios=(3, 2))
        for k, scene in enumerate(scenes):
            best, way = scene["ways"][0]["gpu_ms"], cheapest(scene, SHOWN)
            enough, is_enough = way["gpu_ms"], way["error"] <= SHOWN
            left.barh(k, best, 0.72, color=BEST, label="most accurate way" if k == 0 else None)
            left.barh(k, enough, 0.36, color=ENOUGH if is_enough else "white", edgecolor=ENOUGH,
                      label=f"cheapest way within {SHOWN:g}" if k == 0 else None)
            left.plot([scene["as_set_ms"]] * 2, [k - 0.36, k + 0.36], color=SET, linewidth=2,
                      label="the film as it is" if k == 0 else None)
            left.text(max(best, enough, scene["as_set_ms"]), k,
                      f"  {enough / best:.0%}" if is_enough else f"  none: the truest errs {way['error']:.2f}",
                      va="center", fontsize=9.5)
        left.set_yticks(range(len(scenes)), [scene["name"] for scene in scenes])
        left.invert_yaxis()
        left.set_xlabel("milliseconds of a frame")
        left.margins(x=0.12)
        left.legend(frameon=False, fontsize=9, loc="lower left", bbox_to_anchor=(0, 1), ncols=3)
        means = [sum(cheapest(scene, budget)["gpu_ms"] for scene in scenes) / len(scenes) for budget in BUDGETS]
        right.plot(BUDGETS, means, "o-", color=ENOUGH)
        for budget, mean in zip(BUDGETS, means):
            count = sum(cheapest(scene, budget)["error"] <= budget for scene in scenes)
            right.annotate(f"{count}", (budget, mean), (0, -15), textcoords="offset points", fontsize=9, ha="center",
                           color=ENOUGH)
        for value, color, words in ((sum(scene["ways"][0]["gpu_ms"] for scene in scenes), BEST, "most accurate"),
                                    (sum(scene["as_set_ms"] for scene in scenes), SET, "as it is")):
            right.axhline(value / len(scenes), color=color, linewidth=2)
            right.text(BUDGETS[0], value / len(scenes), words, va="bottom", fontsize=9.5)
        right.set_xscale("log")
        right.set_ylim(0)
        right.set_xlabel(f"budget: greatest mean FLIP of a scene\n(in blue: scenes of {len(scenes)} that keep within it)", fontsize=10)
        right.set_ylabel("mean of all scenes, ms a frame")
        figure.suptitle("No more than a scene needs", x=0.022, ha="left", fontsize=15, weight="bold")
        figure.text(0.022, 0.9, f"{measured['device']} · {measured['driver']} · {size}"
                    + (" · times of the processor" if measured["software"] else ""), fontsize=9.5)
        figure.text(0.022, 0.015, command, fontsize=9, family="DejaVu Sans Mono")
        figure.tight_layout(rect=(0, 0.035, 1, 0.9))
    return figure


def main(words: list[str]) -> int:
    file, out = Path(words[0]), Path(words[1])
    measured = json.loads(file.read_text(encoding="utf-8"))
    figure = ways_chart(measured, f"build/chapters/19_ambiance --ways {file.name} --size {'x'.join(map(str, measured['size']))}")
    figure.savefig(out.with_suffix(".svg"), metadata={"Date": None, "Creator": None})
    figure.savefig(out.with_suffix(".png"), dpi=150, metadata={"Software": None})
    write_atomically(out.with_suffix(".budgets.json"), json.dumps(within_budgets(measured), indent=1, ensure_ascii=False) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
