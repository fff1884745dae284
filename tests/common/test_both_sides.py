"""Each branch by device, both ways on one device: the same pictures to the byte, with validation silent (docs/devices.md)."""
# Builds: 07_mipmaps 09_post_effects 11_fractals
import json
import subprocess
import unittest

from folder_case import FolderCase
from picture_drawing import BUILD, BUILT, HAS_SOLUTION, ROOT, Drawing

# Auto exposure carries a history, the hall has mips of many sizes, and the fractals' loops end by uniforms of several blocks.
SHOTS = {"07_mipmaps": ["hall", "normals_level"], "09_post_effects": ["film", "all_together"], "11_fractals": ["reef", "sunset"]}
SIDES = ("software", "hardware")


@unittest.skipUnless(BUILT and HAS_SOLUTION, "the chapters are not built, or there is no reference")
class BothSides(FolderCase):
    def run_program(self, chapter: str, *options):
        done = subprocess.run([BUILD / "chapters" / chapter, "--validate", "on", *map(str, options)], cwd=ROOT, text=True,
                              capture_output=True, stdin=subprocess.DEVNULL, timeout=300)
        self.assertEqual(done.returncode, 0, done.stderr)

    def drawn(self, chapter: str, *options) -> bytes:
        picture = self.folder / "picture.png"
        self.run_program(chapter, "--size", "192x108", *options, "--screenshot", picture)
        return picture.read_bytes()

    def test_pictures_are_equal(self):
        for chapter, shots in SHOTS.items():
            pictures = {}
            for side in SIDES:
                with Drawing(chapter) as drawing:
                    drawing.command += ["--device-paths", side]
                    for shot in shots:
                        picture = self.folder / f"{shot}.png"
                        code, wrong, _ = drawing.draw(["--shot", shot, "--size", "192x108"], picture)
                        self.assertEqual(code, 0, wrong)
                        pictures[side, shot] = picture.read_bytes()
            for shot in shots:
                with self.subTest(chapter=chapter, shot=shot):
                    self.assertEqual(*(pictures[side, shot] for side in SIDES))

    def test_timed_pictures_are_equal(self):
        """Between timed frames a load keeps a GPU's clock up."""
        for chapter in list(SHOTS)[:2]:
            with self.subTest(chapter=chapter):
                times = self.folder / "times.json"
                pictures = [self.drawn(chapter, "--shot", SHOTS[chapter][0], "--frames", "3", "--timings", times, "--device-paths", side)
                            for side in SIDES]
                self.assertEqual(*pictures)
                self.assertGreater(json.loads(times.read_text())["recording_in_a_row_cpu_ms"], 0)

    def test_a_study_has_equal_errors(self):
        """A second frame of each point is timed on hardware, not compared."""
        study, found = self.folder / "study.json", self.folder / "found.json"
        study.write_text(json.dumps({
            "title": "levels", "error_metric": "flip_mean", "stage": "all", "size": [96, 54], "rounds": 1,
            "truth": {"set": {"method": "none", "samples": 4}, "exact": True},
            "scenes": ["assets/scenes/checker_plain.json"], "curves": [{"method": "box"}, {"method": "single_pass"}]}))
        errors = []
        for side in SIDES:
            self.run_program("07_mipmaps", "--study", found, "--study-file", study, "--device-paths", side)
            errors.append([(point["method"], point["error"]) for point in json.loads(found.read_text())["points"]])
        self.assertEqual(*errors)
