"""A program that has drawn other pictures draws the same as a cold start: after a knob, a toggle or an edit of a shader,
and after frames up to the same time. Cached results must be remade."""
import io
import json
import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

from PIL import Image

from part_in_ci import part
from picture_drawing import BUILD, BUILT, CHAPTERS, HAS_SOLUTION, ROOT, Drawer, cheap, sets, steps, thing

SIZE = (97, 61)
# A sheet with holes above a floor, which casts their shadow.
HOLES = {
    "camera": {"position": [0, 2.2, 3.2], "target": [0, 0.3, 0], "fov_deg": 50, "near_m": 0.05, "far_m": 50},
    "environment": {"image": "environments/courtyard_1k.hdr"}, "ambient": [0.1, 0.1, 0.1],
    "objects": [
        thing("plane", [0, 0, 0], name="floor", scale=6, material={"diffuse": [0.8, 0.8, 0.8]}),
        thing("plane", [0, 0.8, 0], name="holes", scale=1.6,
              material={"diffuse": [0.6, 0.3, 0.3], "maps": {"opacity": "textures/squares.png"}})],
    "lights": [{"type": "directional", "direction": [0.3, -1, -0.2], "intensity": 1, "shadow": True, "size_deg": 0.5}]}
# The shadow of such a sheet, which is above the picture: on a floor, and on the ground of the surroundings' picture.
SHADE = HOLES | {"camera": HOLES["camera"] | {"position": [0, 0.6, 2.2], "target": [0, 0, 0], "fov_deg": 20}}
SHADE_ALONE = SHADE | {"objects": HOLES["objects"][1:]}
TURNING = SHADE_ALONE | {"objects": [HOLES["objects"][1] | {"motion": {"spin_deg_per_s": 40}}]}
SCENES = {"holes": HOLES, "shade": SHADE, "shade_alone": SHADE_ALONE, "turning": TURNING}
PROJECTED = ["backdrop.ground=projected", "backdrop.ground_y=0", "shadow.method=none"]
# (chapter, scene, settings from the start, the moving thing): drawn at 2 s, and by the frames from 1.75 s on.
MOVES = [("05", "holes", ["maps.scroll=0.3"]), ("05", "holes", ["maps.wobble=0.1"]),
         ("05", "shade", ["visibility=rays", "maps.scroll=0.3"]), ("05", "shade", ["visibility=rays", "maps.wobble=0.1"]),
         ("14", "shade_alone", [*PROJECTED, "backdrop.shadow.resolution=64", "maps.scroll=0.3"]),
         ("14", "turning", [*PROJECTED, "backdrop.shadow.resolution=64"])]
# (chapter, scene, settings from the start, settings while it runs).
KNOBS = [("05", "holes", ["maps.coverage=averaged"], ["maps.cutoff=1"]),
         ("05", "holes", [], ["maps.opacity=off"]),
         ("05", "holes", ["visibility=rays", "maps.coverage=averaged"], ["maps.cutoff=1"]),
         ("05", "shade", ["visibility=rays"], ["maps.opacity=off"]),
         ("14", "holes", PROJECTED, ["backdrop.shadow.resolution=8"]),
         ("14", "shade_alone", [*PROJECTED, "backdrop.shadow.resolution=64"], ["maps.opacity=off"]),
         ("14", "shade_alone", [*PROJECTED, "maps.coverage=averaged"], ["maps.cutoff=0"]),
         ("12", "", [], ["maps.normal=off"]),
         ("12", "", [], ["skin.sky_rays=16"])]
# (chapter, words from the start, an exercise used in cached results or histories).
TOGGLES = [("10", [], "10.density"), ("14", sets("environment.method=prefiltered"), "14.importance_sample_ggx"),
           ("15", sets("ground.detail_m=60"), "11.eroded_fbm"),
           ("16", sets("volume.light=volume"), "16.correct_opacity"),
           ("17", ["--shot", "mercury"], "17.overlay_normals"),
           ("18", ["--shot", "ids"], "18.id_buffer"),
           ("19", ["--scene", "films/path_uneven.film", "--time", "0.8"], "19.centripetal_knots"),
           ("19", ["--scene", "films/path_uneven.film", "--time", "0.8", "--set", "method=arc_length"], "19.arc_length")]
# (chapter, settings from the start, a shader, the replaced text and its replacement).
EDITS = [("14", ["environment.method=prefiltered"], "14_environment/solution/split_sum_table.glsl", "return ",
          "return 0.25 * "),
         ("16", ["volume.light=volume"], "16_volume/make_light.comp", "imageStore(result, at, vec4(",
          "imageStore(result, at, 0.25 * vec4(")]


@unittest.skipUnless(BUILT and HAS_SOLUTION, "the chapters are not built, or there is no reference")
class Warm(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)
        for name, scene in SCENES.items():
            (self.folder / f"{name}.json").write_text(json.dumps(scene))

    def words(self, chapter: str, scene: str, settings: list) -> list[str]:
        return (["--scene", str(self.folder / f"{scene}.json")] if scene else []) + cheap(chapter) + sets(*settings)

    def cold(self, chapter: str, *options) -> Path:
        """The picture of a program that has drawn no other."""
        name = next(name for name in CHAPTERS if name.startswith(chapter))
        with Drawer(name, self.folder) as drawer:
            picture, wrong = drawer.draw("--size", f"{SIZE[0]}x{SIZE[1]}", *options)
        self.assertEqual(wrong, "", f"{name} {options}")
        return picture.rename(self.folder / f"cold {len(list(self.folder.iterdir()))}.png")

    def live(self, chapter: str, words: list, requests: list, between=lambda: None) -> list[Path]:
        """The pictures of one program, asked for one after the other; `between` is called before the last."""
        name = next(name for name in CHAPTERS if name.startswith(chapter))
        pictures = []
        with subprocess.Popen([BUILD / "chapters" / name, "--pictures", "--validate", "on"], cwd=ROOT,
                              stdin=subprocess.PIPE, stdout=subprocess.PIPE) as program:
            for request in requests:
                if request is requests[-1]:
                    between()
                program.stdin.write(json.dumps({"words": words, "size": SIZE, "still": True} | request).encode() + b"\n")
                program.stdin.flush()
                answer = json.loads(program.stdout.readline())
                picture = program.stdout.read(answer["bytes"])
                self.assertEqual((answer["code"], answer["error"], answer["errors"]), (0, "", []), f"{name} {request}")
                pictures.append(self.folder / f"live {len(list(self.folder.iterdir()))}.png")
                Image.open(io.BytesIO(picture)).save(pictures[-1])
            program.stdin.close()
        return pictures

    def assert_cold(self, before: Path, warm: Path, cold: Path):
        self.assertEqual(steps(warm, cold), 0, "it differs from the picture of a cold start")
        self.assertGreater(steps(before, cold), 0, "nothing has changed: this tries nothing")

    def test_a_time_come_to_by_frames(self):
        for chapter, scene, settings in part(MOVES, 2):
            with self.subTest(chapter=chapter, settings=settings):
                words = self.words(chapter, scene, settings)
                at_once = self.cold(chapter, *words, "--time", "2")
                self.assertEqual(steps(self.cold(chapter, *words, "--time", "1.75", "--frames", "16"), at_once), 0)
                self.assertGreater(steps(self.cold(chapter, *words, "--time", "1.75"), at_once), 0, "nothing moves")

    def test_a_knob(self):
        for chapter, scene, settings, change in part(KNOBS, 3):
            with self.subTest(chapter=chapter, settings=settings, change=change):
                words = self.words(chapter, scene, settings)
                pictures = self.live(chapter, words, [{}, {"set": dict(one.split("=") for one in change)}])
                self.assert_cold(*pictures, self.cold(chapter, *words, *sets(*change)))

    def test_a_toggle(self):
        for chapter, given, exercise in part(TOGGLES, 2):
            with self.subTest(chapter=chapter, exercise=exercise):
                words, use = [*given, *cheap(chapter)], f"{exercise}=exercise"
                pictures = self.live(chapter, words, [{}, {"use": use}])
                self.assert_cold(*pictures, self.cold(chapter, *words, "--use", use))

    def test_an_edit_of_a_shader(self):
        for chapter, settings, shader, old, new in EDITS:
            with self.subTest(chapter=chapter, shader=shader):
                course = self.folder / f"course {chapter}"
                course.mkdir()
                shutil.copytree(ROOT / "shaders", course / "shaders")
                for name in ("assets", "chapters", "tests", "docs"):
                    (course / name).symlink_to(ROOT / name)
                (course / "build").symlink_to(BUILD)
                words, file = self.words(chapter, "", settings), course / "shaders" / shader
                text = file.read_text()
                self.assertIn(old, text)

                def edit():
                    file.write_text(text.replace(old, new))
                    os.utime(file, ns=(0, file.stat().st_mtime_ns + 10**9))

                os.environ["LIGHTWALK_ROOT"] = str(course)
                self.addCleanup(os.environ.pop, "LIGHTWALK_ROOT", None)
                pictures = self.live(chapter, words, [{}, {}], edit)
                self.assert_cold(*pictures, self.cold(chapter, *words))


if __name__ == "__main__":
    unittest.main()
