"""A chart's notes on its points, and a method's added time."""
# Builds: nothing

import sys
import unittest
from pathlib import Path

sys.path[:0] = [str(Path(__file__).parent), str(Path(__file__).resolve().parents[2] / "common" / "course")]

from chart_fixture import point, study  # noqa: E402
from charts.said import between, said_by  # noqa: E402
from charts.study_charts import Chart  # noqa: E402
from charts.study_file import StudyError  # noqa: E402


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
        self.assertEqual(said_by(Chart(study(points=points), {"name": "a", "x": "knob size", "x_label": "size: in texels"})),
                         "From size 256 to 1,024 the error falls to 25%.")

    def test_names_say_which_switch_and_leave_out_the_one_method(self):
        points = [point(str(n), "m", 0.1 * n, n, {"n": n, "volumes": on}) for n in (1, 2) for on in ("on", "off")]
        scenes = {str(n): {"set": {"n": n}} for n in (1, 2)}
        chart = Chart(study(points=points, scenes=scenes), {"name": "a", "x": "knob n", "y": "time", "y_label": "words  (↑ faster)"})
        self.assertEqual(chart.names, ["volumes on", "volumes off"])
        self.assertEqual([chart.colour_number(p) for p in chart.points], [0, 1, 0, 1])
        self.assertEqual(chart.y.label(upright=True), "words  (↑ faster)")

    def test_a_chart_says_what_one_sees(self):
        self.assertEqual(said_by(three(says="Look.")), "Look.")
        # b's error is smaller than a's, and both are below an 8-bit step: their order is not seen.
        self.assertEqual(said_by(three()), "Enough in the least time: a.")


if __name__ == "__main__":
    unittest.main()
