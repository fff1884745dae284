"""The budgets in the lesson's table are those of the cheapest ways in docs/studies/film."""

import json
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
MEASURED = ROOT / "docs/studies/film"


class FilmLesson(unittest.TestCase):
    def test_the_study_over_budgets(self):
        sys.path.insert(0, str(ROOT / "common/course"))
        from pages.film_page import cheapest
        scenes = json.loads((MEASURED / "ways.h200.json").read_text())["scenes"]
        lines = (ROOT / "docs/19_ambiance.md").read_text().splitlines()
        budgets, counts, times = ([cell.strip() for cell in next(line for line in lines if line.startswith(head)).split("|")[2:-1]]
                                  for head in ("| budget, mean FLIP", "| scenes with a way", "| mean frame time"))
        whole = sum(scene["ways"][0]["gpu_ms"] for scene in scenes)
        for budget, count, time in zip(budgets, counts, times):
            chosen = [cheapest(scene, float(budget)) for scene in scenes]
            self.assertEqual(count, str(sum(way["error"] <= float(budget) for way in chosen)), budget)
            self.assertEqual(time, f"{sum(way['gpu_ms'] for way in chosen) / whole:.0%}", budget)


if __name__ == "__main__":
    unittest.main()
