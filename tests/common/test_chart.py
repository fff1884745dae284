"""Charts of studies: what they read and choose, positions of marks, and equal files for equal studies."""
# Builds: nothing

import contextlib
import hashlib
import io
import json
import math
import subprocess
import sys
import unittest

import numpy as np

from charts import chart, chart_panel
from chart_fixture import STUDY, over_lights, point, study
from charts.said import between, said_by
from charts.study_charts import Chart, charts_of
from charts.study_file import Study, StudyError, load, markdown_table
from folder_case import FolderCase
from tree import ROOT


class Drawing(FolderCase):
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
        for text in ("Reflection", "NVIDIA H200 · 570 · fragment", "./course study 02", "GPU time, ms  (← faster)",
                     "error: FLIP, mean  (↓ less is better)", "gouraud", "phong", "slow", "exact",
                     "one 8-bit step at mid grey", "enough: phong 1"):
            self.assertIn(text, texts)
        self.assertTrue(any("Not drawn: broken" in text for text in texts))
        self.assertNotIn("broken", texts)

    def test_time_over_a_knob_of_the_scenes(self):
        figure = self.figure(over_lights(), 1)
        texts = self.texts(figure)
        for text in ("Time against lights", "NVIDIA H200 · 570 · fragment · 960 × 540", "lights", "GPU time, ms  (↓ faster)",
                     "uncut", "culled, 0.01", "culled, 0.1",
                     "Points: median, bars: quartiles.  Behind a method's name: threshold."):
            self.assertIn(text, texts)
        for text in ("Pareto front", "one 8-bit step", "error"):
            self.assertFalse([found for found in texts if text in found], text)
        axis, = figure.axes
        self.assertEqual((axis.get_xscale(), axis.get_yscale(), axis.get_ylabel()), ("log", "log", "GPU time, ms  (↓ faster)"))
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
        self.assertEqual((left.get_ylabel(), main.get_xlabel()), ("GPU time, ms  (↓ faster)", "error: FLIP, mean  (← less is better)"))

    def test_each_panel_has_its_own_step(self):
        heights = []
        for axis in self.figure(over_lights()).axes:
            heights += [line.get_ydata()[0] for line in axis.lines if line.get_linestyle() == "--"]
        self.assertEqual(heights, [0.0299, 0.0301, 0.031, 0.04])  # the yard's is that of mid grey
        own = self.figure(over_lights(error_metric="hit_texels", charts=[{"name": "a", "scenes": ["1 lights"]}]))
        self.assertFalse([text for text in self.texts(own) if "8-bit" in text])
        self.assertIn("hit texels  (↓ less is better)", self.texts(own))

    def test_an_exact_truth_is_called_so(self):
        texts = self.texts(self.figure(study(truth={"method": "uncut", "knobs": {}, "exact": True})))
        self.assertTrue([text for text in texts if "Truth: uncut, by definition." in text])

    def test_a_row_for_each_method(self):
        s = study(error_metric="ulp", points=[point("s", "exact", 0, 2), point("s", "near", 0, 1)],
                  charts=[{"name": "a", "y": "method", "enough": {"at": 0, "text": "no error"}}])
        for p, ulp in zip(s.points, (0, 3)):
            p.error = p.data["error"]["ulp"] = ulp
        figure = self.figure(s)
        self.assertEqual([label.get_text() for label in figure.axes[0].get_yticklabels()], ["exact", "near"])
        texts = self.texts(figure)
        self.assertIn("2 ms\nno error", texts)
        self.assertIn("1 ms\noff by 3 ULP", texts)
        self.assertEqual(charts_of(s)[0].enough_of(s.points).method, "exact")

    def test_rows_over_an_error(self):
        points = [point("s", "one", error, 2, {"tone": tone, "size": 3}) for tone, error in (("a", 0.3), ("b", 0.04), ("c", 0.02))]
        s = study(points=points, charts=[{"name": "a", "x": "flip_mean", "y": "method"}], truth={"method": "", "knobs": {"views": 64}})
        figure = self.figure(s)
        axis, = figure.axes
        self.assertEqual([label.get_text() for label in axis.get_yticklabels()], ["a", "b", "c"])  # not the one method
        self.assertEqual(len({label.get_color() for label in axis.get_yticklabels()}), 3)
        texts = self.texts(figure)
        for text in ("0.04\n2 ms", "one 8-bit step at mid grey", "error: FLIP, mean  (← less is better)", "Smallest error: c."):
            self.assertIn(text, texts)
        self.assertTrue([text for text in texts if "Truth: views 64." in text])
        self.assertEqual([line.get_xdata()[0] for line in axis.lines if line.get_linestyle() == "--"], [0.0299])
        with self.assertRaisesRegex(StudyError, "needs \"x\": \"time\" or a metric"):
            charts_of(study(points=points, charts=[{"name": "a", "x": "knob size", "y": "method"}]))

    def test_less_than_the_truth_knows_is_in_the_strip_of_zero(self):
        s = study(points=[point("s", "m", error, 1) for error in (0.1, 0.00006, 0.00004)])
        axis = charts_of(s)[0].y
        self.assertEqual([axis.is_zero(p) for p in s.points], [False, False, True])
        self.assertEqual(axis.zero_text, "≈ 0")

    def test_no_words_overlap_in_the_studies_that_lessons_show(self):
        files = sorted((ROOT / "docs/studies").glob("*.json"))
        self.assertTrue(files)
        for file in files:
            s = load(file)
            for which, one in enumerate(charts_of(s)):
                with self.subTest(f"{file.name} {one.entry.get('name', '')}"):
                    self.check_words(self.figure(s, which), one)
                    chart.plt.close()

    def check_words(self, figure, one):
        renderer = figure.canvas.get_renderer()
        ticks = {id(label) for axis in figure.axes for label in axis.get_xticklabels(which="both") +
                 axis.get_yticklabels(which="both")}
        words = [(text.get_text(), text.get_window_extent(renderer)) for text in figure.findobj(chart.plt.Text)
                 if text.get_text().strip() and text.get_visible() and id(text) not in ticks]
        whole = figure.bbox.padded(1)
        low, high = (np.array([corner(box) for _, box in words]) for corner in (lambda b: b.min + 1, lambda b: b.max - 1))
        for i, (text, box) in enumerate(words):
            self.assertTrue(whole.x0 <= box.x0 and box.x1 <= whole.x1 and whole.y0 <= box.y0 and box.y1 <= whole.y1,
                            f"{text} leaves the figure")
            over = np.flatnonzero(((low[:i] < high[i]) & (low[i] < high[:i])).all(axis=1))
            self.assertFalse(over.size, f"{text} over {[words[other][0] for other in over]}")
        markers = np.concatenate([axis.transData.transform(line.get_xydata()) for axis in figure.axes for line in axis.lines
                                  if line.get_marker() not in ("None", None, "", "|", "_")])
        self.assertGreaterEqual(len(markers), len(one.drawable))
        for i, (text, _) in enumerate(words):
            self.assertFalse(((low[i] <= markers) & (markers <= high[i])).all(axis=1).any(), f"{text} over a point")

    def test_the_same_study_gives_the_same_files(self):
        path = self.write("reflection.json", json.dumps(STUDY))
        seen = set()
        for name in ("first", "second"):
            out = self.folder / name
            subprocess.run([sys.executable, ROOT / "common/course", "charts.chart", path, "--out", out], check=True)
            files = sorted(out.iterdir())
            self.assertEqual([f.name for f in files], ["reflection.md", "reflection.png", "reflection.svg"])
            seen.add(tuple(hashlib.sha256(f.read_bytes()).hexdigest() for f in files))
        self.assertEqual(len(seen), 1)

    def test_a_file_for_each_chart_and_one_table(self):
        path = self.write("lights.json", json.dumps(over_lights().data))
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
        unfinished = json.dumps(STUDY | {"points": [point("s", "a", math.nan, 1)]})
        for path in (self.write("torn.json", "{"), self.write("empty.json", "{}"), self.write("nan.json", unfinished),
                     self.folder / "missing.json", self.folder):
            with self.subTest(path.name), contextlib.redirect_stderr(io.StringIO()) as said:
                self.assertEqual(chart.main([str(path), "--out", str(self.folder / "o")]), 2)
                self.assertEqual(said.getvalue().count("\n"), 1)
                self.assertIn("chart: ", said.getvalue())
        self.assertFalse((self.folder / "o").exists())


def three(**entry) -> Chart:
    """A frame of 5 ms, two methods that add 1 and 2 ms to it, and one that is as fast."""
    points = [point("s", "none", 0.4, 5.0), point("s", "a", 0.02, 6.0), point("s", "b", 0.01, 7.0),
              point("s", "same", 0.3, 5.0)]
    for one, passes in zip(points, ({"shade": 5.0}, {"shade": 5.0, "blur x": 0.5, "blur y": 0.25}, {"blur x": 2.0}, {})):
        one["time_ms"]["per_pass"] = passes
    return Chart(study(points=points), {"name": "main"} | entry)


class Added(unittest.TestCase):
    def test_the_time_beyond_a_method(self):
        chart = three(over="none")
        times = {p.method: p.time[1] for p in chart.drawable}
        self.assertEqual({name: round(ms, 6) for name, ms in times.items()}, {"none": 0, "a": 1, "b": 2, "same": 0})
        self.assertEqual([p.method for p in chart.drawable if chart.x.is_zero(p)], ["none", "same"])
        self.assertIn("beyond none", chart.x.label())
        self.assertEqual(chart.study.points[1].time[1], 6)  # the study keeps the frame's

    def test_the_time_of_passes(self):
        times = {p.method: p.time[1] for p in three(passes=["blur"]).points}
        self.assertEqual(times, {"none": 0, "a": 0.75, "b": 2, "same": 0})

    def test_what_cannot_be_subtracted_is_refused(self):
        for entry in ({"over": "unknown"}, {"over": "none", "passes": ["blur"]}):
            with self.subTest(entry), self.assertRaises(StudyError):
                three(**entry)
        with self.assertRaisesRegex(StudyError, 'no pass begins with "blurr"; there are: blur x, blur y, shade'):
            three(passes=["blurr"])

    def test_less_than_a_hundredth_is_as_fast(self):
        points = [point("s", "none", 0.4, 5.0), point("s", "a", 0.02, 5.04), point("s", "b", 0.02, 5.06)]
        for p in points:
            p["time_ms"]["q1"] = p["time_ms"]["median"]
        chart = Chart(study(points=points), {"name": "main", "over": "none"})
        self.assertEqual([p.method for p in chart.drawable if chart.x.is_zero(p)], ["none", "a"])

    def test_what_a_curve_does_is_said_in_words(self):
        for factors, said in (((0.218, 0.5), "falls to 22% (a) to 50% (b)"), ((4.66, 1460), "grows by a factor of 4.7 (a) to 1,500 (b)"),
                              ((0.5, 3), "falls to 50% (a) or grows by a factor of 3 (b)"), ((0.98, 1.02), "hardly changes"),
                              ((0.97, 2), "hardly changes (a) or grows by a factor of 2 (b)"), ((7, 7), "grows by a factor of 7")):
            self.assertEqual(between((factors[0], "a"), (factors[1], "b")), said)
        points = [point("s", "m", error, 1, {"size": size}) for size, error in ((256, 0.4), (1024, 0.1))]
        self.assertEqual(said_by(Chart(study(points=points), {"name": "a", "x": "knob size", "x_label": "size, texels: of a map"})),
                         "From size 256 to 1,024 texels the error falls to 25%.")

    def test_names_say_which_switch_and_leave_out_the_one_method(self):
        points = [point(str(n), "m", 0.1 * n, n, {"n": n, "volumes": on}) for n in (1, 2) for on in ("on", "off")]
        scenes = {str(n): {"set": {"n": n}} for n in (1, 2)}
        chart = Chart(study(points=points, scenes=scenes), {"name": "a", "x": "knob n", "y": "time", "y_label": "words  (↑ faster)"})
        self.assertEqual(chart.names, ["volumes on", "volumes off"])
        self.assertEqual([chart.colour_number(p) for p in chart.points], [0, 1, 0, 1])
        self.assertEqual(chart.y.label(upright=True), "words  (↑ faster)")

    def test_a_chart_says_what_one_sees(self):
        self.assertEqual(said_by(three(says="Look.")), "Look.")
        self.assertEqual(said_by(three()), "Enough in the least time: b.")  # as fast as a within quartiles; below a step none is ranked
        self.assertEqual(said_by(three(x="flip_mean", y="time")), "Enough in the least time: b.")
        self.assertEqual(said_by(three(methods=["none", "same"])), "Smallest error: same.")
        points = [point(scene, "m", error, 1, {"n": n}) for scene, error, n in (("s", 0.01, 1), ("s", 0.2, 2), ("t", 0.3, 1), ("t", 0.2, 2))]
        self.assertEqual(said_by(Chart(study(points=points), {"name": "a"})),
                         "Enough in the least time: m 1 (in 1 of 2 panels). Smallest error where none is enough: m 2 (in 1 of 2 panels).")
        points = [point("s", "near", 0.1, 1), point("s", "light", 0.4, 1)]
        for p, reads in zip(points, (8, 2)):
            p["error"]["reads"] = reads
        of_work = Chart(study(points=points, metrics={"reads": "reads of a texture"}), {"name": "a", "x": "reads", "y": "flip_mean"})
        self.assertEqual(said_by(of_work), "Smallest error: near.")  # and not the least work
        of_work = Chart(study(points=points), {"name": "a", "x": "reads", "y": "flip_mean", "enough": {"at": 0.5, "text": "half"}})
        self.assertEqual(said_by(of_work), "Enough at the least reads: light.")


class Reading(unittest.TestCase):

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
    """Contents of each chart, before it is drawn."""

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

    def test_doubt_is_the_scenes_own(self):
        s = over_lights()
        self.assertEqual(s.doubling_change("10 lights", "flip_mean"), 0.001)
        self.assertIsNone(s.doubling_change("10 lights", "rmse"))
        self.assertEqual(study().doubling_change("bunny", "flip_mean"), 0.0005)
        self.assertIsNone(study().doubling_change("bunny", "rmse"))
        rule = charts_of(s)[5]
        self.assertEqual(chart_panel.lines_of(rule, rule.panels[0], rule.y), (0.0301, 0.01, True))
        self.assertEqual(chart_panel.lines_of(charts_of(s)[1], ["1 lights"], charts_of(s)[1].y), (None, None, False))

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
