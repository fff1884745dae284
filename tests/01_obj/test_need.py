"""The need rule of chapter 01 on files it was not fitted on: what it picks reads every float within the budget, and is
near the fastest loader that does. The first is asserted; the second is reported, because it depends on the machine.
LIGHTWALK_BUILD names the build folder where it is not build/ in the tree.
"""
import json
import pathlib
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "common" / "course"))
from results import table  # noqa: E402
from tree import BUILD, chapter_program, say  # noqa: E402

FILES = ["cube", "head", "statue", "car"]
BUDGETS_ULP = [0, 1]


class NeedTest(unittest.TestCase):
    def run_chapter(self, *options) -> str:
        done = subprocess.run([str(word) for word in (chapter_program("01_obj"), *options)], cwd=ROOT,
                              capture_output=True, text=True, timeout=300)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout

    def chosen(self, model: pathlib.Path, budget: float, loads: int = 1) -> str:
        picture = BUILD / "needs" / "01_obj.png"
        picture.parent.mkdir(parents=True, exist_ok=True)
        said = self.run_chapter("--scene", model, "--loader", "auto", "--budget", budget, "--loads", loads, "--explain",
                                "--size", "64x36", "--screenshot", picture)
        return next(line for line in said.splitlines() if line.startswith("choice: loader=")).split("=")[1]

    def test_what_it_picks_is_within_the_budget(self):
        rows = []
        for name in FILES:
            model = ROOT / "assets" / "models" / f"{name}.obj"
            figures = {loader["loader"]: loader
                       for loader in json.loads(self.run_chapter("--load-bench", model, "--json"))["loaders"]}
            for budget in BUDGETS_ULP:
                picked = self.chosen(model, budget)
                within = {loader: f for loader, f in figures.items() if f["max_ulp"] <= budget}
                fastest = min(within, key=lambda loader: within[loader]["ms_median"])
                ratio = figures[picked]["ms_median"] / within[fastest]["ms_median"]
                rows.append({"case": f"{name}, budget {budget} ULP", "inputs": f"{len(figures)} loaders",
                             "worst": figures[picked]["max_ulp"], "bound": budget, "ok": picked in within,
                             "text": f"{picked}; {ratio:.2f}x the time of {fastest}"})
                say(f"{rows[-1]['case']:24} {rows[-1]['text']}")
        again = "build/chapters/01_obj --scene FILE --loader auto --budget E --explain --screenshot FILE"
        self.assertEqual(table("stability", "01_obj", "need", again, rows), [])

    def test_threads_are_for_large_files(self):
        models = ROOT / "assets" / "models"
        self.assertEqual(self.chosen(models / "cube.obj", 0, loads=1000), "scan")
        self.assertEqual(self.chosen(models / "bunny.obj", 0), "parallel")


if __name__ == "__main__":
    unittest.main()
