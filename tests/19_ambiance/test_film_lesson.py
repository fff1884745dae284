"""The budgets that the lesson quotes follow from the film's ways in docs/studies/film."""

import json
import unittest

from pages.film_page import cheapest, within_budgets
from tree import ROOT

MEASURED = ROOT / "docs/studies/film"


class FilmLesson(unittest.TestCase):
    def test_the_quoted_budgets_are_those_of_the_ways(self):
        for device in ("h200", "lavapipe"):
            ways = json.loads((MEASURED / f"ways.{device}.json").read_text())
            self.assertEqual(json.loads((MEASURED / f"ways.{device}.budgets.json").read_text()), within_budgets(ways), device)

    def test_the_cheapest_way_within_a_budget(self):
        ways = [{"error": 0.01, "gpu_ms": 5}, {"error": 0.02, "gpu_ms": 3}, {"error": 0.02, "gpu_ms": 2}, {"error": 0.05, "gpu_ms": 1}]
        for budget, cost in ((0.009, 5), (0.01, 5), (0.02, 2), (0.049, 2), (0.05, 1)):
            self.assertEqual(cheapest({"ways": ways}, budget)["gpu_ms"], cost, budget)
        film = {"device": "d", "driver": "e", "size": [1, 1], "scenes": [{"ways": ways}, {"ways": ways[:1]}]}
        found = {point["method"]: point for point in within_budgets(film)["points"]}
        self.assertEqual((found["0.01"]["within"], found["0.01"]["share"]), (2, 1.0))
        self.assertEqual((found["0.05"]["within"], found["0.05"]["share"]), (2, 0.6))
