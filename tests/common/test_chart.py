"""Charts of studies: what is drawn where, what is refused, and that the same study gives the same file."""

import contextlib
import copy
import hashlib
import io
import json
import math
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "common" / "course"))

import chart  # noqa: E402
import chart_labels  # noqa: E402
import chart_panel  # noqa: E402
from study_charts import charts_of  # noqa: E402
from study_file import Study, StudyError, load, markdown_table  # noqa: E402


def point(scene, method, error, ms, knobs=None, **more):
    return {"scene": scene, "method": method, "knobs": knobs or {},
            "error": {"flip_mean": error, "flip_p99": 0.5, "nan": 0, "inf": 0},
            "time_ms": {"median": ms, "q1": ms * 0.9, "q3": ms * 1.2, "rounds": 9}, **more}


STUDY = {
    "chapter": "02_lambert_phong", "title": "Reflection", "subject": "frame", "device": "NVIDIA H200",
    "driver": "570", "stage": "fragment", "command": "./course study 02", "error_metric": "flip_mean",
    "time_unit": "ms", "truth": {"method": "supersampled", "knobs": {"samples": 64}, "doubling_change": 0.0005},
    "points": [point("bunny", "gouraud", 0.05, 0.1), point("bunny", "phong", 0.02, 0.2, {"samples": 1, "bias": 2}),
               point("bunny", "phong", 0.004, 0.8, {"samples": 4, "bias": 2}), point("bunny", "slow", 0.03, 1.0),
               point("bunny", "exact", 0, 4.0), point("bunny", "broken", None, 0.15)],
}


def study(**changes):
    return Study(copy.deepcopy(STUDY) | changes)


def over_lights(**changes):
    """Three scenes that set `lights`, and one that sets nothing."""
    points = [point("yard", "uncut", 0.01, 0.3), point("yard", "culled", 0.02, 0.2, {"threshold": 0.1})]
    for lights in (1, 10, 100):
        label = f"{lights} lights"
        points += [point(label, "uncut", 0, 0.1 * lights, {"lights": lights})]
        points += [point(label, "culled", threshold, 0.05 * lights / (1 + threshold),
                         {"lights": lights, "threshold": threshold}) for threshold in (0.01, 0.1)]
    for p in points[2:]:
        p["error"]["hit_texels"] = p["time_ms"]["median"] / 10
    scenes = {f"{n} lights": {"file": "x.json", "set": {"lights": n}, "one_step": {"flip_mean": 0.03 + n / 1e4},
                              "doubling": {"flip_mean": n / 1e4}} for n in (1, 10, 100)}
    charts = [{"name": "main"}, {"name": "lights", "title": "Time against lights", "x": "knob lights", "y": "time"},
              {"name": "threshold", "x": "knob threshold", "scenes": ["1 lights", "10 lights"]},
              {"name": "texels", "x": "hit_texels", "y": "time", "methods": ["culled"]},
              {"name": "errors", "x": "hit_texels", "y": "flip_mean"},
              {"name": "rule", "x": "knob lights", "x_scale": "linear"}]
    return study(**{"points": points, "scenes": scenes | {"yard": {"set": {}}}, "charts": charts, "size": [960, 540],
                    **changes})


class Reading(unittest.TestCase):
    def test_front(self):
        front = [(p.method, p.time[1]) for p in study().front("bunny")]
        self.assertEqual(front, [("gouraud", 0.1), ("phong", 0.2), ("phong", 0.8), ("exact", 4.0)])
        tie = study(points=[point("s", "a", 1, 1), point("s", "b", 1, 1), point("s", "c", 1, 2), point("s", "d", 2, 1)])
        self.assertEqual([p.method for p in tie.front("s")], ["a", "b"])

    def test_throughput_is_faster_where_it_is_higher(self):
        points = [{"scene": "f", "method": m, "error": {"ulp": ulp}, "mb_per_s": {"median": v, "q1": v, "q3": v}}
                  for m, v, ulp in (("slow", 10, 0), ("fast", 800, 0), ("wrong", 900, 3))]
        loaders = study(subject="loader", time_unit="MB/s", error_metric="ulp", points=points)
        self.assertEqual([p.method for p in loaders.front("f")], ["wrong", "fast"])
        self.assertFalse(loaders.software)

    def test_software_times_are_labelled(self):
        self.assertEqual(study().time_label, "GPU time, ms")
        for names in ({"device": "llvmpipe (LLVM 15.0.6, 256 bits)"}, {"driver": "llvmpipe"}):
            self.assertEqual(study(**names).time_label, "CPU time (software rasteriser), ms")

    def test_knob_labels_name_only_what_varies(self):
        one = charts_of(study())[0]
        labels = [one.label_of(p) for p in one.points[:3]]
        self.assertEqual(labels, ["", "1", "4"])

    def test_one_step(self):
        self.assertEqual(study(one_step={"flip_mean": 0.02}).one_step("bunny", "flip_mean"), (0.02, True))
        self.assertEqual(study().one_step("bunny", "rmse"), (0.00367, False))
        self.assertEqual(study().one_step("bunny", "ulp"), (None, False))
        of_scenes = study(scenes={"a": {"one_step": {"flip_mean": 0.03}}, "b": {"one_step": {"flip_mean": 0.04}}})
        self.assertEqual([of_scenes.one_step(scene, "flip_mean")[0] for scene in "ab"], [0.03, 0.04])
        self.assertEqual(of_scenes.one_step("a", "hit_texels"), (None, False))

    def test_refused(self):
        for changes, why in (({"points": []}, "no points"), ({"subject": "film"}, "film"), ({"time_unit": "s"}, '"s"'),
                             ({"error_metric": "beauty"}, "beauty"), ({"points": [{"scene": "x"}]}, "without"),
                             ({"points": [point("s", "a", 1, 1, device="llvmpipe")]}, "never share an axis")):
            with self.subTest(why), self.assertRaisesRegex(StudyError, why):
                study(**changes)
        self.assertEqual(over_lights(error_metric="hit_texels").metric, "hit_texels")
        without = {key: value for key, value in STUDY.items() if key != "driver"}
        with self.assertRaisesRegex(StudyError, "driver"):
            Study(without)

    def test_table(self):
        lines = markdown_table(study()).splitlines()
        self.assertEqual(len(lines), 2 + 6 + 2)
        self.assertIn("GPU ms (median)", lines[0])
        self.assertTrue(lines[2].startswith("| ● | bunny | gouraud |"))
        self.assertTrue(lines[5].startswith("|  | bunny | slow |"))
        self.assertIn("NaN", lines[7])
        self.assertEqual({line.count("|") for line in lines[:8]}, {11})

    def test_table_of_scenes_that_set_knobs_and_of_errors_of_the_chapters_own(self):
        lines = markdown_table(over_lights(metrics={"hit_texels": "texels beside the hit"})).splitlines()
        self.assertIn("| texels beside the hit |", lines[0])
        self.assertIn("| yard | uncut |  |", lines[2])
        self.assertIn("|  | 0 | 0 |", lines[2])  # not measured there: no figure
        self.assertIn("| 100 lights | culled | lights 100, threshold 0.01 |", lines[-4])
        self.assertIn("fragment, 960 × 540. Made by", lines[-1])


class Choosing(unittest.TestCase):
    """What each chart shows, before it is drawn."""

    def charts(self, **changes):
        return {chart.entry.get("name"): chart for chart in charts_of(over_lights(**changes))}

    def test_panels(self):
        charts = self.charts()
        scenes = ["yard", "1 lights", "10 lights", "100 lights"]
        self.assertEqual(charts["main"].panels, [[scene] for scene in scenes])
        self.assertEqual(charts["lights"].panels, [scenes[1:]])  # the yard sets no lights
        self.assertEqual(charts["threshold"].panels, [["1 lights"], ["10 lights"]])

    def test_a_curve_for_each_method_and_for_each_value_of_the_other_knobs(self):
        chart = self.charts()["lights"]
        curves = [(method, chart.label_of(curve[0]), [p.knobs["lights"] for p in curve])
                  for method, curve in chart.curves(chart.drawable)]
        self.assertEqual(curves, [("uncut", "", [1, 10, 100]), ("culled", "0.01", [1, 10, 100]),
                                  ("culled", "0.1", [1, 10, 100])])
        chart = self.charts()["threshold"]
        self.assertEqual([method for method, _ in chart.curves(chart.drawable)], ["culled"])  # within a panel
        self.assertEqual(chart.missing(), {"no threshold": ["uncut"]})
        one = over_lights()
        one.points.reverse()  # over a knob, from left to right all the same
        chart = charts_of(one)[1]
        self.assertEqual([p.knobs["lights"] for p in chart.curves(chart.drawable)[0][1]], [1, 10, 100])

    def test_some_values_of_a_knob(self):
        def shown(values):
            return charts_of(over_lights(charts=[{"name": "a", "x": "knob lights", "knobs": {"threshold": values}}]))[0]

        one = shown(0.1)
        self.assertEqual({p.knobs.get("threshold") for p in one.points}, {None, 0.1})
        self.assertEqual([one.label_of(curve[0]) for _, curve in one.curves(one.points)], ["", ""])
        self.assertEqual(one.point_knobs, [])
        self.assertEqual(shown([0.01, 0.1]).point_knobs, ["threshold"])
        with self.assertRaisesRegex(StudyError, "sets the knob \"threshold\" to 0.5"):
            shown([0.1, 0.5])

    def test_scales(self):
        charts = self.charts()
        self.assertTrue(charts["lights"].x.log and charts["lights"].y.log and charts["threshold"].x.log)
        self.assertFalse(charts["rule"].x.log)
        for values, log in (((1, 9), False), ((0, 1, 10), True), ((-1, 10), False), ((0, 0), False)):
            points = [point("s", "m", 1, 1, {"k": value}) for value in values]
            self.assertEqual(charts_of(study(points=points, charts=[{"name": "a", "x": "knob k"}]))[0].x.log, log)

    def test_the_front_needs_time_and_error(self):
        charts = self.charts()
        fronts = {name: [p.method for p in chart.front(chart.drawable)] for name, chart in charts.items()}
        self.assertEqual((fronts["lights"], fronts["threshold"], fronts["errors"]), ([], [], []))
        self.assertEqual(fronts["main"][-1], "uncut")
        self.assertEqual(set(fronts["texels"]), {"culled"})
        own = charts["texels"]
        ten = [p for p in own.drawable if p.scene == "10 lights"]
        self.assertEqual([p.knobs["threshold"] for p in own.front(ten)], [0.1])  # by hit_texels, not by FLIP

    def test_doubt_is_the_scenes_own(self):
        s = over_lights()
        self.assertEqual(s.doubling_change("10 lights", "flip_mean"), 0.001)
        self.assertIsNone(s.doubling_change("10 lights", "rmse"))
        self.assertEqual(study().doubling_change("bunny", "flip_mean"), 0.0005)
        self.assertIsNone(study().doubling_change("bunny", "rmse"))
        rule = charts_of(s)[5]
        self.assertEqual(chart_panel.lines_of(rule, rule.panels[0]), (0.0301, 0.01, True))
        self.assertEqual(chart_panel.lines_of(charts_of(s)[1], ["1 lights"]), (None, None, False))

    def test_refused(self):
        for entry, why in (({"x": "knob shadows"}, "no point sets the knob"), ({"y": "beauty"}, "no point has the error"),
                           ({"colour": 1}, "colour"), ({"scenes": ["park"]}, "park.*there are yard"),
                           ({"methods": ["tiled"]}, "tiled.*there are uncut"), ({"y": "knob lights"}, "knob lights"),
                           ({"x_scale": "cubic"}, "cubic"), ({"x": "hit_texels", "scenes": ["yard"]}, "hit_texels")):
            with self.subTest(why), self.assertRaisesRegex(StudyError, f'chart "one".*{why}'):
                charts_of(study(**{**over_lights().data, "charts": [{"name": "one"} | entry]}))
        for charts in ([{}], [{"name": "a"}, {"name": "a"}]):
            with self.assertRaisesRegex(StudyError, "name.* of its own"):
                charts_of(study(charts=charts))
        with self.assertRaisesRegex(StudyError, "no axis can show"):
            charts_of(study(points=[point("s", "m", 1, 1, {"k": "fast"})], charts=[{"name": "a", "x": "knob k"}]))


class Drawing(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)

    def figure(self, s, which=0):
        with chart.plt.rc_context(chart.STYLE):
            figure = chart.build_figure(charts_of(s)[which])
            figure.canvas.draw()
        self.addCleanup(chart.plt.close, figure)
        return figure

    def texts(self, figure):
        found = [text.get_text() for text in figure.texts]
        for axis in figure.axes:
            found += [text.get_text() for text in axis.texts] + [axis.get_xlabel(), axis.get_ylabel()]
        return found

    def test_it_says_what_it_is(self):
        texts = self.texts(self.figure(study()))
        for text in ("Reflection", "NVIDIA H200 · 570 · fragment", "./course study 02", "GPU time, ms",
                     "error: FLIP, mean", "gouraud", "phong", "slow", "exact", "one 8-bit step at mid grey",
                     "Pareto front"):
            self.assertIn(text, texts)
        self.assertTrue(any("Not drawn: broken" in text for text in texts))
        self.assertNotIn("broken", texts)

    def test_axes(self):
        main, zero = self.figure(study()).axes
        self.assertEqual((main.get_xscale(), main.get_yscale()), ("log", "log"))
        self.assertEqual(main.get_xlim(), zero.get_xlim())
        self.assertEqual([label.get_text() for label in zero.get_yticklabels()], ["0"])
        only_exact = self.figure(study(points=[point("s", "exact", 0, 1)]))
        self.assertEqual(len(only_exact.axes), 1)

    def test_panels_share_their_axes(self):
        points = [point(scene, "m", e, t) for scene, e, t in (("a", 0.1, 1), ("b", 0.01, 5), ("c", 0.5, 2))]
        figure = self.figure(study(points=points))
        self.assertEqual(len(figure.axes), 3)
        self.assertEqual(len({(axis.get_xlim(), axis.get_ylim()) for axis in figure.axes}), 1)

    def test_time_over_a_knob_of_the_scenes(self):
        figure = self.figure(over_lights(), 1)
        texts = self.texts(figure)
        for text in ("Time against lights", "NVIDIA H200 · 570 · fragment · 960 × 540", "lights", "GPU time, ms",
                     "uncut", "culled", "0.01", "0.1", "Points: median, bars: quartiles.  Small numbers: threshold."):
            self.assertIn(text, texts)
        for text in ("Pareto front", "one 8-bit step", "error"):
            self.assertFalse([found for found in texts if text in found], text)
        self.assertEqual(texts.count("culled"), 1)
        axis, = figure.axes
        self.assertEqual((axis.get_xscale(), axis.get_yscale(), axis.get_ylabel()), ("log", "log", "GPU time, ms"))
        self.assertLess(axis.get_ylim()[0], 0.04)  # the quartiles are on it
        self.assertGreater(axis.get_ylim()[1], 12)

    def test_zero_stands_in_a_strip_beside_either_axis(self):
        points = [point("s", "m", error, ms, {"k": k}) for error, ms, k in ((0, 1, 0), (0.1, 2, 1), (0.2, 3, 20))]
        charts = [{"name": "a", "x": "knob k"}, {"name": "b", "x": "flip_mean", "y": "time"}]
        cells = self.figure(study(points=points, charts=charts), 0).axes
        self.assertEqual([(a.get_xscale(), a.get_yscale()) for a in cells],
                         [("linear", "log"), ("log", "log"), ("linear", "linear"), ("log", "linear")])
        self.assertEqual([cell.spines["bottom"].get_visible() for cell in cells], [False, False, True, True])
        self.assertEqual([cell.spines["left"].get_visible() for cell in cells], [True, False, True, False])
        left, main = self.figure(study(points=points, charts=charts), 1).axes
        self.assertEqual([label.get_text() for label in left.get_xticklabels()], ["0"])
        self.assertEqual(left.get_ylim(), main.get_ylim())
        self.assertEqual((left.get_ylabel(), main.get_xlabel()), ("GPU time, ms", "error: FLIP, mean"))

    def test_each_panel_has_its_own_step(self):
        heights = []
        for axis in self.figure(over_lights()).axes:
            heights += [line.get_ydata()[0] for line in axis.lines if line.get_linestyle() == "--"]
        self.assertEqual(heights, [0.0299, 0.0301, 0.031, 0.04])  # the yard's is that of mid grey
        own = self.figure(over_lights(error_metric="hit_texels", charts=[{"name": "a", "scenes": ["1 lights"]}]))
        self.assertFalse([text for text in self.texts(own) if "8-bit" in text])
        self.assertIn("hit texels", self.texts(own))

    def test_words_at_a_line_leave_the_points_there_alone(self):
        def places(words, *points):
            points = [point("other", "m", 0.3, 0.1)] + [point("s", f"m{i}", error, ms)
                                                        for i, (error, ms) in enumerate(points)]
            axis = self.figure(study(points=points, truth={"method": "m", "doubling_change": 0.02})).axes[1]
            return [text.xy[0] for text in axis.texts if words in text.get_text()]

        self.assertEqual(places("8-bit", (0.0312, 0.11)), [1])
        self.assertEqual(places("8-bit", (0.0312, 3)), [0])
        self.assertEqual(places("8-bit", (0.0312, 0.11), (0.0312, 3)), [1])
        self.assertEqual(places("truth", (0.018, 3)), [0])

    def test_an_exact_truth_is_called_so(self):
        texts = self.texts(self.figure(study(truth={"method": "uncut", "knobs": {}, "exact": True})))
        self.assertTrue([text for text in texts if "Truth: uncut, by definition." in text])

    def test_labels_stay_clear_of_upright_bars(self):
        points = [point("s", "only", 0.02, 1, {"k": 1}), point("s", "only", 0.02, 1, {"k": 2})]
        for p in points:
            p["time_ms"] |= {"q1": 0.2, "q3": 5}
        figure = self.figure(study(points=points, charts=[{"name": "a", "x": "knob k", "y": "time"}]))
        label, = [text for text in figure.axes[0].texts if text.get_text() == "only"]
        box = label.get_window_extent(figure.canvas.get_renderer())
        to_pixels = figure.axes[0].transData.transform
        bars = [path.vertices for lines in figure.axes[0].collections for path in lines.get_paths()]
        self.assertEqual([[round(y, 9) for y in sorted(ends[:, 1])] for ends in bars], [[0.2, 5]] * 2)
        for k in (1, 2):
            (x, low), (_, high) = to_pixels((k, 0.2)), to_pixels((k, 5))
            self.assertFalse(box.x0 < x < box.x1 and box.y0 < high and box.y1 > low)

    def test_a_label_above_or_below_stands_at_the_end_of_the_bar(self):
        figure = chart.plt.figure()
        self.addCleanup(chart.plt.close, figure)
        axis = figure.add_subplot()
        axis.set_ylim(0, 10)
        labels = chart_labels.Labels(figure.axes)
        for place, above in (((0, 9), "center", "bottom"), True), (((0, -9), "center", "top"), False):
            with mock.patch.object(chart_labels, "PLACES", [place]):
                labels.place("m", [(axis, 0.5, 5, (0.5, 0.5), (2, 8))], "black", 9, "normal", True)
            box = axis.texts[-1].get_window_extent(figure.canvas.get_renderer())
            end = axis.transData.transform((0.5, 8 if above else 2))[1]
            self.assertTrue(box.y0 > end if above else box.y1 < end)
        labels.avoid_curve([(axis, 0.2, 5, (0.2, 0.2), (2, 8))])
        for y, taken in ((1, False), (3, True), (7, True), (9, False)):
            at = axis.transData.transform((0.2, y))
            self.assertEqual(any(box.contains(*at) for box in labels.boxes), taken)

    def test_labels_cover_neither_each_other_nor_a_point(self):
        points = [point("s", f"method_{i}", 0.02 * 0.98**i * (j + 1), 0.3 * 1.005**i * (j + 1), {"n": j})
                  for i in range(6) for j in range(2)]
        s = study(points=points)
        figure = self.figure(s)
        renderer = figure.canvas.get_renderer()
        boxes = [t.get_window_extent(renderer) for t in figure.axes[0].texts if t.get_text().startswith("method_")]
        self.assertEqual(len(boxes), 6)
        for i, a in enumerate(boxes):
            for b in boxes[i + 1:]:
                self.assertFalse(a.overlaps(b))
        at = [figure.axes[0].transData.transform((p.time[1], p.error)) for p in s.points]
        self.assertFalse(any(box.contains(*pixel) for box in boxes for pixel in at))

    def test_the_same_study_gives_the_same_files(self):
        path = self.folder / "reflection.json"
        path.write_text(json.dumps(STUDY))
        seen = set()
        for name in ("first", "second"):
            out = self.folder / name
            subprocess.run([sys.executable, ROOT / "common/course/chart.py", path, "--out", out], check=True)
            files = sorted(out.iterdir())
            self.assertEqual([f.name for f in files], ["reflection.md", "reflection.png", "reflection.svg"])
            seen.add(tuple(hashlib.sha256(f.read_bytes()).hexdigest() for f in files))
        self.assertEqual(len(seen), 1)

    def test_a_file_for_each_chart_and_one_table(self):
        path = self.folder / "lights.json"
        path.write_text(json.dumps(over_lights().data))
        self.assertEqual(chart.main([str(path)]), 0)
        names = ["lights.md"] + [f"lights{chart_name}.{suffix}" for suffix in ("png", "svg") for chart_name in
                                 ("", ".lights", ".threshold", ".texels", ".errors", ".rule")]
        self.assertEqual(sorted(f.name for f in self.folder.iterdir()), sorted(names + ["lights.json"]))
        for file in self.folder.glob("lights.*"):
            if file != path:
                file.unlink()
        wrong = over_lights().data | {"charts": [{"name": "main"}, {"name": "b", "y": "beauty"}]}
        path.write_text(json.dumps(wrong))
        with contextlib.redirect_stderr(io.StringIO()):
            self.assertEqual(chart.main([str(path)]), 2)
        self.assertEqual(list(self.folder.iterdir()), [path])  # all or nothing

    def test_bad_input_is_one_line_and_exit_code_2(self):
        torn, empty, unfinished = (self.folder / name for name in ("torn.json", "empty.json", "nan.json"))
        torn.write_text("{")
        empty.write_text("{}")
        unfinished.write_text(json.dumps(STUDY | {"points": [point("s", "a", math.nan, 1)]}))
        for path in (torn, empty, unfinished, self.folder / "missing.json", self.folder):
            with self.subTest(path.name), contextlib.redirect_stderr(io.StringIO()) as said:
                self.assertEqual(chart.main([str(path), "--out", str(self.folder / "o")]), 2)
                self.assertEqual(said.getvalue().count("\n"), 1)
                self.assertIn("chart: ", said.getvalue())
        self.assertFalse((self.folder / "o").exists())

    def test_loading(self):
        with self.assertRaisesRegex(StudyError, "missing.json: cannot be read"):
            load(self.folder / "missing.json")


if __name__ == "__main__":
    unittest.main()
