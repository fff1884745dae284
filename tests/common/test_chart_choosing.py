"""Studies as charts read them: refusals, tables, and the points of each curve."""
# Builds: nothing

import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "common" / "course"), str(ROOT / "tests" / "common")]

from charts import chart_limits  # noqa: E402
from chart_fixture import STUDY, over_lights, point, study  # noqa: E402
from charts.study_charts import charts_of  # noqa: E402
from charts.study_file import Study, StudyError, markdown_table  # noqa: E402
from charts.verdict import verdict_of  # noqa: E402


class Reading(unittest.TestCase):
    def test_front(self):
        front = [(p.method, p.time[1]) for p in verdict_of(study(), "bunny").front]
        self.assertEqual(front, [("gouraud", 0.1), ("phong", 0.2)])  # of what is enough the first alone
        tie = study(points=[point("s", "a", 1, 1), point("s", "b", 1, 1), point("s", "c", 1, 2), point("s", "d", 2, 1)])
        self.assertEqual([p.method for p in verdict_of(tie, "s").front], ["a", "b"])

    def test_throughput_is_faster_where_it_is_higher(self):
        points = [{"scene": "f", "method": m, "error": {"ulp": ulp}, "mb_per_s": {"median": v, "q1": v, "q3": v}}
                  for m, v, ulp in (("slow", 10, 0), ("fast", 800, 0), ("wrong", 900, 3))]
        loaders = study(subject="loader", time_unit="MB/s", error_metric="ulp", points=points)
        self.assertEqual([p.method for p in verdict_of(loaders, "f").front], ["wrong", "fast"])
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

    def test_the_front_needs_time_and_error(self):
        charts = self.charts()
        fronts = {name: [p.method for p in chart.front(chart.drawable)] for name, chart in charts.items()}
        self.assertEqual((fronts["lights"], fronts["threshold"], fronts["errors"]), ([], [], []))
        self.assertEqual(fronts["main"][-1], "culled")  # enough
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
        self.assertEqual(chart_limits.lines_of(rule, rule.panels[0], rule.y), (0.0301, 0.01, True))
        self.assertEqual(chart_limits.lines_of(charts_of(s)[1], ["1 lights"], charts_of(s)[1].y), (None, None, False))

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


if __name__ == "__main__":
    unittest.main()
