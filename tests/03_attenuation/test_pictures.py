"""Pictures of chapter 03: all methods of culling agree to the last bit, and pixels match double precision."""
import json
import math
import os
import pathlib
import shutil
import sys
import unittest

from PIL import Image

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "common"))
from pictures import ROOT, ChapterPictures, to_code  # noqa: E402

METHODS = ("every_light", "per_object", "tiled", "clustered")
FLOOR = {"model": "models/plane.obj", "scale": 20,
         "material": {"diffuse": [0.5, 0.4, 0.3], "specular": [0, 0, 0], "shininess": 1}}
DOWN = {"position": [0, 6, 0], "target": [0, 0, 0], "up": [0, 0, -1], "fov_deg": 60, "near_m": 0.1, "far_m": 50}
ALONG = {"position": [0, 1, 9], "target": [0, 0.5, 0], "fov_deg": 50, "near_m": 0.01, "far_m": 1e9}


def point(x, y, z, **keys):
    return {"type": "point", "position": [x, y, z], "intensity": 1, "range_m": 3, **keys}


def spot(x, y, z, **keys):
    return {"type": "spot", "position": [x, y, z], "direction": [0, -1, 0], "intensity": 1, "range_m": 9,
            "inner_deg": 10, "outer_deg": 20, **keys}


class PicturesTest(ChapterPictures):
    chapter = "03_attenuation"

    def scene(self, name, lights, camera=ALONG, objects=(FLOOR,), **keys):
        path = self.folder / f"{name}.json"
        path.write_text(json.dumps({"camera": camera, "objects": list(objects), "lights": lights,
                                    "ambient": [0, 0, 0], "background": [0, 0, 0], **keys}))
        return path

    def draw(self, scene, *options, size=(64, 48), **environment):
        """Rows of (r, g, b) codes."""
        picture = self.folder / "picture.png"
        self.run_program("--scene", scene, *options, "--size", f"{size[0]}x{size[1]}", "--screenshot", picture,
                         **environment)
        image = Image.open(picture).convert("RGB").load()
        return [[image[x, y] for x in range(size[0])] for y in range(size[1])]

    def errors(self, scenes, size):
        """{(label, method): errors} of a study of these, with pictures compared before rounding to codes."""
        root = self.folder / "root"
        if not root.exists():
            (root / "chapters" / "03_attenuation").mkdir(parents=True)
            (root / "assets").symlink_to(ROOT / "assets")
            shutil.copytree(ROOT / "shaders", root / "shaders")
        (root / "chapters" / "03_attenuation" / "study.json").write_text(json.dumps({
            "title": "equality", "error_metric": "max", "stage": "fragment", "rounds": 1,
            "truth": {"set": {"method": "every_light"}, "exact": True},
            "scenes": [{"scene": str(file), "set": sets, "label": label} for label, file, sets in scenes],
            "curves": [{"method": method} for method in METHODS[1:]]}))
        out = self.folder / "study.json"
        self.run_program("--study", out, "--size", f"{size[0]}x{size[1]}", silent=False, LIGHTWALK_ROOT=str(root),
                         LIGHTWALK_CACHE=os.environ.get("LIGHTWALK_CACHE", str(ROOT / "build" / "shader_cache")))
        return {(p["scene"], p["method"]): p["error"] for p in json.loads(out.read_text())["points"]}

    def places(self):
        """Scenes that are hard for culling. Lights are bright, so that the last of a window shows in the sum."""
        ball = {"model": "models/sphere.obj", "position": [0.7, 0.6, 5], "scale": 1.2}
        post = {"model": "models/cube.obj", "position": [-1, 1.5, 7.5], "scale": [0.2, 3, 0.2]}
        ring = [point(2.5 * math.cos(i), 0.3 + 0.1 * (i % 5), 3 + 4 * math.sin(i), intensity=1e4, range_m=0.3 + 0.1 * i)
                for i in range(40)]
        cones = [spot(0.7 * i - 6, 2, 0.5 * i - 4, intensity=1e4, inner_deg=7 * i, outer_deg=min(9 * i, 180),
                      direction=[math.sin(i), math.cos(1.7 * i), math.cos(i)], softness=i / 19) for i in range(20)]
        sun = {"type": "directional", "direction": [0.3, -1, 0.2], "intensity": 0.1}
        things = [FLOOR, ball, post]
        yield "lights before, behind and at a depth gap", self.scene("gap", ring + [sun] + cones, objects=things), {}
        yield "range fade", self.scene("fade", cones + ring, objects=things), {"falloff": "range_fade"}
        yield "the camera in every light", self.scene("inside", [point(0.1, 1.2, 9, range_m=30, intensity=1e5),
                                                                 spot(0, 1, 9, direction=[0, -0.2, -1], range_m=40),
                                                                 spot(0, 1, 12, outer_deg=180, range_m=40)]), {}
        yield "one slice", self.scene("one", ring + cones, objects=things), {"slices": 1}
        yield "200 slices", self.scene("slices", ring + cones, objects=things), {"slices": 200}
        yield "from above", self.scene("above", ring + cones, camera=DOWN, objects=things), {}
        yield "2,500 lights", self.scene("crowd", [sun], objects=things), {"lights": 2500}
        yield "sun alone", self.scene("sun", [sun]), {}
        yield "no light", self.scene("none", []), {}
        yield "nothing to see", self.scene("nothing", ring, objects=[FLOOR | {"position": [0, -50, 40]}]), {}

    def test_culling_changes_no_bit_where_a_falloff_ends(self):
        scenes = list(self.places())
        for size in ((203, 151), (16, 16), (1, 1)):
            for (label, method), error in self.errors(scenes, size).items():
                with self.subTest(label=label, method=method, size=size):
                    self.assertEqual((error["max"], error["nan"], error["inf"]), (0, 0, 0))

    def test_an_endless_falloff_is_wrong_by_no_more_than_lights_times_threshold(self):
        """200 lights on one spot, which the floor just misses: culling loses them all, and nearly the bound."""
        count, threshold = 200, 0.004
        radius = math.sqrt(1 / threshold)
        scene = self.scene("far", [point(0, radius * 1.01, 0) for _ in range(count)], camera=DOWN)
        sets = {"falloff": "inverse_square", "threshold": threshold}
        for (label, method), error in self.errors([("just missed", scene, sets)], (32, 24)).items():
            self.assertLess(error["max"], 0.5 * count * threshold)  # of a diffuse colour of at most 0.5
            self.assertGreater(error["max"], 0.97 * 0.5 * count * threshold)
        near = self.scene("near", [point(0, radius * 0.5, 0) for _ in range(count)], camera=DOWN)
        for error in self.errors([("reached", near, sets)], (32, 24)).values():
            self.assertEqual(error["max"], 0)

    def floor_pixels(self, size):
        """(x, y, the floor's point under the pixel) for the camera DOWN."""
        half = 6 * math.tan(math.radians(30))
        for y in range(size[1]):
            for x in range(size[0]):
                yield x, y, ((2 * (x + 0.5) / size[0] - 1) * half * size[0] / size[1], 0,
                             (2 * (y + 0.5) / size[1] - 1) * half)

    def expect(self, lights, radiance, *options):
        """Every pixel of the floor against `radiance(point)` times its colour, in steps of 1/255."""
        size = (64, 48)
        got = self.draw(self.scene("floor", lights, camera=DOWN), *options, size=size)
        brightest = 0
        for x, y, place in self.floor_pixels(size):
            arriving = radiance(place)
            for c in range(3):
                want = to_code(FLOOR["material"]["diffuse"][c] * arriving[c])
                self.assertLess(abs(got[y][x][c] - want), 1.3, (x, y, c, options))
                brightest = max(brightest, want)
        self.assertGreater(brightest, 100)

    def test_a_point_light_s_falloff(self):
        lamp, color, strength, reach, k = (0.7, 1.5, -0.4), (1, 0.8, 0.3), 2.5, 3.2, 0.6
        falloffs = {
            "range_fade": lambda d: (1 - d / reach) ** 2 / (1 + k * d * d) if d < reach else 0,
            "inverse_square_window": lambda d: (1 - (d / reach) ** 4) ** 2 / (d * d + 1) if d < reach else 0,
            "inverse_square": lambda d: 1 / (d * d)}
        for name, falloff in falloffs.items():
            def radiance(place, falloff=falloff):
                d = math.dist(place, lamp)
                return [c * strength * falloff(d) * lamp[1] / d for c in color]
            lights = [point(*lamp, color=color, intensity=strength, range_m=reach)]
            self.expect(lights, radiance, "--falloff", name, "--fade_k", k, "--threshold", 1e-6)

    def test_a_spot_light_s_cone(self):
        lamp, inner, outer, softness, axis = (-0.5, 2, 0.3), 15, 40, 0.7, (0.3, -1, 0.1)
        length = math.hypot(*axis)

        def radiance(place):
            way = [a - b for a, b in zip(place, lamp)]
            d = math.hypot(*way)
            cosine = sum(a * b for a, b in zip(way, axis)) / d / length
            low, high = math.cos(math.radians(outer)), math.cos(math.radians(inner))
            t = min(max((cosine - low) / (high - low), 0), 1)
            return [5 * t ** (1 - 0.65 * softness) * (1 - (d / 9) ** 4) ** 2 / (d * d + 1) * lamp[1] / d] * 3
        self.expect([spot(*lamp, intensity=5, direction=axis, inner_deg=inner, outer_deg=outer, softness=softness)],
                    radiance)

    def test_directional_lights_add_up_with_the_others(self):
        lamp = (0, 2, 0)

        def radiance(place):
            d = math.dist(place, lamp)
            arriving = (1 - (d / 3) ** 4) ** 2 / (d * d + 1) * 2 / d if d < 3 else 0
            return [0.4 + arriving, 0.2 + arriving, arriving]
        suns = [{"type": "directional", "direction": [0, -1, 0], "color": [1, 0, 0], "intensity": 0.4},
                {"type": "directional", "direction": [0, -1, 0], "color": [0, 1, 0], "intensity": 0.2}]
        for method in METHODS:
            self.expect([suns[0], point(*lamp), suns[1]], radiance, "--method", method)

    def test_lights_in_the_worst_places_leave_no_nan_and_no_infinity(self):
        """A picture with either makes the program fail."""
        lights = [point(0, 0, 0, intensity=1e6), point(0, 1e-9, 1, intensity=1e6), point(1, 1e-3, 0, intensity=1e6),
                  spot(0, 0, 0), spot(2, 0, 0, direction=[0, 1, 0]), point(0, 1, 0, range_m=0),
                  spot(0, 1, 0, inner_deg=0, outer_deg=0), spot(0, 1, 2, inner_deg=180, outer_deg=180, intensity=0)]
        scene = self.scene("worst", lights, camera=DOWN)
        for falloff in ("range_fade", "inverse_square_window", "inverse_square"):
            for method in METHODS:
                self.draw(scene, "--falloff", falloff, "--method", method, size=(63, 47))

    def test_a_light_of_range_0_or_in_the_surface_lights_nothing(self):
        dark = [[(0, 0, 0)] * 16] * 12
        for light in (point(0, 1, 0, range_m=0, intensity=1e6), point(0, 0, 0, intensity=1e6),
                      point(0, -0.5, 0, intensity=1e6)):
            for method in METHODS:
                scene = self.scene("dark", [light], camera=DOWN)
                self.assertEqual(self.draw(scene, "--method", method, size=(16, 12)), dark)

    def test_the_count_of_lights(self):
        """Display of 0, 1, 4 ... lights on a floor that faces up, and half-way between two of them."""
        colors = {0: (0, 0, 0), 1: (0, 0.05, 0.8), 2: (0, 0.325, 0.8), 4: (0, 0.6, 0.8), 16: (0, 0.6, 0.05),
                  64: (0.8, 0.7, 0), 256: (0.8, 0.05, 0), 1024: (1, 1, 1), 1500: (1, 1, 1)}
        for count, color in colors.items():
            scene = self.scene("count", [point(0, 1, 0) for _ in range(count)], camera=DOWN)
            for method in METHODS:
                got = self.draw(scene, "--show", "light_count", "--method", method, size=(16, 16))
                for c in range(3):
                    self.assertLess(abs(got[8][8][c] - to_code(color[c])), 1.3, (count, method))
        corner = self.draw(scene, "--show", "light_count", "--method", "tiled", size=(96, 96))[0][0]
        self.assertEqual(corner, (0, 0, 0))  # out of the lights' range

    def test_a_depth_gap_costs_tiles_more_than_clusters(self):
        """A post before a far floor with lights between them: the tile at its edge computes them, clusters do not."""
        post = {"model": "models/cube.obj", "position": [0, 1, 7], "scale": [0.5, 4, 0.5]}
        far = {"model": "models/plane.obj", "position": [0, 0, -30], "rotation_deg": [90, 0, 0], "scale": 90}
        lights = [point(0.145 * (3 + 0.5 * i), 1, 6 - 0.5 * i, range_m=0.5) for i in range(64)]
        scene = self.scene("post", lights, objects=[post, far], camera=ALONG | {"target": [0, 1, 0], "far_m": 100})

        def most(method):  # nearly yellow: more than 30
            rows = self.draw(scene, "--show", "light_count", "--method", method, size=(160, 120))
            return sum(pixel[0] > 110 for row in rows for pixel in row)
        self.assertGreater(most("tiled"), 50)
        self.assertEqual(most("clustered"), 0)

    def test_a_tile_takes_no_depth_from_its_neighbours(self):
        """A box that fills one tile to its borders. Lamps hang in the air beside it, over floor that they do not reach."""
        box = {"model": "models/cube.obj", "position": [0.75, 2, 0.75], "scale": [1.5, 4, 1.5]}
        lamps = [point(-0.5, 3, 0.6, range_m=0.4), point(0.6, 3, -0.5, range_m=0.4)]
        got = self.draw(self.scene("box", lamps, camera=DOWN, objects=[FLOOR, box]), "--show", "light_count",
                        "--method", "tiled", size=(32, 32))
        for x, y in ((8, 8), (8, 24), (24, 8)):
            self.assertEqual(got[y][x], (0, 0, 0), (x, y))

    def test_lights_are_packed_once_unless_one_moves(self):
        scene, out = self.scene("packed", [point(0, 1, 0), {"type": "directional"}]), self.folder / "timings.json"
        for options, times in ((("--frames", 6), 1), (("--frames", 6, "--moving", "on"), 6),
                               (("--frames", 6, "--method", "per_object"), 1)):
            self.run_program("--scene", scene, *options, "--timings", out, "--size", "32x24")
            timings = json.loads(out.read_text())
            self.assertEqual(timings["status"], [f"2 lights, packed {times}×"])
            self.assertGreater(timings["recording_in_a_row_cpu_ms"], 0)
            uploads = [p["frames"] for p in timings["passes"] if p["name"] == "lights"]  # the first frame is not counted
            self.assertEqual(uploads, [times - 1] if times > 1 else [])
            self.assertEqual([p["name"] for p in timings["passes"] if p["frames"] == 6][-1], "encode_srgb")

    def test_lights_that_move_are_those_of_the_last_frame(self):
        """The picture depends on its time alone, not on earlier frames' buffers."""
        scene = self.scene("moving", [point(0.3 * i - 3, 0.5, 4 - 0.2 * i, intensity=5) for i in range(20)])
        for method in METHODS:
            moving = ("--moving", "on", "--method", method, "--validate", "on")
            alone = self.draw(scene, *moving, "--time", 0.25)
            self.assertEqual(self.draw(scene, *moving, "--frames", 16), alone)  # the last one's time is 15/60 s
            self.assertNotEqual(self.draw(scene, *moving), alone)

    def test_a_scene_without_lights_is_drawn_in_silence(self):
        """The key is absent, not empty; validation says nothing of the buffers that hold none."""
        path = self.folder / "unlit.json"
        path.write_text(json.dumps({"camera": ALONG, "objects": [FLOOR], "ambient": [0.2, 0.2, 0.2]}))
        pictures = [self.draw(path, "--method", method, "--validate", "on") for method in METHODS]
        self.assertEqual(pictures[1:], pictures[:1] * 3)
        self.assertGreater(max(max(row) for row in pictures[0])[0], 50)

    def test_scattered_lights_follow_the_seed_and_moving_ones_the_time(self):
        scene = self.scene("seed", [], camera=DOWN)
        options = ("--lights", 30)
        once = self.draw(scene, *options)
        self.assertEqual(self.draw(scene, *options, "--seed", 0), once)
        self.assertNotEqual(self.draw(scene, *options, "--seed", 1), once)
        moving = (*options, "--moving", "on", "--time")
        self.assertEqual(self.draw(scene, *moving, 3), self.draw(scene, *moving, 3))
        self.assertNotEqual(self.draw(scene, *moving, 3), self.draw(scene, *moving, 4))


if __name__ == "__main__":
    unittest.main()
