#!/usr/bin/env python3
"""A scene built in the editor from nothing, by mouse and keys: environment, two models, four lamps, terrain, water with
rings, fog, bloom and anti-aliasing. It is saved, and opened by five chapters and by the film. Under Xvfb, validated."""
# Builds: 18_playground 04_surface_maps 05_shadow_maps 06_deferred 14_environment 15_terrain_water 19_ambiance
import json
import re
import subprocess
import time
import unittest
from pathlib import Path

from editor_case import BUILD, ROOT, EditorTest
from window_case import read_png

MINUTES = 5  # of scripted input, waiting for pictures included
SIZE = (240, 135)
MODELS = (("statue.obj", "statue", ("-0.45", "0.3", "0")), ("teapot.obj", "teapot", ("0.5", "0.1", "0.2")))
KNOBS = {"air": "sky", "ground.plain_m": "-0.7", "water.method": "gerstner", "water.level_m": "-0.1",
         "water.waterline.method": "rings", "fog.method": "height", "fog.density": "0.0004", "bloom.method": "pyramid",
         "mlaa.method": "mlaa"}
# What a chapter says it lacks.
FORWARD = {"air", "water", "fog", "ground", "jacksboro_dem.png"}
OTHERS = {"04_surface_maps": FORWARD, "05_shadow_maps": FORWARD, "06_deferred": FORWARD, "14_environment": FORWARD,
          "15_terrain_water": {"air", "mlaa"}}
LEAST_SHARED = 0.9  # of the pixels where a chapter shows the models
MOST_CODES = 2  # between the editor and the film


class Built(EditorTest):
    size = (480, 700)
    built = {"objects": []}

    def choose(self, entry: str, knob: str, option: str):
        """A knob of the scene's entry, from its list."""
        self.session.tap("entry." + entry)
        self.scroll_to("knob." + knob)
        self.session.tap("knob." + knob)
        self.session.tap(f"option.{knob}.{option}")
        self.session.read_all()

    def type_knob(self, entry: str, knob: str, text: str):
        self.session.tap("entry." + entry)
        self.scroll_to("knob." + knob)
        self.open_number(*self.session.places["knob." + knob])
        self.session.replace(text)

    def type_numbers(self, label: str, *numbers: str):
        left, _, right, _ = self.session.areas["numbers." + label]
        for i, text in enumerate(numbers):
            self.open_number(left + (right - left) * (2 * i + 1) / 6, self.session.places["numbers." + label][1])
            self.session.replace(text)

    def pick(self, entry: str, file: str):
        self.session.tap("entry." + entry)
        self.session.tap("pick." + entry)
        self.session.tap("file." + file)
        self.session.read_all()

    def add_model(self, file: str):
        since = self.session.said()
        self.session.key("ctrl+o")
        self.session.tap("tool.models")
        self.session.tap("field.file filter")
        self.session.type(file)
        first_row = 262  # it stands there once the filter has been read
        self.session.wait(lambda: self.session.areas.get("file." + file, (0, first_row))[1] < first_row, "the filtered list")
        self.session.tap("file." + file)
        self.session.wait_for_line(r"added " + re.escape(file), since)
        self.session.read_all()

    def build(self):
        session = self.session
        session.tap("entry.camera")
        self.type_numbers("position", "0.4", "0.9", "3.2")
        self.type_numbers("target", "0", "0.45", "0")
        session.tap("tool.go there")
        self.pick("environment", "sunset_1k.hdr")
        for file, name, place in MODELS:
            self.add_model(file)
            session.tap("entry." + name)
            self.type_numbers("position", *place)
        x, y = self.middle()
        for dx, dy in ((-90, -60), (90, -60), (-80, 40), (80, 40)):
            session.move(x + dx, y + dy)
            session.key("shift+2")
            session.read_all()
        session.park()
        self.choose("effects", "bloom.method", "pyramid")
        self.choose("effects", "mlaa.method", "mlaa")
        self.pick("terrain", "jacksboro_dem.png")
        self.type_knob("terrain", "ground.plain_m", KNOBS["ground.plain_m"])
        self.type_knob("fog", "fog.density", KNOBS["fog.density"])
        self.choose("fog", "fog.method", "height")
        self.type_knob("water", "water.level_m", KNOBS["water.level_m"])
        self.choose("water", "water.waterline.method", "rings")
        self.choose("water", "water.method", "gerstner")

    def test_a_scene_is_built_from_nothing_and_others_show_it_alike(self):
        begin = time.monotonic()
        self.build()
        scene = self.saved()
        took_s = time.monotonic() - begin
        print(f"built in {took_s:.0f} s", flush=True)
        self.assertLess(took_s, 60 * MINUTES)
        self.assertEqual([one["name"] for one in scene["objects"]], ["statue", "teapot", "ground"])
        self.assertEqual(len(scene["lights"]), 4)
        self.assertEqual(scene["environment"]["image"], "environments/sunset_1k.hdr")
        saved = {name: scene["knobs"].get(name) for name in KNOBS}
        self.assertEqual(saved | {"fog.density": str(float(saved["fog.density"]))}, KNOBS)
        self.leave()

        self.assertEqual(self.draw("18_playground")[1], "")
        film = self.folder / "built.film"
        film.write_text(json.dumps({"duration_s": 1, "knobs": {"smoothed": 1}, "scenes": [
            {"name": "built", "kind": "workbench", "scene": str(self.scene), "from_s": 0, "to_s": 1}]}))
        plain = [self.draw(chapter, scene, "--set", "mlaa.method=none")[0]  # the film smooths edges after its titles
                 for chapter, scene in (("18_playground", self.scene), ("19_ambiance", film))]
        self.assertLessEqual(max(abs(a - b) for a, b in zip(*plain)), MOST_CODES)
        models = self.models_in("18_playground")
        for chapter, lacks in OTHERS.items():
            with self.subTest(chapter=chapter):
                words = re.search(r"this chapter lacks (.*) of chapter 18_playground; left out", self.draw(chapter)[1])
                self.assertLessEqual(lacks, set(words[1].split(", ")))
                theirs = self.models_in(chapter)
                self.assertGreater(len(theirs), 1000)
                self.assertGreater(len(theirs & models) / len(theirs), LEAST_SHARED)

    def draw(self, chapter: str, scene: Path | None = None, *words: str) -> tuple[bytes, str]:
        """Its picture, and what it says."""
        file = self.folder / f"{chapter}.png"
        done = subprocess.run([BUILD / "chapters" / chapter, "--scene", scene or self.scene, "--size",
                               "{}x{}".format(*SIZE), "--screenshot", file, *words], cwd=ROOT, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, chapter + done.stderr)
        return read_png(file)[2], done.stderr.strip()

    def models_in(self, chapter: str) -> set[int]:
        """Pixels that the models change, by their number: shadows and reflections included."""
        scene = json.loads(self.scene.read_text())
        scene["objects"] = scene["objects"][2:]
        without = self.folder / "without.json"
        without.write_text(json.dumps(scene))
        one, other = (self.draw(chapter, file)[0] for file in (self.scene, without))
        return {i // 3 for i, (a, b) in enumerate(zip(one, other)) if abs(a - b) > 4}


if __name__ == "__main__":
    unittest.main()
