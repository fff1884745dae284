"""The need rule of chapter 01, by measuring: its choice reads every float within the budget, and takes about as long as
the fastest such loader. LIGHTWALK_BUILD names the build folder, by default build/ in the tree."""
import json
import statistics
import subprocess

from folder_case import FolderCase
from test.results import table
from tree import BUILD, ROOT, chapter_program, say

FILES = ["cube", "head", "statue", "car"]
BUDGETS_ULP = [0, 1]
MOST = 1.5  # times the fastest's time, in the median: two measurements of times that two threads share with others


class NeedTest(FolderCase):
    def run_chapter(self, *options) -> str:
        done = subprocess.run([str(word) for word in (chapter_program("01_obj"), *options)], cwd=ROOT,
                              capture_output=True, text=True, timeout=300)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout

    def explained(self, scene, budget: float, *options) -> str:
        picture = BUILD / "needs" / "01_obj.png"
        picture.parent.mkdir(parents=True, exist_ok=True)
        return self.run_chapter("--scene", scene, "--loader", "auto", "--budget", budget, "--explain", *options,
                                "--size", "64x36", "--screenshot", picture)

    def studied(self) -> list:
        """Every loader's rate and error on every file."""
        request, result = self.folder / "request.json", self.folder / "result.json"
        request.write_text(json.dumps({"title": "", "rounds": 5, "scenes": [f"assets/models/{name}.obj" for name in FILES]}))
        self.run_chapter("--study", result, "--study-file", request)
        return json.loads(result.read_text())["points"]

    def test_what_it_picks_is_within_the_budget_and_fast(self):
        rows, ratios, points = [], [], self.studied()
        for name in FILES:
            model = ROOT / "assets" / "models" / f"{name}.obj"
            figures = {one["method"]: (one["error"]["ulp"], one["mb_per_s"]["median"]) for one in points if one["scene"] == name}
            for budget in BUDGETS_ULP:
                said = json.loads(self.explained(model, budget, "--json"))
                picked = said["choice"]["method"]
                self.assertFalse(said["none_would_do"])
                self.assertEqual({c["method"]: c["error"] for c in said["candidates"]},
                                 {loader: ulp for loader, (ulp, _) in figures.items()})
                within = {loader: rate for loader, (ulp, rate) in figures.items() if ulp <= budget}
                fastest = max(within, key=within.get)
                ratios.append(within[fastest] / figures[picked][1])
                rows.append({"case": f"{name}, budget {budget} ULP", "inputs": f"{len(figures)} loaders",
                             "worst": figures[picked][0], "bound": budget, "ok": picked in within,
                             "text": f"{picked}; {ratios[-1]:.2f}x the time of {fastest}"})
                say(f"{rows[-1]['case']:24} {rows[-1]['text']}")
        again = "build/chapters/01_obj --scene FILE --loader auto --budget E --explain --screenshot FILE"
        self.assertEqual(table("stability", "01_obj", "need", again, rows), [])
        self.assertLessEqual(statistics.median(ratios), MOST)

    def test_threads_win_on_large_files(self):
        models = ROOT / "assets" / "models"
        self.assertEqual(json.loads(self.explained(models / "bunny.obj", 0, "--json"))["choice"]["method"], "parallel")

    def test_in_words_it_ends_with_the_options_to_type(self):
        last = self.explained(ROOT / "assets" / "models" / "cube.obj", 0).splitlines()[-1]
        self.assertRegex(last, r"^choice: --loader (textbook|scan|parallel|tinyobjloader)$")

    def test_a_scene_of_other_files_has_nothing_to_choose(self):
        said = json.loads(self.explained(ROOT / "assets/models/suzanne_family.glb", 0, "--json"))
        self.assertEqual((said["candidates"], said["choice"]["method"], said["none_would_do"]), ([], "textbook", False))
