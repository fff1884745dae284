"""Tests of the shards of ./course test, run --gallery and study, on the small course."""
# Builds: nothing

import json
import re
import sys

from small_course import Course

# Measures the study's request: an error by scene, a time, on the device that the file "device" names.
STUDY = f"""#!{sys.executable}
import json, os, sys
words = sys.argv[1:]
study = json.load(open(sys.argv[sys.argv.index("--study-file") + 1] if "--study-file" in sys.argv else "chapters/02_lambert/study.json"))
device = open("device").read() if os.path.exists("device") else "NVIDIA H200"
scenes = {{s["label"]: {{"file": s["scene"], "set": {{}}, "one_step": {{"rmse": 0.1}}, "doubling": {{"rmse": len(s["label"]) / 100}}}}
          for s in study["scenes"]}}
points = [{{"scene": label, "method": "a", "knobs": {{"k": k}}, "error": {{"rmse": 0.5 / k}}, "time_ms": {{"median": k}}}}
          for label in scenes for k in (1, 2)]
truth = {{"method": "b", "knobs": {{}}, "doubling_change": max(s["doubling"]["rmse"] for s in scenes.values())}}
made = {{"chapter": "02_lambert", "title": study["title"], "subject": "frame", "device": device, "driver": "1",
        "stage": "fragment", "size": [8, 8], "command": "./course study 02", "truth": truth, "error_metric": "rmse",
        "time_unit": "ms", "scenes": scenes, "points": points}}
if "charts" in study:
    made["charts"] = study["charts"]
json.dump(dict(sorted(made.items())), open(words[words.index("--study") + 1], "w"), indent=1)
"""
REQUEST = {"title": "Two", "truth": {}, "charts": [{"name": "main"}],
           "scenes": [{"scene": "x.obj", "label": label} for label in ("four", "one lamp", "ten thousand")]}


class Shards(Course):
    def test_tests(self):
        """Every test runs in one shard, and the report of the merge counts them all."""
        self.accept()
        whole = self.course("test")
        count = re.search(r"0 tests failed out of (\d+)", whole)[1]
        parts = [self.course("test", "--shard", f"{number}/3", "--out", self.outside / "tests") for number in (1, 2, 3)]
        counts = [int(re.search(r"0 tests failed out of (\d+)", part)[1]) for part in parts]
        self.assertEqual(sum(counts), int(count))
        self.assertLess(max(counts), int(count))
        self.assertEqual(len([part for part in parts if "shots.02" in part]), 1)
        (self.root / "build/shots/02_lambert/bunny.png").unlink()
        printed = self.course("test", "--merge", self.outside / "tests")
        self.assertTrue(printed.endswith(f"report: build/report/index.html\n100% tests passed, 0 tests failed out of {count}\n"), printed)
        self.assertTrue((self.root / "build/shots/02_lambert/bunny.png").exists())
        page = (self.root / "build/report/index.html").read_text()
        self.assertIn(f"{count} tests", page)
        (self.outside / "tests/test.2-of-3.zip").unlink()
        printed = self.course("test", "--merge", self.outside / "tests", code=1)
        self.assertRegex(printed, r"\Acourse: of 3 shards one is missing: 2; ./course test --out .*tests --shard 2/3 makes it\n\Z")

    def test_a_failure_in_a_shard_is_a_failure(self):
        self.accept()
        self.put("broken")
        for number in (1, 2):
            self.course("test", "unit", "--shard", f"{number}/2", "--out", self.outside / "red", code=None)
        self.assertIn("1 tests failed", self.course("test", "--merge", self.outside / "red", code=1))

    def test_gallery(self):
        """Merged shards are the page and the pictures of one run."""
        made = [self.root / "build/gallery" / name for name in ("index.html", "01_obj/bunny.png", "01_obj/car.png", "02_lambert/bunny.png")]
        self.course("run", "--gallery")
        whole = [path.read_bytes() for path in made]
        for path in made:
            path.unlink()
        for number in (1, 2):
            self.course("run", "--gallery", "--shard", f"{number}/2", "--out", self.outside / "gallery")
        self.course("run", "--gallery", "--merge", self.outside / "gallery")
        self.assertEqual([path.read_bytes() for path in made], whole)


class Study(Course):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        for name, text in (("programs/chapters/02_lambert", STUDY), ("chapters/02_lambert/study.json", json.dumps(REQUEST))):
            cls.write(name, text)

    def test_study(self):
        out = self.outside
        self.course("study", "02", "--out", out / "whole")
        for number in (1, 2, 3):
            self.course("study", "02", "--shard", f"{number}/3", "--out", out / "study")
        printed = self.course("study", "02", "--merge", out / "study", "--out", out / "merged")
        self.assertIn("3 scenes of 3 shards; all times of a chapter are of one machine: NVIDIA H200, 1\n", printed)
        name = "02_lambert.h200.json"
        whole, merged = (json.loads((out / folder / name).read_text()) for folder in ("whole", "merged"))
        self.assertEqual(merged, whole)
        self.assertEqual(merged["truth"]["doubling_change"], 0.12)
        self.put("device", "NVIDIA H100")
        self.course("study", "02", "--shard", "1/3", "--out", out / "study")
        self.course("study", "02", "--shard", "2/3", "--out", out / "study")
        printed = self.course("study", "02", "--merge", out / "study", "--out", out / "other", code=2)
        self.assertRegex(printed, r"\Acourse: 02_lambert was measured in study.\d-of-3.zip on NVIDIA H100, 1 and study.\d-of-3.zip on "
                                  r"NVIDIA H200, 1: times of two machines [^\n]*\n\Z")
        self.assertFalse((out / "other").exists())
