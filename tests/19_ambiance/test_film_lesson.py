"""The lesson's table of each scene's cost matches the measured benchmarks, docs/studies/film."""

import json
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
MEASURED = ROOT / "docs/studies/film"


def rows() -> dict[str, list[str]]:
    """The table's cells by scene: llvmpipe's seconds, processor, cut; the GPU's ms, 99th percentile, anti-aliasing, cut."""
    text = (ROOT / "docs/19_ambiance.md").read_text()
    table = text[text.index("## Deeper: the cost of each scene"):text.index("*Cut: the longest")]
    lines = [[cell.strip() for cell in line.strip("|").split("|")] for line in table.splitlines() if line.startswith("| ")]
    return {cells[0]: cells[1:] for cells in lines[1:]}


def cut_to(name: str, measured: dict) -> str:
    found = [cut for cut in measured["cuts"] if cut["to"] == name]
    return f"{found[0]['longest_ms'] / found[0]['mean_ms']:.2f}" if found else "–"


class FilmLesson(unittest.TestCase):
    def compare(self, file: str, columns: slice, cells):
        path = MEASURED / file
        if not path.exists():
            self.skipTest(f"{path.name} is not measured")
        measured, table = json.loads(path.read_text()), rows()
        self.assertEqual(list(table), [scene["name"] for scene in measured["scenes"]])
        for scene in measured["scenes"]:
            off, on = scene["antialiasing"]["none"], scene["antialiasing"]["mlaa"]
            self.assertEqual(table[scene["name"]][columns], cells(off, on, cut_to(scene["name"], measured)), scene["name"])

    def test_llvmpipe(self):
        self.compare("benchmark.lavapipe.json", slice(0, 3),
                     lambda off, on, cut: [f"{on['mean_ms'] / 1000:.2f}", f"{on['processor_ms']:.1f}", cut])

    def test_a_gpu(self):
        self.compare("benchmark.h200.json", slice(3, 7),
                     lambda off, on, cut: [f"{on['mean_ms']:.2f}", f"{on['p99_ms']:.2f}", f"{on['mean_ms'] - off['mean_ms']:.2f}", cut])

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
