"""./course test --device, on the software driver: its verdicts, page and file of figures, and the limits of hardware."""
# Builds: 01_obj 02_lambert_phong check_02_lambert_phong compare

import argparse
import contextlib
import io
import json
import subprocess
from unittest import mock

from PIL import Image, ImageOps

from folder_case import FolderCase
from shots import accept, golden
from test import device
from tree import UsageError, chapters, exercises, shots

CHAPTER, SHOT = "02_lambert_phong", "02.teapot"
H200 = {"name": "NVIDIA H200", "type": "discrete", "driver": "NVIDIA 580.159.04", "lacks": ""}
LLVMPIPE = {"name": "llvmpipe (LLVM 15.0.6, 256 bits)", "type": "software", "driver": "llvmpipe Mesa 22.3.6", "lacks": ""}


class DeviceCase(FolderCase):
    def setUp(self):
        self.file = self.folder / "device.json"
        self.replace("test.device.BUILD", self.folder)

    def replace(self, name, value):
        self.enterContext(mock.patch(name, value))

    def run_device(self, shots=SHOT, name="llvmpipe", against=None):
        """(exit code, what was printed)."""
        said = io.StringIO()
        with contextlib.redirect_stdout(said):
            code = device.run(argparse.Namespace(device=name, shots=shots, against=against, out=self.file), [], make=lambda _: None)
        return code, said.getvalue()

    def made(self):
        return json.loads(self.file.read_text())

    def page(self):
        return (self.folder / "report" / "device.html").read_text()


class OnLlvmpipe(DeviceCase):
    def test_a_chapter_is_within_its_limits_and_its_checks_are_right(self):
        code, said = self.run_device("02")
        self.assertEqual(code, 0, said)
        made, count, checks = self.made(), len(shots(CHAPTER)), len(exercises(CHAPTER))
        self.assertEqual((made["within"], made["of"], made["type"]), (count, count, "software"))
        self.assertEqual(made["checks"], {"right": checks, "of": checks, "wrong": []})
        self.assertEqual(set(made["shots"]), {f"02.{shot['name']}" for shot in shots(CHAPTER)})
        self.assertRegex(made["date"], r"^\d{4}-\d\d-\d\d$")
        self.assertIn(f"{made['device']}, {made['driver']}: {count} of {count} shots within limits\n", said)
        self.assertIn(f"checks: {checks} of {checks} exercises", said)
        means = [shot["flip_mean"] for shot in made["shots"].values()]
        self.assertEqual(means, sorted(means, reverse=True))
        places = [self.page().index(f'id="{name}"') for name in made["shots"]]
        self.assertEqual(places, sorted(places))
        self.assertNotIn(">outside<", self.page())

    def test_a_damaged_golden_or_a_wrong_picture_is_outside(self):
        damaged, torn = self.folder / "damaged.png", self.folder / "torn.png"
        with Image.open(golden.golden_path(CHAPTER, "teapot")) as picture:
            picture = picture.convert("RGB")
            picture.paste(ImageOps.invert(picture.crop((400, 200, 560, 340))), (400, 200))
            picture.save(damaged)
        torn.write_bytes(damaged.read_bytes()[:1000])
        starter = ("teapot", CHAPTER, ["--shot", "teapot", "--use", "exercise"], None)
        refused = ("teapot", CHAPTER, ["--shot", "kettle"], None)
        for name, value, why in (("golden_path", lambda *_: damaged, "flip_mean is"), ("golden_path", lambda *_: torn, "torn.png"),
                                 ("golden_path", lambda *_: self.folder / "none.png", "there is no "),
                                 ("right_picture", lambda *_: starter, "flip_mean is"), ("right_picture", lambda *_: refused, "unknown shot 'kettle'")):
            with self.subTest(why), mock.patch(f"test.device.{name}", value):
                code, said = self.run_device()
                self.assertEqual(code, 1, said)
                self.assertIn("0 of 1 shots within limits", said)
                self.assertRegex(said, rf"  {SHOT}: .*{why}")
                self.assertFalse(self.made()["shots"][SHOT]["ok"])
                self.assertIn(">outside<", self.page())

    def test_against_an_earlier_run(self):
        self.assertEqual(self.run_device()[0], 0)
        before, earlier = self.folder / "before.json", self.made()
        before.write_text(json.dumps(earlier))
        self.assertIn(": 0 of 1 shots moved\n", self.run_device(against=before)[1])
        moved = earlier["shots"][SHOT] | {"flip_mean": 0.1234, "ok": False}
        before.write_text(json.dumps(earlier | {"driver": "an older one", "shots": {SHOT: moved}}))
        code, said = self.run_device(against=before)
        self.assertEqual(code, 0)
        self.assertIn("(an older one, ", said)
        self.assertRegex(said, rf": 1 of 1 shots moved\n  {SHOT}: FLIP mean 0.1234, .* -> FLIP mean 0.0.*; now within\n")
        self.assertIn("FLIP mean 0.1234", self.page())
        before.write_text(json.dumps(earlier | {"shots": {SHOT: earlier["shots"][SHOT] | {"step_p999": 9}}}))
        self.assertRegex(self.run_device(against=before)[1], rf": 1 of 1 shots moved\n  {SHOT}: .* 9 -> .*\nreport")
        before.write_text(json.dumps(earlier | {"shots": {}}))
        self.assertIn(f": 0 of 0 shots moved\n  not in that run: {SHOT}\n", self.run_device(against=before)[1])

    def test_a_file_of_another_device_and_broken_ones_are_one_line(self):
        self.run_device()
        before, earlier = self.folder / "before.json", self.made()
        short = {SHOT: {"ok": True, "flip_mean": 0.1}}
        for text, why in ((json.dumps(earlier | {"device": "NVIDIA H200"}), "is a run of NVIDIA H200, not of llvmpipe"),
                          ("{", "is not a file of figures"), ("[]", "is not a file of figures"), ("[" * 100000, "is not a file of figures"),
                          (json.dumps({"device": "x"}), "kind"), (json.dumps(earlier | {"shots": 3}), "is not a file of figures"),
                          (json.dumps(earlier | {"shots": short}), "flip_p99"),
                          (json.dumps(earlier | {"shots": {SHOT: 1}}), "is not a file of figures"), (None, "No such file")):
            before.unlink(missing_ok=True)
            if text is not None:
                before.write_text(text)
            with self.subTest(why):
                with self.assertRaisesRegex(UsageError, why) as raised:
                    self.run_device(against=before)
                self.assertNotIn("\n", str(raised.exception))

    def test_an_unknown_device_is_refused_and_the_devices_are_named(self):
        with self.assertRaisesRegex(UsageError, r"\A--device Voodoo: no usable device of that name; there are: llvmpipe [^\n]*\Z"):
            self.run_device(name="Voodoo")


class Choices(DeviceCase):
    def test_which_device_a_name_chooses(self):
        weak = H200 | {"name": "Old card", "lacks": "dynamicRendering"}
        done = subprocess.CompletedProcess([], 0, json.dumps([weak, H200, LLVMPIPE]), "")
        self.replace("test.device.run_program", lambda *_: done)
        for wanted, found in (("h200", H200), ("hardware", H200), ("LLVM", LLVMPIPE), ("software", LLVMPIPE)):
            self.assertEqual(device.find_device(CHAPTER, wanted), found, wanted)
        with self.assertRaisesRegex(UsageError, r"Old card \(discrete, lacks dynamicRendering\), NVIDIA H200 \(discrete\), llvmpipe"):
            device.find_device(CHAPTER, "old card")

    def test_a_reference_that_fails_and_a_starter_that_passes_are_wrong(self):
        names, asked = list(exercises(CHAPTER)), []
        wrong = [{"case": names[0], "ok": False, "text": "gave 1"}, {"case": names[1], "ok": False, "text": "the starter passes"}]
        self.replace("test.device.check_rows", lambda chapter, **more: asked.append(more) or [{"case": name, "ok": True} for name in names] + wrong)
        found = device.check_results(H200, [CHAPTER])
        self.assertEqual((found["right"], found["of"], asked), (len(names) - 2, len(names), [{"LIGHTWALK_DEVICE": "NVIDIA H200"}]))
        made = {"device": "x", "driver": "y", "within": 1, "of": 1, "checks": found, "shots": {SHOT: {"ok": True}}}
        self.assertEqual(device.summary(made)[-2:], [f"  {names[0]}: gave 1", f"  {names[1]}: the starter passes"])

    def test_checks_that_are_wrong_are_1(self):
        self.replace("test.device.check_results", lambda *_: {"right": 0, "of": 1, "wrong": ["02.phong: the starter passes"]})
        self.assertEqual(self.run_device()[0], 1)


class Limits(DeviceCase):
    def test_one_pixel_in_a_thousand_says_nothing(self):
        expected, actual = self.folder / "expected.png", self.folder / "actual.png"
        picture = Image.new("RGB", (100, 20))
        picture.save(expected)
        for steps, common in (((200, 200), 0), ((200, 200, 30), 30), ((200, 100, 100), 100)):
            for x, step in enumerate(steps):
                picture.putpixel((x, 3), (0, step, 0))
            picture.save(actual)
            self.assertEqual(device.common_step(expected, actual), common, steps)

    def test_each_wider_limit_is_needed_and_has_its_cause(self):
        for chapter in chapters():
            for shot in shots(chapter):
                for name, figures in golden.hardware_distances(chapter, shot["name"]).items():
                    more = {key: value for key, value in figures.items() if key != "cause"}
                    with self.subTest(f"{chapter}.{shot['name']}"):
                        self.assertGreater(len(figures["cause"].split()), 3)
                        self.assertTrue(more)
                        self.assertTrue(all(value > golden.HARDWARE_LIMITS[key] for key, value in more.items()), more)
                        limits, causes = golden.hardware_limits(chapter, shot["name"], name)
                        self.assertEqual(causes, [figures["cause"]])
                        for key, limit in golden.HARDWARE_LIMITS.items():
                            self.assertEqual(limits[key], golden.HARDWARE_MARGIN * more[key] if key in more else limit)
                        self.assertEqual(golden.hardware_limits(chapter, shot["name"], "another"), (golden.HARDWARE_LIMITS, []))
                        self.assertNotIn(name, golden.measured_distances(chapter)[shot["name"]])

    def test_hardware_is_judged_by_its_own_limits(self):
        """A silhouette's texel that differs by 200 steps is outside on a software device alone."""
        metrics = {"flip": {"mean": 0.009, "p99": 0.055}, "max_diff": {"steps": 200, "x": 1, "y": 2}, "nearly_constant": {"test": False},
                   "nan": {"test": 0}, "inf": {"test": 0}}
        self.replace("test.device.compared", lambda *_: dict(metrics))
        shot, picture = shots(CHAPTER)[0], self.folder / "x.png"
        for common, of, within in ((32, H200, True), (33, H200, False), (32, LLVMPIPE, False)):
            self.replace("test.device.common_step", lambda *_, common=common: common)
            found = device.judge(of, CHAPTER, shot, picture, "")
            self.assertEqual(found["ok"], within, found["why"])

    def test_accept_keeps_the_causes(self):
        path, wrong = self.folder / "distances.json", {"NVIDIA H200": {"flip_p99": 0.1479, "cause": "a comparison at equality"}}
        path.write_text(json.dumps({"wrong": wrong | {"avx": {"flip_mean": 0, "flip_p99": 0, "max_diff": 0}}}))
        self.replace("shots.golden.distances_path", lambda _: path)
        self.replace("shots.accept.distances_path", lambda _: path)
        measured = {"flip_mean": 0.001, "flip_p99": 0.01, "max_diff": 3}
        accept.keep_distances({("05_shadow_maps", "wrong"): {"avx": measured}})
        self.assertEqual(json.loads(path.read_text()), {"wrong": wrong | {"avx": measured}})
        self.assertEqual(golden.limits_of("05_shadow_maps", "wrong"), {"flip_mean": 0.003, "flip_p99": 0.05, "max_diff": 64})
