"""Where the points of a study's charts lie, for a pointer over them: python3 common/course live.chart_points STUDY.json

prints {"CHART": [{"point": 3, "x": 0.25, "y": 0.5, "words": "pcf, bias_m 0.01: ..."}]} with x and y as shares of the
picture's width and height, y down, and `point` its place in the study. A process of its own: matplotlib is large.
"""

import json
import sys
from pathlib import Path

import matplotlib.pyplot as plt
from charts.chart import STYLE, build_figure
from charts.study_charts import chart_paths, charts_of
from charts.study_file import figures, load


def points_of(chart, numbers: dict[int, int]) -> list[dict]:
    with plt.rc_context(STYLE):
        made = []
        figure = build_figure(chart, made)
        figure.draw_without_rendering()
        wide, high = figure.bbox.width, figure.bbox.height
        found = []
        for panel, points in made:
            for point in points:
                x, y = panel.axis_of(point).transData.transform(panel.at(point))
                if 0 <= x <= wide and 0 <= y <= high:
                    found.append({"point": numbers[id(point.data)], "x": round(x / wide, 5), "y": round(1 - y / high, 5),
                                  "words": words_of(point, chart)})
        plt.close(figure)
    return found


def words_of(point, chart) -> str:
    knobs = ", ".join(f"{name} {value}" for name, value in point.knobs.items())
    low, middle, high = point.time
    return (f"{point.method}{f' ({knobs})' if knobs else ''}, {point.scene}\n{figures(middle)} {chart.study.unit} "
            f"(quartiles {figures(low)} to {figures(high)})\n{chart.study.metric_label(chart.study.metric)} {figures(point.error)}")


def main(words: list[str]) -> int:
    path = Path(words[0])
    study = load(path)
    numbers = {id(point): i for i, point in enumerate(study.data["points"])}
    beside = path.with_suffix("")
    print(json.dumps({at.name: points_of(chart, numbers) for at, chart in zip(chart_paths(study.data, beside), charts_of(study))}))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
