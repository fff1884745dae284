"""The budgets that the lesson quotes follow from the film's ways in docs/studies/film."""

import json
import unittest

from pages.film_page import within_budgets
from tree import ROOT

MEASURED = ROOT / "docs/studies/film"


class FilmLesson(unittest.TestCase):
    def test_the_quoted_budgets_are_those_of_the_ways(self):
        for device in ("h200", "lavapipe"):
            ways = json.loads((MEASURED / f"ways.{device}.json").read_text())
            self.assertEqual(json.loads((MEASURED / f"ways.{device}.budgets.json").read_text()), within_budgets(ways), device)
