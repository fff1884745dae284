"""Charts of studies: what is drawn where, what is refused, and that the same study gives the same file."""

import contextlib
import copy
import hashlib
import io
import json
import math
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "common" / "course"))

import chart  # noqa: E402
from study_charts import charts_of  # noqa: E402
from study_file import Study, StudyError, load, markdown_table  # noqa: E402


def point(scene, method, error, ms, knobs=None, **more):
    return {"scene": scene, "method": method, "knobs": knobs or {},
            "error": {"flip_mean": error, "flip_p99": 0.5, "nan": 0, "inf": 0},
            "time_ms": {"median": ms, "q1": ms * 0.9, "q3": ms * 1.2, "rounds": 9}, **more}


STUDY = {
    "chapter": "02_lambert_phong", "title": "Reflection", "subject": "frame", "device": "NVIDIA H200",
    "driver": "570", "stage": "fragment", "command": "./course study 02", "error_metric": "flip_mean",
    "time_unit": "ms", "truth": {"method": "supersampled", "knobs": {"samples": 64}, "doubling_change": 0.0005},
    "points": [point("bunny", "gouraud", 0.05, 0.1), point("bunny", "phong", 0.02, 0.2, {"samples": 1, "bias": 2}),
               point("bunny", "phong", 0.004, 0.8, {"samples": 4, "bias": 2}), point("bunny", "slow", 0.03, 1.0),
               point("bunny", "exact", 0, 4.0), point("bunny", "broken", None, 0.15)],
}


def study(**changes):
    return Study(copy.deepcopy(STUDY) | changes)


class Reading(unittest.TestCase):
    def test_front(self):
        front = [(p.method, p.time[1]) for p in study().front("bunny")]
        self.assertEqual(front, [("gouraud", 0.1), ("phong", 0.2), ("phong", 0.8), ("exact", 4.0)])
        tie = study(points=[point("s", "a", 1, 1), point("s", "b", 1, 1), point("s", "c", 1, 2), point("s", "d", 2, 1)])
        self.assertEqual([p.method for p in tie.front("s")], ["a", "b"])

    def test_throughput_is_faster_where_it_is_higher(self):
        points = [{"scene": "f", "method": m, "error": {"ulp": ulp}, "mb_per_s": {"median": v, "q1": v, "q3": v}}
                  for m, v, ulp in (("slow", 10, 0), ("fast", 800, 0), ("wrong", 900, 3))]
        loaders = study(subject="loader", time_unit="MB/s", error_metric="ulp", points=points)
        self.assertEqual([p.method for p in loaders.front("f")], ["wrong", "fast"])
        self.assertFalse(loaders.software)

    def test_software_times_are_labelled(self):
        self.assertEqual(study().time_label, "GPU time, ms")
        for names in ({"device": "llvmpipe (LLVM 15.0.6, 256 bits)"}, {"driver": "llvmpipe"}):
            self.assertEqual(study(**names).time_label, "CPU time (software rasteriser), ms")

    def test_knob_labels_name_only_what_varies(self):
        one = charts_of(study())[0]
        labels = [one.label_of(p) for p in one.points[:3]]
        self.assertEqual(labels, ["", "1", "4"])

    def test_one_step(self):
        self.assertEqual(study(one_step={"flip_mean": 0.02}).one_step("bunny", "flip_mean"), (0.02, True))
        self.assertEqual(study().one_step("bunny", "rmse"), (0.00367, False))
        self.assertEqual(study().one_step("bunny", "ulp"), (None, False))
        of_scenes = study(scenes={"a": {"one_step": {"flip_mean": 0.03}}, "b": {"one_step": {"flip_mean": 0.04}}})
        self.assertEqual([of_scenes.one_step(scene, "flip_mean")[0] for scene in "ab"], [0.03, 0.04])
        self.assertEqual(of_scenes.one_step("a", "hit_texels"), (None, False))

    def test_refused(self):
        for changes, why in (({"points": []}, "no points"), ({"subject": "film"}, "film"), ({"time_unit": "s"}, '"s"'),
                             ({"error_metric": "beauty"}, "beauty"), ({"points": [{"scene": "x"}]}, "without"),
                             ({"points": [point("s", "a", 1, 1, device="llvmpipe")]}, "never share an axis")):
            with self.subTest(why), self.assertRaisesRegex(StudyError, why):
                study(**changes)
        without = {key: value for key, value in STUDY.items() if key != "driver"}
        with self.assertRaisesRegex(StudyError, "driver"):
            Study(without)

    def test_table(self):
        lines = markdown_table(study()).splitlines()
        self.assertEqual(len(lines), 2 + 6 + 2)
        self.assertIn("GPU ms (median)", lines[0])
        self.assertTrue(lines[2].startswith("| ● | bunny | gouraud |"))
        self.assertTrue(lines[5].startswith("|  | bunny | slow |"))
        self.assertIn("NaN", lines[7])
        self.assertEqual({line.count("|") for line in lines[:8]}, {11})


class Drawing(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)

    def figure(self, s, which=0):
        with chart.plt.rc_context(chart.STYLE):
            figure = chart.build_figure(charts_of(s)[which])
            figure.canvas.draw()
        self.addCleanup(chart.plt.close, figure)
        return figure

    def texts(self, figure):
        found = [text.get_text() for text in figure.texts]
        for axis in figure.axes:
            found += [text.get_text() for text in axis.texts] + [axis.get_xlabel(), axis.get_ylabel()]
        return found

    def test_it_says_what_it_is(self):
        texts = self.texts(self.figure(study()))
        for text in ("Reflection", "NVIDIA H200 · 570 · fragment", "./course study 02", "GPU time, ms",
                     "error: FLIP, mean", "gouraud", "phong", "slow", "exact", "one 8-bit step at mid grey",
                     "Pareto front"):
            self.assertIn(text, texts)
        self.assertTrue(any("Not drawn: broken" in text for text in texts))
        self.assertNotIn("broken", texts)

    def test_axes(self):
        main, zero = self.figure(study()).axes
        self.assertEqual((main.get_xscale(), main.get_yscale()), ("log", "log"))
        self.assertEqual(main.get_xlim(), zero.get_xlim())
        self.assertEqual([label.get_text() for label in zero.get_yticklabels()], ["0"])
        only_exact = self.figure(study(points=[point("s", "exact", 0, 1)]))
        self.assertEqual(len(only_exact.axes), 1)

    def test_panels_share_their_axes(self):
        points = [point(scene, "m", e, t) for scene, e, t in (("a", 0.1, 1), ("b", 0.01, 5), ("c", 0.5, 2))]
        figure = self.figure(study(points=points))
        self.assertEqual(len(figure.axes), 3)
        self.assertEqual(len({(axis.get_xlim(), axis.get_ylim()) for axis in figure.axes}), 1)

    def test_labels_cover_neither_each_other_nor_a_point(self):
        points = [point("s", f"method_{i}", 0.02 * 0.98**i * (j + 1), 0.3 * 1.005**i * (j + 1), {"n": j})
                  for i in range(6) for j in range(2)]
        s = study(points=points)
        figure = self.figure(s)
        renderer = figure.canvas.get_renderer()
        boxes = [t.get_window_extent(renderer) for t in figure.axes[0].texts if t.get_text().startswith("method_")]
        self.assertEqual(len(boxes), 6)
        for i, a in enumerate(boxes):
            for b in boxes[i + 1:]:
                self.assertFalse(a.overlaps(b))
        at = [figure.axes[0].transData.transform((p.time[1], p.error)) for p in s.points]
        self.assertFalse(any(box.contains(*pixel) for box in boxes for pixel in at))

    def test_the_same_study_gives_the_same_files(self):
        path = self.folder / "reflection.json"
        path.write_text(json.dumps(STUDY))
        seen = set()
        for name in ("first", "second"):
            out = self.folder / name
            subprocess.run([sys.executable, ROOT / "common/course/chart.py", path, "--out", out], check=True)
            files = sorted(out.iterdir())
            self.assertEqual([f.name for f in files], ["reflection.md", "reflection.png", "reflection.svg"])
            seen.add(tuple(hashlib.sha256(f.read_bytes()).hexdigest() for f in files))
        self.assertEqual(len(seen), 1)

    def test_bad_input_is_one_line_and_exit_code_2(self):
        torn, empty, unfinished = (self.folder / name for name in ("torn.json", "empty.json", "nan.json"))
        torn.write_text("{")
        empty.write_text("{}")
        unfinished.write_text(json.dumps(STUDY | {"points": [point("s", "a", math.nan, 1)]}))
        for path in (torn, empty, unfinished, self.folder / "missing.json", self.folder):
            with self.subTest(path.name), contextlib.redirect_stderr(io.StringIO()) as said:
                self.assertEqual(chart.main([str(path), "--out", str(self.folder / "o")]), 2)
                self.assertEqual(said.getvalue().count("\n"), 1)
                self.assertIn("chart: ", said.getvalue())
        self.assertFalse((self.folder / "o").exists())

    def test_loading(self):
        with self.assertRaisesRegex(StudyError, "missing.json: cannot be read"):
            load(self.folder / "missing.json")


if __name__ == "__main__":
    unittest.main()
