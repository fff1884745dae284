"""Verdicts on constructed studies with known answers."""
# Builds: nothing

import json
import re
import unittest

from chart_fixture import point, study
from charts.study_charts import charts_of
from charts.verdict import AS_FAST, Verdict, names_of, verdict_of
from tree import ROOT


class P:
    """A point with one error, "e", or two."""

    def __init__(self, name, ms, error, spread=0.0):
        self.method, self.knobs, self.time = name, {}, (ms - spread, ms, ms + spread)
        self.error = error if isinstance(error, tuple) else (error,)

    def __repr__(self):
        return self.method


def verdict(*points, limits=(0.03,), doubts=(0.0,), **more):
    metrics = "ef"[:len(limits)]
    return Verdict(points, dict(zip(metrics, limits)), dict(zip(metrics, doubts)), lambda p, m: p.error["ef".index(m)], **more)


class Verdicts(unittest.TestCase):
    def test_nothing_below_the_limit_is_ranked(self):
        fast, fine = P("fast", 1, 0.02), P("fine", 2, 0.001)
        v = verdict(fast, fine)
        self.assertEqual((v.front, v.cheapest, v.dominated), ([fast], fast, [fine]))
        self.assertFalse(v.more_accurate(fine, fast))

    def test_what_is_slower_and_worse_is_dominated(self):
        a, b, c, d = P("a", 1, 0.2), P("b", 2, 0.1), P("c", 3, 0.15), P("d", 9, 0.0)
        v = verdict(a, b, c, d)
        self.assertEqual((v.front, v.dominated, v.dominator(c), v.choice), ([a, b, d], [c], b, d))

    def test_times_differ_beyond_both_quartiles_and_by_two_percent(self):
        wide, slow = P("wide", 1.0, 0.2, 0.3), P("slow", 1.2, 0.2, 0.1)
        self.assertTrue(verdict(wide, slow).same(wide, slow))
        exact, near, far = P("exact", 1, 0.2), P("near", 1.019, 0.2), P("far", 1.021, 0.2)
        self.assertTrue(verdict(exact, near).same(exact, near))
        self.assertEqual(verdict(exact, near, far).dominated, [far])

    def test_errors_differ_beyond_the_truths_doubt(self):
        a, b = P("a", 1, 0.10), P("b", 2, 0.08)
        self.assertEqual(verdict(a, b, doubts=(0.03,)).dominated, [b])
        self.assertEqual(verdict(a, b, doubts=(0.01,)).dominated, [])

    def test_what_is_enough_is_never_dominated_by_what_is_not(self):
        almost, enough = P("almost", 1, 0.031), P("enough", 2, 0.03)
        v = verdict(almost, enough, doubts=(0.01,))
        self.assertEqual((v.choice, v.dominated), (enough, []))

    def test_every_metric_has_to_be_enough(self):
        few_pixels, even = P("few", 1, (0.01, 0.5)), P("even", 2, (0.02, 0.02))
        v = verdict(few_pixels, even, limits=(0.03, 0.05), doubts=(0, 0))
        self.assertEqual((v.enough, v.front), ([even], [few_pixels, even]))
        crossed = verdict(P("a", 1, (0.1, 0.4)), P("b", 2, (0.2, 0.3)), limits=(0.03, 0.05), doubts=(0, 0))
        self.assertEqual(crossed.dominated, [])

    def test_where_none_is_enough_the_most_accurate_is_taken(self):
        a, b, c = P("a", 1, 0.5), P("b", 2, 0.2), P("c", 5, 0.19)
        self.assertEqual((verdict(a, b, c).cheapest, verdict(a, b, c).choice), (None, c))
        self.assertEqual(verdict(a, b, c, doubts=(0.02,)).choice, b)  # c is not known to be better

    def test_the_choice_is_not_dominated(self):
        drift = [P("a", 1, 0.066), P("b", 2, 0.058), P("c", 3, 0.05)]
        v = verdict(*drift, doubts=(0.01,))
        self.assertNotIn(v.choice, v.dominated)

    def test_throughputs(self):
        slow, fast, wrong = P("slow", 10, 0), P("fast", 800, 0), P("wrong", 900, 3)
        v = verdict(slow, fast, wrong, limits=(0,), higher_is_faster=True)
        self.assertEqual((v.cheapest, v.front, v.dominated), (fast, [wrong, fast], [slow]))

    def test_points_without_a_time_or_an_error_are_left_out(self):
        good = P("good", 1, 0.5)
        self.assertEqual(verdict(good, P("nan", 2, float("nan")), P("late", float("inf"), 0)).points, [good])
        self.assertIsNone(verdict().choice)

    def test_it_chooses_as_the_need_rule_does(self):
        for case in json.loads((ROOT / "tests/common/data/cheapest.json").read_text()):
            with self.subTest(case["name"]):
                points = [P(str(i), ms, error) for i, (error, ms) in enumerate(case["points"])]
                self.assertIs(verdict(*points, limits=(case["limit"],)).choice, points[case["choice"]])
        rule = (ROOT / "common/study/cheapest.h").read_text()
        self.assertEqual(float(re.search(r"as_fast = ([\d.]+)", rule)[1]), 1 + AS_FAST)

    def test_of_a_study(self):
        scene = {"bunny": {"one_step": {"flip_mean": 0.025, "flip_p99": 0.03}, "doubling": {"flip_mean": 0.001}}}
        v = verdict_of(study(scenes=scene), "bunny")
        self.assertEqual((v.limits, v.doubts["flip_mean"]), ({"flip_mean": 0.025, "flip_p99": 0.03}, 0.001))
        self.assertEqual(v.choice.time[1], 0.2)
        self.assertEqual(names_of(v.points)[id(v.choice)], "phong, samples 1")
        chart = charts_of(study(scenes=scene))[0]
        self.assertEqual(chart.enough_of(chart.points).time, v.choice.time)

    def test_a_knob_alone_is_named_by_its_value(self):
        points = study(points=[point("s", "rays", 1, 1, {"water.reflection": r}) for r in ("cube", "planar")]).points
        self.assertEqual(list(names_of(points).values()), ["cube", "planar"])
