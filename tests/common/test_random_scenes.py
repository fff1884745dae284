"""A few random scenes, validated; random_scenes.py draws many."""
import json
import subprocess
import tempfile
import unittest
from pathlib import Path

from random_scenes import CHAPTERS, FILLINGS, SIZE, draw, random_scene, run
from shots.rendering import Drawing

FEW = 5


@unittest.skipUnless(CHAPTERS, "the chapters are not built")
class RandomScenes(unittest.TestCase):
    def test_the_same_seed_makes_the_same_scene(self):
        self.assertEqual(random_scene(7), random_scene(7))
        self.assertNotEqual(random_scene(7), random_scene(8))

    def test_no_chapter_has_anything_to_say(self):
        for seed in range(FEW):
            program = CHAPTERS[seed * len(CHAPTERS) // FEW]
            with self.subTest(program=program.name, seed=seed), tempfile.TemporaryDirectory() as folder:
                command, wrong = draw(program, seed, folder)
                self.assertEqual(wrong, "", " ".join(command))

    def test_what_they_have_found(self):
        """A finely cut surface with holes, which casts a shadow: its caster was drawn with the wrong vertex shader."""
        program = next((path for path in CHAPTERS if path.name.startswith("05_")), None)
        if not program:
            self.skipTest("there is no chapter 05")
        scene = {"objects": [{"model": "models/ground.obj", "material": {"maps": {
            "height": "textures/lava_height.png", "opacity": "textures/squares.png"}}}],
                 "lights": [{"type": "directional", "direction": [0.3, -1, 0.2], "shadow": True}]}
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "scene.json").write_text(json.dumps(scene))
            done = run(program, folder, "--scene", f"{folder}/scene.json", "--set", "maps.mesh=displaced", "--set",
                       "maps.subdivide=2")
            self.assertEqual((done.returncode, done.stderr), (0, ""))

    def drawn(self, chapter: str, *options) -> subprocess.CompletedProcess:
        program = next((path for path in CHAPTERS if path.name.startswith(chapter)), None)
        if not program:
            self.skipTest(f"there is no chapter {chapter}")
        with tempfile.TemporaryDirectory() as folder:
            return run(program, folder, *options)

    def test_a_map_that_only_one_of_two_layouts_has(self):
        done = self.drawn("12_", "--show", "occlusion")
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_a_chapter_draws_by_every_method_of_its_modules(self):
        """Forward shading agrees between a chapter with a G-buffer and the chapter of its objects."""
        done = self.drawn("09_", "--set", "gbuffer.method=forward")
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_rays_from_water_where_there_is_no_ground(self):
        """The reference of reflections is drawn for a scene of objects alone, too: a pool."""
        done = self.drawn("15_", "--scene", "scenes/pool.json", "--set", "water.reflection=rays")
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_a_refused_knob_is_one_line(self):
        done = self.drawn("08_", "--set", "bloom.method=window")
        self.assertEqual(done.returncode, 2)
        self.assertRegex(done.stderr, r"\Aerror: bloom\.\w+ [^\n]*\n\Z")

    def test_nothing_at_all(self):
        """Every view of a scene without objects: resources that were never made are not read."""
        views = {"08": ["picture", "cut_out", "spread", "level"],
                 "12": ["picture", "irradiance", "level", "stretch", "occlusion", "thickness"],
                 "13": ["picture", "edges"]}
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "scene.json").write_text('{"lights": [{"type": "directional", "shadow": true}]}')
            for program in CHAPTERS:
                drawn = {}  # by the view, in memory filled with NaN and with small numbers: as run() does, many views in a process
                for filling in FILLINGS:
                    with Drawing(program, MALLOC_PERTURB_=filling) as drawing:
                        for view in views.get(program.name[:2], [""]):
                            with self.subTest(program=program.name, view=view, filling=filling):
                                options = ["--scene", f"{folder}/scene.json", "--size", SIZE]
                                options += ["--set", f"show={view}"] if view else []
                                options += ["--world", "head"] if program.name[:2] == "13" else []
                                code, wrong, said = drawing.draw(options, Path(folder, "picture.png"))
                                said = [line for line in said.splitlines() if not line.startswith("drawing: ")]
                                self.assertEqual((code, wrong, said), (0, "", []))
                                picture = Path(folder, "picture.png").read_bytes()
                                self.assertEqual(drawn.setdefault(view, picture), picture)


if __name__ == "__main__":
    unittest.main()
