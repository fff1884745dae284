"""Pictures of chapter 07 that must agree with others, or differ by a known amount; how much they flicker; its bench."""
import json

from pictures import ROOT, ChapterPictures


class PicturesTest(ChapterPictures):
    chapter = "07_mipmaps"

    def test_levels_take_most_of_the_flicker_away(self):
        asked = {"title": "flicker", "error_metric": "flicker", "stage": "all", "size": [128, 72], "rounds": 1,
                 "truth": {"set": {"method": "none", "samples": 16}, "exact": True},
                 "metrics": {"flicker": "flicker"}, "scenes": ["assets/scenes/checker_plain.json"],
                 "curves": [{"method": "none"}, {"method": "box"}, {"method": "single_pass"}, {"method": "kaiser"}]}
        file, out = self.folder / "asked.json", self.folder / "found.json"
        file.write_text(json.dumps(asked))
        self.run_program("--study", out, "--study-file", file, silent=False)
        flicker = {point["method"]: point["error"]["flicker"] for point in json.loads(out.read_text())["points"]}
        for method in ("box", "single_pass", "kaiser"):
            self.assertLess(flicker[method], 0.75 * flicker["none"], flicker)

    def test_without_textures_every_method_draws_the_same(self):
        scene = ROOT / "tests" / "07_mipmaps" / "scenes" / "no_textures.json"
        pictures = {self.draw(scene, "--method", method, size="80x45").read_bytes() for method in ("none", "blit", "single_pass")}
        self.assertEqual(len(pictures), 1)
        self.draw(scene, "--show", "level", size="80x45")

    def test_the_bench_writes_a_study(self):
        out = self.folder / "bench.json"
        self.run_program("--mip-bench", out, "--size", "64x64", "--study-rounds", "1", silent=False)
        points = {(point["scene"], point["method"]): point["error"] for point in json.loads(out.read_text())["points"]
                  if "level" not in point["knobs"]}
        odd = "city lights, 1366x683, sRGB"
        self.assertLess(points[odd, "polyphase"]["level_rmse"], 0.5 * points[odd, "single_pass"]["level_rmse"])
        even = "noise, 1024x1024, RGBA16F"
        self.assertLess(points[even, "single_pass"]["level_rmse"], points[even, "box"]["level_rmse"])
        self.assertLess(points["normals, 512x512, RGBA8", "box"]["level_rmse"],
                        0.1 * points["normals, 512x512, RGBA8", "blit"]["level_rmse"])
