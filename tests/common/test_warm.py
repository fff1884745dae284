"""A program that has drawn other pictures draws the same as a cold start: at a later time, in another size, after an exercise
is toggled and after a shader is edited. test_knobs.py does the same for all knobs."""
import json
import os
import shutil
import unittest
from contextlib import ExitStack
from pathlib import Path
from unittest import mock

from folder_case import FolderCase
from picture_drawing import BUILD, BUILT, CHAPTERS, HAS_SOLUTION, ROOT, Drawer, Live, cheap, sets, steps, thing
from tree import exercises

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
HEAD = json.loads((ROOT / "assets/scenes/portrait.json").read_text())
HEAD["objects"][0]["motion"] = {"spin_deg_per_s": 40}
SCENES = {"holes": HOLES, "shade": SHADE, "shade_alone": SHADE_ALONE, "turning": TURNING, "head": HEAD}
PROJECTED = ["backdrop.ground=projected", "backdrop.ground_y=0", "shadow.method=none"]
# (chapter, scene, settings, the moving thing): drawn at 0.5 s, and by the frames from 0.25 s on.
MOVES = [("05", "holes", ["maps.scroll=0.3"]), ("05", "shade", ["visibility=rays", "maps.wobble=0.1"]),
         ("12", "head", []), ("13", "scenes/passing.json", ["mlaa.method=taa", "mlaa.taa.warm_up=6"]),
         ("14", "shade_alone", [*PROJECTED, "backdrop.shadow.resolution=64", "maps.scroll=0.3"]),
         ("14", "turning", [*PROJECTED, "backdrop.shadow.resolution=64"])]
# (chapter, scene, settings from the start, settings while it runs), where test_knobs.py draws a knob in another scene.
KNOBS = [("05", "shade", ["visibility=rays"], ["maps.opacity=off"]),
         ("14", "holes", PROJECTED, ["backdrop.shadow.resolution=8"]),
         ("14", "shade_alone", [*PROJECTED, "backdrop.shadow.resolution=64"], ["maps.opacity=off"]),
         ("14", "shade_alone", [*PROJECTED, "maps.coverage=averaged"], ["maps.cutoff=0"])]
# Words by which an exercise is used in cached results, in chapters whose own scene does not.
USED = {"14.importance_sample_ggx": sets("environment.method=prefiltered"), "16.correct_opacity": sets("volume.light=volume"),
        "17.overlay_normals": ["--shot", "mercury"], "18.id_buffer": ["--shot", "ids"],
        "19.centripetal_knots": ["--scene", "films/path_uneven.film", "--time", "0.8"],
        "19.arc_length": ["--scene", "films/path_uneven.film", "--time", "0.8", "--set", "method=arc_length"]}
# An exercise of an earlier chapter, on which what a scene is loaded with depends.
LOADED = "04.tangent_frame"
# Starters that leave texels unwritten: these show what the image held before.
UNWRITTEN = {"07.last_workgroup", "14.prefilter_faces"}
EDITS = 60
# (chapter, settings from the start, a shader, the replaced text and its replacement).
EDIT = ("14", ["environment.method=prefiltered"], "14_environment/solution/split_sum_table.glsl", "return ", "return 0.25 * ")


@unittest.skipUnless(BUILT and HAS_SOLUTION, "the chapters are not built, or there is no reference")
class Warm(FolderCase):
    def setUp(self):
        self.drawer, self.drawing = None, self.enterContext(ExitStack())
        for name, scene in SCENES.items():
            (self.folder / f"{name}.json").write_text(json.dumps(scene))

    def words(self, chapter: str, scene: str, settings: list) -> list[str]:
        file = str(self.folder / f"{scene}.json") if scene in SCENES else scene
        return (["--scene", file] if scene else []) + cheap(chapter) + sets(*settings)

    def cold(self, chapter: str, *options, size=SIZE) -> Path:
        """The picture of a chapter that has drawn no other: a drawer makes one for each."""
        if not self.drawer or not self.drawer.chapter.startswith(chapter):
            self.drawing.close()
            name = next(name for name in CHAPTERS if name.startswith(chapter))
            self.drawer = self.drawing.enter_context(Drawer(name, self.folder))
        picture, wrong = self.drawer.draw("--size", f"{size[0]}x{size[1]}", *options)
        self.assertEqual(wrong, "", f"{chapter} {options}")
        return picture.rename(self.folder / f"cold {len(list(self.folder.iterdir()))}.png")

    def live(self, live: Live, words: list, size=SIZE, **request) -> Path:
        picture, wrong = live.draw(words, size, **request)
        self.assertEqual(wrong, "", f"{live.chapter} {words} {request}")
        return picture

    def assert_cold(self, warm: Path, cold: Path):
        self.assertEqual(steps(warm, cold), 0, "it differs from the picture of a cold start")

    def assert_changed(self, before: Path, warm: Path, cold: Path):
        self.assert_cold(warm, cold)
        self.assertGreater(steps(before, cold), 0, "nothing has changed: this tries nothing")

    def test_a_time_come_to_by_frames(self):
        for chapter, scene, settings in MOVES:
            with self.subTest(chapter=chapter, settings=settings):
                words = self.words(chapter, scene, settings)
                at_once = self.cold(chapter, *words, "--time", "0.5")
                self.assertEqual(steps(self.cold(chapter, *words, "--time", "0.25", "--frames", "16"), at_once), 0)
                self.assertGreater(steps(self.cold(chapter, *words, "--time", "0.25"), at_once), 0, "nothing moves")

    def test_a_time_a_size_and_the_exercises(self):
        """Together, and alone those that bear on cached results."""
        for chapter in CHAPTERS:
            known = {*exercises(chapter), *([LOADED] if chapter[:2] in ("05", "12", "18") else [])} - UNWRITTEN
            together = ",".join(["solution", *(f"{name}=exercise" for name in sorted(known))])
            alone = [(f"solution,{name}=exercise", USED[name]) for name in sorted(known & USED.keys())]
            with Live(chapter, self.folder) as live:
                words, size = cheap(chapter), (64, 80)
                first = self.live(live, words)
                with self.subTest(chapter=chapter):
                    later = self.live(live, words, size, time_s=2)
                    self.assert_cold(later, self.cold(chapter, *words, "--time", "2", size=size))
                    self.assert_cold(self.live(live, words), first)
                with self.subTest(chapter=chapter, use=together):
                    self.assert_cold(self.live(live, words, use=together), self.cold(chapter, *words, "--use", together))
                for use, used_by in alone:
                    with self.subTest(chapter=chapter, use=use):
                        words = [*used_by, *cheap(chapter)]
                        before = self.live(live, words)
                        self.assert_changed(before, self.live(live, words, use=use), self.cold(chapter, *words, "--use", use))

    def test_a_knob(self):
        for chapter, scene, settings, change in KNOBS:
            name = next(name for name in CHAPTERS if name.startswith(chapter))
            with self.subTest(chapter=chapter, settings=settings, change=change), Live(name, self.folder) as live:
                words = self.words(chapter, scene, settings)
                before = self.live(live, words)
                warm = self.live(live, words, set=dict(one.split("=") for one in change))
                self.assert_changed(before, warm, self.cold(chapter, *words, *sets(*change)))

    def own_shaders(self) -> Path:
        """The folder of those that programs read from now on."""
        course = self.folder / "course"
        course.mkdir()
        shutil.copytree(ROOT / "shaders", course / "shaders")
        for name in ("assets", "chapters", "tests", "docs"):
            (course / name).symlink_to(ROOT / name)
        (course / "build").symlink_to(BUILD)
        self.enterContext(mock.patch.dict(os.environ, LIGHTWALK_ROOT=str(course)))
        return course / "shaders"

    def test_an_edit_of_a_shader(self):
        chapter, settings, shader, old, new = EDIT
        words, file = self.words(chapter, "", settings), self.own_shaders() / shader
        with Live(next(name for name in CHAPTERS if name.startswith(chapter)), self.folder) as live:
            before = self.live(live, words)
            text = file.read_text()
            self.assertIn(old, text)
            file.write_text(text.replace(old, new))
            os.utime(file, ns=(0, file.stat().st_mtime_ns + 10**9))
            self.assert_changed(before, self.live(live, words), self.cold(chapter, *words))

    def test_an_hour_of_edits_of_a_shader_leaves_nothing(self):
        """Neither pipelines in memory nor modules in the cache."""
        chapter = next(name for name in CHAPTERS if name.startswith("02"))
        cache, file = self.folder / "cache", self.own_shaders() / chapter / "solution/lambert.glsl"
        self.enterContext(mock.patch.dict(os.environ, LIGHTWALK_CACHE=str(cache)))
        text, pictures, kept, memory_kb = file.read_text(), set(), [], []
        with Live(chapter, self.folder) as live:
            for edit in range(EDITS):
                file.write_text(text.replace("max(", f"{1 - edit / EDITS} * max("))
                os.utime(file, ns=(0, file.stat().st_mtime_ns + edit * 10**9))
                pictures.add(self.live(live, cheap(chapter)).read_bytes())
                kept.append(len(list(cache.iterdir())))
                memory_kb.append(int(Path(f"/proc/{live.program.pid}/statm").read_text().split()[1]) * 4)
        print(f"{EDITS} edits: {kept[0]} to {kept[-1]} modules kept, {memory_kb[EDITS // 4]} to {memory_kb[-1]} kB of memory")
        self.assertEqual((len(pictures), kept[-1]), (EDITS, kept[0]))
        self.assertLess(memory_kb[-1], 1.05 * memory_kb[EDITS // 4])
