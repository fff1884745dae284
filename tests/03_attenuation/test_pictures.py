"""Pictures of chapter 03: all methods of culling agree to the last bit, and pixels match double precision."""
import math

from PIL import Image

from pictures import ChapterPictures

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

    @staticmethod
    def scene(lights, camera=ALONG, objects=(FLOOR,), **keys) -> dict:
        return {"camera": camera, "objects": list(objects), "lights": lights, "ambient": [0, 0, 0], "background": [0, 0, 0], **keys}

    def draw(self, scene, *options, size=(64, 48)):
        """Rows of (r, g, b) codes."""
        image = Image.open(super().draw(scene, *options, size=f"{size[0]}x{size[1]}")).convert("RGB").load()
        return [[image[x, y] for x in range(size[0])] for y in range(size[1])]

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
        yield "lights before, behind and at a depth gap", self.scene(ring + [sun] + cones, objects=things), {}
        yield "range fade", self.scene(cones + ring, objects=things), {"falloff": "range_fade"}
        yield "the camera in every light", self.scene([point(0.1, 1.2, 9, range_m=30, intensity=1e5),
                                                       spot(0, 1, 9, direction=[0, -0.2, -1], range_m=40),
                                                       spot(0, 1, 12, outer_deg=180, range_m=40)]), {}
        yield "one slice", self.scene(ring + cones, objects=things), {"slices": 1}
        yield "200 slices", self.scene(ring + cones, objects=things), {"slices": 200}
        yield "from above", self.scene(ring + cones, camera=DOWN, objects=things), {}
        yield "2,500 lights", self.scene([sun], objects=things), {"lights": 2500}
        yield "sun alone", self.scene([sun]), {}
        yield "no light", self.scene([]), {}
        yield "nothing to see", self.scene(ring, objects=[FLOOR | {"position": [0, -50, 40]}]), {}

    def test_culling_changes_no_bit_where_a_falloff_ends(self):
        for label, scene, knobs in self.places():
            settings = [word for name, value in knobs.items() for word in (f"--{name}", value)]
            for size in ((203, 151), (1, 1)):
                every, *others = (self.draw(scene, *settings, "--method", method, size=size) for method in METHODS)
                for method, picture in zip(METHODS[1:], others):
                    with self.subTest(label=label, method=method, size=size):
                        self.assertEqual(picture, every)

    def test_lights_in_the_worst_places_leave_no_nan_and_no_infinity(self):
        """A picture with either makes the program fail."""
        lights = [point(0, 0, 0, intensity=1e6), point(0, 1e-9, 1, intensity=1e6), point(1, 1e-3, 0, intensity=1e6),
                  spot(0, 0, 0), spot(2, 0, 0, direction=[0, 1, 0]), point(0, 1, 0, range_m=0),
                  spot(0, 1, 0, inner_deg=0, outer_deg=0), spot(0, 1, 2, inner_deg=180, outer_deg=180, intensity=0)]
        scene = self.scene(lights, camera=DOWN)
        for falloff in ("range_fade", "inverse_square_window", "inverse_square"):
            for method in METHODS:
                self.draw(scene, "--falloff", falloff, "--method", method, size=(63, 47))

    def test_a_tile_takes_no_depth_from_its_neighbours(self):
        """A box that fills one tile to its borders. Lamps hang in the air beside it, over floor that they do not reach."""
        box = {"model": "models/cube.obj", "position": [0.75, 2, 0.75], "scale": [1.5, 4, 1.5]}
        lamps = [point(-0.5, 3, 0.6, range_m=0.4), point(0.6, 3, -0.5, range_m=0.4)]
        got = self.draw(self.scene(lamps, camera=DOWN, objects=[FLOOR, box]), "--show", "light_count",
                        "--method", "tiled", size=(32, 32))
        for x, y in ((8, 8), (8, 24), (24, 8)):
            self.assertEqual(got[y][x], (0, 0, 0), (x, y))

    def test_a_scene_without_lights_is_drawn_in_silence(self):
        """The key is absent, not empty; validation says nothing of the buffers that hold none."""
        unlit = {"camera": ALONG, "objects": [FLOOR], "ambient": [0.2, 0.2, 0.2]}
        pictures = [self.draw(unlit, "--method", method, "--validate", "on") for method in METHODS]
        self.assertEqual(pictures[1:], pictures[:1] * 3)
        self.assertGreater(max(max(row) for row in pictures[0])[0], 50)
