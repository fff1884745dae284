"""Tests of ./course study: making, measuring, keeping and writing."""
# Builds: nothing

import json
import os
import signal
import subprocess
import sys

from small_course import INTERRUPTIBLE, Course, until

from charts.study import device_slug

# Writes its arguments and folder; with a file "slow" at the root it leaves a part and then takes its time.
CHAPTER = f"""#!{sys.executable}
import json, os, sys, time
words = sys.argv[1:]
out = words[words.index("--study") + 1]
if os.path.exists("fails"):
    print("no such device", file=sys.stderr)
    sys.exit(int(open("fails").read() or 1))
went_on = os.path.exists(out + ".partial")
if os.path.exists("slow") and not went_on:
    open(out + ".partial", "w").write("some")
    time.sleep(60)
if went_on:
    os.remove(out + ".partial")
grid = "build/study/grid.obj"
charts = json.load(open("chapters/01_obj/study.json")).get("charts", [])
json.dump({{"subject": "frame", "device": "NVIDIA H200", "driver": "NVIDIA 570.86", "words": words, "went_on": went_on, "charts": charts,
           "grid": open(grid).read() if os.path.exists(grid) else None}}, open(out, "w"))
"""
MAKE_GRID = "import sys\nopen(sys.argv[2], 'w').write('grid ' + sys.argv[1])\nprint('made one')\n"
STUDY = {"generate": {"build/study/grid.obj": ["tests/01_obj/make_grid.py", "7"]}}


class Study(Course):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        for name, text in (("programs/chapters/01_obj", CHAPTER), ("tests/01_obj/make_grid.py", MAKE_GRID),
                           ("chapters/01_obj/study.json", json.dumps(STUDY))):
            cls.write(name, text)

    def result(self, name="docs/studies/01_obj.h200.json"):
        return json.loads((self.root / name).read_text())

    def test_measures_makes_what_is_missing_and_draws(self):
        (self.root / "build/study/grid.obj").unlink(missing_ok=True)
        printed = self.course("study")
        self.assertIn("making build/study/grid.obj\nmade one", printed)
        self.assertIn("docs/studies/01_obj.h200.json; docs/studies/01_obj.h200.svg", printed)
        self.assertEqual(self.result()["grid"], "grid 7")
        self.assertTrue((self.root / "docs/studies/01_obj.h200.svg").exists())
        self.assertNotIn("making", self.course("study", "01"))

    def test_device_and_folder(self):
        self.course("study", "01", "--device", "H200 NVL", "--out", "x", cwd=self.outside)
        words = self.result(self.outside / "x/01_obj.h200.json")["words"]
        self.assertEqual(words[2:], ["--device", "H200 NVL"])
        self.course("study", "01", "--size", "480x270")
        self.assertEqual(self.result()["words"][2:], ["--size", "480x270"])

    def test_every_chart_is_named(self):
        charts = [{"name": "main"}, {"name": "lights", "x": "knob lights", "y": "time"}]
        self.put("chapters/01_obj/study.json", json.dumps(STUDY | {"charts": charts}))
        printed = self.course("study", "01")
        self.assertIn("01_obj.h200.svg; build/charts/01_obj.h200.lights.svg\n", printed)

    def test_what_cannot_be_is_one_line(self):
        printed = self.course("study", "02", code=2)
        self.assertEqual(printed, "course: chapter 02_lambert has no study; there are 01_obj\n")
        printed = self.course("study", "01", "--size", "wide", code=2)
        self.assertEqual(printed, "course: --size is 'wide', expected WIDTHxHEIGHT, such as 1920x1080\n")
        self.put("chapters/01_obj/study.json", "{")
        self.assertIn("chapters/01_obj/study.json is not JSON", self.course("study", "01", code=1))

    def test_what_the_program_refuses_is_said_once(self):
        self.put("fails", "2")
        printed = self.course("study", "01", "--device", "nothing", code=2)
        self.assertTrue(printed.endswith("no such device\n"), printed)
        self.assertNotIn("course: ", printed)

    def test_a_failure_writes_nothing(self):
        self.put("fails")
        printed = self.course("study", "01", "--out", "none", code=1, cwd=self.outside)
        self.assertIn("no such device", printed)
        self.assertIn("nothing was finished that could be kept", printed)
        self.assertIn("the study of 01_obj ended with 1", printed)
        self.assertFalse((self.outside / "none").exists())
        self.put("tests/01_obj/make_grid.py", "raise SystemExit(3)")
        (self.root / "build/study/grid.obj").unlink(missing_ok=True)
        self.assertIn("make_grid.py could not make build/study/grid.obj", self.course("study", "01", code=1))

    def test_interrupted_it_goes_on_when_called_again(self):
        self.put("slow")
        partial = self.root / "build/study/01_obj.json.partial"
        clean = {name: value for name, value in os.environ.items() if name != "LIGHTWALK_BUILD"}
        course = subprocess.Popen([self.root / "course", "study", "01"], stdout=subprocess.PIPE, text=True,
                                  stderr=subprocess.STDOUT, env=clean, **INTERRUPTIBLE)
        until(partial.exists)
        os.killpg(course.pid, signal.SIGINT)
        printed, _ = course.communicate(timeout=60)
        self.assertEqual(course.returncode, 130, printed)
        self.assertIn("./course study 01 goes on from there", printed)
        self.assertIn("going on with the study of 01_obj", self.course("study", "01"))
        self.assertTrue(self.result()["went_on"])
        self.assertFalse(partial.exists())

    def test_names_of_devices(self):
        for study, name in (({"subject": "frame", "device": "llvmpipe (LLVM 15.0.6, 256 bits)"}, "lavapipe"),
                            ({"subject": "frame", "device": "NVIDIA GeForce RTX 4090"}, "rtx4090"),
                            ({"subject": "frame", "device": "AMD Radeon RX 7900 XTX (RADV NAVI31)"}, "rx7900xtx"),
                            ({"subject": "loader", "device": "EPYC", "stage": "2 threads"}, "cpu2"),
                            ({}, "device")):
            self.assertEqual(device_slug(study), name)
