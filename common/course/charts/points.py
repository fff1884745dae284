"""The points of a study's charts: where they lie, and the pictures behind them.

python3 common/course charts.points STUDY.json prints {"CHART": [{"point": 3, "x": 0.25, "y": 0.5, "words": "pcf, bias_m 0.01: ..."}]}
with x and y as shares of the picture's width and height, y down, and `point` its place in the study. places_of() asks a process
of its own: matplotlib is large.
"""

import hashlib
import json
import subprocess
import sys
from pathlib import Path

from shots.rendering import text
from tree import BUILD, PYTHON, ROOT, Failure, chapters, write_atomically


def places_of(study: Path) -> dict[str, list[dict]]:
    """The points by chart, kept until the study or the charts' code changes. Raises Failure."""
    code = b"".join(path.read_bytes() for path in sorted(Path(__file__).parent.glob("*.py")))
    kept = BUILD / "charts" / "points" / f"{study.stem}.{hashlib.sha256(code + study.read_bytes()).hexdigest()[:16]}.json"
    if not kept.exists():
        said = subprocess.run([*PYTHON, ROOT / "common/course", "charts.points", study], stdout=subprocess.PIPE)
        if said.returncode:
            raise Failure(f"where the points of {study.name} lie could not be found")
        write_atomically(kept, said.stdout)
    return json.loads(kept.read_text(encoding="utf-8"))


def can_draw(study: dict) -> bool:
    """True if the points are pictures of scenes in the course."""
    return study["subject"] == "frame" and bool(study.get("scenes")) and "truth" in study and study["chapter"] in chapters()


def request_of(study: dict, point: dict, truth: bool = False) -> tuple[str, dict[str, str]] | None:
    """The scene's file and the knobs of a point, or of the truth beside it; None where the point has no scene."""
    scene = study["scenes"].get(point["scene"], {})
    if not scene.get("file"):
        return None
    own = study["truth"] if truth else point
    method = {study.get("method_knob", "method"): own["method"]} if own.get("method") else {}
    return scene["file"], method | {name: text(value) for part in (scene.get("set", {}), own.get("knobs", {})) for name, value in part.items()}


def command_of(study: dict, point: dict) -> tuple[str, ...]:
    """The same as words of a command line; none where the point has no scene."""
    request = request_of(study, point)
    return ("--scene", request[0], *(word for knob in request[1].items() for word in ("--set", "=".join(knob)))) if request else ()


def points_of(chart, numbers: dict[int, int]) -> list[dict]:
    import matplotlib.pyplot as plt
    from charts.chart import STYLE, build_figure

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
    from charts.study_file import figures

    knobs = ", ".join(f"{name} {value}" for name, value in point.knobs.items())
    low, middle, high = point.time
    return (f"{point.method}{f' ({knobs})' if knobs else ''}, {point.scene}\n{figures(middle)} {chart.study.unit} "
            f"(quartiles {figures(low)} to {figures(high)})\n{chart.study.metric_label(chart.study.metric)} {figures(point.error)}")


def main(words: list[str]) -> int:
    from charts.study_charts import chart_paths, charts_of
    from charts.study_file import load

    path = Path(words[0])
    study = load(path)
    numbers = {id(point): i for i, point in enumerate(study.data["points"])}
    beside = path.with_suffix("")
    print(json.dumps({at.name: points_of(chart, numbers) for at, chart in zip(chart_paths(study.data, beside), charts_of(study))}))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
