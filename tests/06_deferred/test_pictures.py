"""Pictures of chapter 06 that must agree with others, or differ by a known amount."""
import json
import subprocess

from PIL import Image

from parts import Gltf
from pictures import BUILD, ROOT, ChapterPictures
from shots.rendering import render_many

SCENES = ROOT / "assets" / "scenes"
FLOOR = {"model": "models/plane.obj", "scale": 12,
         "material": {"diffuse": [0.6, 0.6, 0.6], "specular": [0.2, 0.2, 0.2], "shininess": 40}}


class PicturesTest(ChapterPictures):
    chapter = "06_deferred"

    def steps(self, expected, actual) -> tuple[int, int]:
        """The largest difference of a channel in steps of 1/255, and how many pixels differ by more than one."""
        a, b = (Image.open(p).convert("RGB").tobytes() for p in (expected, actual))
        far = [abs(x - y) for x, y in zip(a, b)]
        return max(far), len({i // 3 for i, d in enumerate(far) if d > 1})

    def lamps(self, **camera) -> dict:
        return {"camera": {"position": [0, 1.2, 4], "target": [0, 0.4, 0], "near_m": 0.1, "far_m": 40} | camera,
                "background": [0.01, 0.02, 0.05], "ambient": [0.02, 0.02, 0.02],
                "objects": [FLOOR, {"model": "models/sphere.obj", "position": [0, 0.5, 0],
                                    "material": {"diffuse": [0.7, 0.5, 0.3], "specular": [0.3, 0.3, 0.3]}}],
                "lights": [{"type": "directional", "direction": [0.3, -1, -0.3], "intensity": 0.1},
                           {"type": "point", "position": [0.9, 0.9, 0.6], "range_m": 3, "color": [1, 0.5, 0.2]},
                           {"type": "point", "position": [0, 1.0, 3.4], "range_m": 6, "color": [0.2, 0.6, 1]},
                           {"type": "spot", "position": [-1.2, 2, 1], "direction": [1, -1.4, -0.8], "range_m": 5,
                            "intensity": 4, "outer_deg": 25},
                           {"type": "spot", "position": [1.5, 0.4, 0], "direction": [-1, 0, 0], "range_m": 4, "outer_deg": 80}]}

    # --- culling

    def test_coplanar_emission_is_counted_once(self):
        glow = {"diffuse": [0, 0, 0], "specular": [0, 0, 0], "emissive": [0.2, 0.1, 0.05]}
        cubes = [{"model": "models/cube.obj", "position": [x, 0.5, 0], "rotation_deg": [0, 0, roll], "material": glow}
                 for x, roll in ((-0.25, 0), (0.1, 0), (0.4, 180))]
        scene = {"camera": {"position": [0.3, 0.9, 3], "target": [0, 0.5, 0], "near_m": 0.1, "far_m": 40},
                 "background": [0, 0, 0], "ambient": [0, 0, 0], "objects": cubes, "lights": []}
        pictures = [self.draw(scene, "--method", method, name=method) for method in ("forward", "packed", "fat", "tiled")]
        for picture in pictures:
            colors = {color for _, color in Image.open(picture).convert("RGB").getcolors()}
            self.assertLessEqual(len(colors), 2, f"{picture.stem}: {sorted(colors)}")
            self.assertEqual(self.steps(pictures[0], picture)[0], 0, picture.stem)

    def test_a_geometry_shader_draws_what_the_device_culls_not(self):
        """Surfaces with two sides from behind; and it hands on colours of vertices and second texture coordinates."""
        Image.linear_gradient("L").resize((16, 16)).convert("RGB").save(self.folder / "shades.png")
        gltf = Gltf({"pbrMetallicRoughness": {"metallicFactor": 0, "baseColorTexture": {"index": 0, "texCoord": 1}},
                     "doubleSided": True}, camera=False).texture({"uri": "shades.png"})
        gltf.primitive()["attributes"] |= {"COLOR_0": gltf.floats([[1, 0, 0, 1], [0, 1, 0, 1], [0, 0, 1, 1], [1, 1, 0, 1]]),
                                           "TEXCOORD_1": gltf.floats([[0, 2], [2, 2], [2, 0], [0, 0]])}
        gltf.write(str(self.folder / "square.gltf"))
        for turn in (20, 160):
            scene = {"camera": {"position": [0, 0, 4], "target": [0, 0, 0], "fov_deg": 30}, "ambient": [0.5, 0.5, 0.5], "lights": [],
                     "objects": [{"model": str(self.folder / "square.gltf"), "rotation_deg": [0, turn, 0]}]}
            fixed, geometry = [self.draw(scene, "--method", "packed", "--set", "surface.model=ggx", "--set", f"cull={cull}",
                                         size="64x64", name=cull) for cull in ("fixed", "geometry")]
            with self.subTest(turn=turn):
                self.assertGreater(len(Image.open(fixed).convert("RGB").getcolors(64 * 64)), 100)
                self.assertLessEqual(self.steps(fixed, geometry)[0], 1)

    def test_a_shader_that_never_emits_draws_nothing_after_one_that_does(self):
        """The starter culls no triangle, so none is left out; Mesa 22.3 read its outputs, which a compiler had removed."""
        scene = [SCENES / "bell.json", "--size", "160x90", "--set", "cull=left_out"]
        files = [(["--scene", *scene, "--use", use], self.folder / f"{name}.png")
                 for name, use in (("right", "solution"), ("starter", "solution,06.cull_back_face=exercise"))]
        self.assertEqual(render_many(self.chapter, files), ["", ""])
        empty = Image.open(files[1][1]).convert("RGB")
        self.assertEqual(len(empty.getcolors(160 * 90)), 1)

    # --- methods

    def test_lamps_with_a_size_light_as_in_chapter_04(self):
        """Also below their middles, where a lamp that casts no shadow is still partly above the surface."""
        for method in ("representative", "ltc", "sampled"):
            options = ("--set", "surface.model=ggx", "--set", f"lamps.method={method}")
            truth = self.folder / "04.png"
            subprocess.run([BUILD / "chapters/04_surface_maps", "--scene", SCENES / "lamps.json", *options, "--size", "160x90",
                            "--screenshot", truth], check=True, capture_output=True)
            with self.subTest(method=method):
                self.assertEqual(self.steps(truth, self.draw("lamps", "--method", "forward", *options)), (0, 0))
                self.assertLess(self.flip(truth, self.draw("lamps", "--method", "fat", *options)), 0.004)

    def test_surfaces_that_a_gbuffer_has_no_room_for(self):
        """Microfacets (a metal in the file's own light) and unlit squares are drawn as forward draws them."""
        for model in ("metallic_roughness_texture.gltf", "own_light.gltf", "texture.gltf"):
            file = ROOT / "assets" / "conformance" / model
            truth = self.draw(file, "--camera-of-file", "1", "--method", "forward", name="truth")
            for method in ("fat", "depth", "packed", "tiled"):
                with self.subTest(model=model, method=method):
                    picture = self.draw(file, "--camera-of-file", "1", "--method", method)
                    self.assertLessEqual(self.steps(truth, picture), (1, 0))  # the ground is in the G-buffer

    def test_one_pixel(self):
        """A size that an image has before it is made."""
        for method in ("forward", "fat", "depth", "packed", "tiled"):
            with self.subTest(method=method):
                self.draw(self.lamps(), "--method", method, size="1x1")

    def test_volumes_light_what_full_screen_lights_light(self):
        """The camera in a volume, at its surface, in all of them; lights that reach beyond the far plane; lights that
        reach nothing. Adding in halves, light by light, may round by a step."""
        inside = self.lamps()
        touching = self.lamps(position=[0, 1.0, 0.4])   # 3 m from the second lamp, which reaches ...
        touching["lights"][2] |= {"position": [0, 1.0, 3.4], "range_m": 3}
        beyond = self.lamps(far_m=6)
        beyond["lights"] += [{"type": "point", "position": [0, 2, -5], "range_m": 60, "intensity": 2}]
        nothing = self.lamps()
        nothing["lights"] += [{"type": "point", "position": [0, 50, 0], "range_m": 3},
                              {"type": "point", "position": [0, 0.5, 0.6], "range_m": 0},
                              {"type": "spot", "position": [0, 3, 0], "direction": [0, -1, 0], "inner_deg": 0, "outer_deg": 0}]
        wide = self.lamps()
        for degrees in (60, 65, 89, 90, 91, 180):
            wide["lights"].append({"type": "spot", "position": [0.4, 0.8, 0.9], "direction": [0, -1, 0.2], "range_m": 2,
                                   "intensity": 0.3, "inner_deg": 10, "outer_deg": degrees})
        none = self.lamps() | {"lights": []}
        for name, scene in (("inside", inside), ("touching", touching), ("beyond", beyond), ("nothing", nothing),
                            ("wide", wide), ("none", none)):
            with self.subTest(scene=name):
                all_pixels = self.draw(scene, "--volumes", "off", name="all")
                most, pixels = self.steps(all_pixels, self.draw(scene, "--volumes", "on"))
                self.assertLessEqual(most, 2)
                self.assertLessEqual(pixels, 20)
                most, pixels = self.steps(all_pixels, self.draw(scene, "--method", "tiled"))
                self.assertLessEqual(most, 1)

    # --- materials

    def test_roughness_0_and_specular_above_1_do_not_run_over(self):
        """Packed as whole bytes: neighbours stay unchanged."""
        scene = self.lamps()
        scene["objects"][1]["material"] = {"diffuse": [0.2, 0.9, 0.1], "roughness": 0, "metalness": 0.5}
        truth = self.draw(scene, "--method", "forward", name="truth")
        self.assertLess(self.flip(truth, self.draw(scene, "--method", "packed", "--volumes", "off")), 0.012)
        scene["objects"][1]["material"] = {"diffuse": [0.5, 0.5, 0.5], "specular": [1, 1, 1], "shininess": 100000}
        for show in ("diffuse", "specular", "gloss"):
            colors = Image.open(self.draw(scene, "--show", show)).convert("RGB").getpixel((80, 50))
            fat = Image.open(self.draw(scene, "--show", show, "--method", "fat")).convert("RGB").getpixel((80, 50))
            if show != "gloss":
                self.assertLessEqual(max(abs(a - b) for a, b in zip(colors, fat)), 1, show)
            else:
                self.assertEqual(colors, (255, 255, 255))

    # --- screens

    def test_screens_that_see_each_other_do_not_blow_up(self):
        """Two white screens face to face under a strong light: brighter from frame to frame, and no further than white."""
        def screen(name, z, turn):
            return [{"name": f"screen {name}", "model": "models/plane.obj", "position": [0, 1, z], "rotation_deg": [90, turn, 0],
                     "scale": [3.2, 1, 1.8], "material": {"diffuse": [1, 1, 1], "emissive": [4, 4, 4]}},
                    {"name": f"camera {name}", "position": [0, 1, z * 0.95], "rotation_deg": [0, turn + 180, 0]}]
        scene = self.lamps(position=[2.5, 1.5, 1.5], target=[0, 0.9, -1])
        scene["objects"] = [FLOOR, *screen("a", -2, 0), *screen("b", 2, 180)]
        scene["lights"] += [{"type": "point", "position": [0, 2, 0], "range_m": 8, "intensity": 20}]
        pictures = [self.draw(scene, "--frames", n, "--set", "screens.width=160", name=f"after {n}") for n in (1, 2, 40, 41)]
        self.assertGreater(self.steps(*pictures[:2])[1], 100)  # a frame later there is more to see
        self.assertLessEqual(self.steps(*pictures[2:])[0], 1)  # and in the end it stands still

    def test_a_screen_without_a_camera_is_one_clear_line(self):
        scene = self.lamps()
        scene["objects"].append({"name": "screen a", "model": "models/plane.obj"})
        file = self.folder / "scene.json"
        file.write_text(json.dumps(scene))
        done = subprocess.run([self.program, "--scene", file, "--screenshot", self.folder / "no.png"], capture_output=True,
                              text=True, cwd=ROOT)
        self.assertEqual(done.returncode, 2)
        self.assertIn("add an object 'camera a'", done.stderr)
        self.assertFalse((self.folder / "no.png").exists())


class ScaleTest(ChapterPictures):
    chapter, settings = "06_deferred", ()
    most = {0.001: 300, 1000: 20}  # pixels that may differ

    def test_a_ball_of_a_millimetre_or_a_kilometre_is_as_lit_as_one_of_a_metre(self):
        """A G-buffer's plane is found from depths, which tilts it slightly: a bias in metres does not grow with the scene."""
        codes, matt = {}, {"diffuse": [0.7, 0.7, 0.7], "specular": [0, 0, 0]}
        for scale in (1, 0.001, 1000):
            at = lambda *place: [scale * x for x in place]  # noqa: E731, B023
            camera = {"position": at(5, 4, 7), "target": at(0, 0.5, 0), "fov_deg": 40, "near_m": 0.1 * scale, "far_m": 100 * scale}
            objects = [{"model": f"models/{name}.obj", "scale": at(*size), "position": at(*place), "material": matt}
                       for name, size, place in (("plane", (20, 1, 20), (0, 0, 0)), ("sphere", (1.2, 1.2, 1.2), (1.6, 0.6, 0.8)))]
            sun = {"type": "directional", "direction": [-0.4, -1, -0.3], "shadow": True}
            picture = self.draw({"camera": camera, "objects": objects, "lights": [sun]}, *self.settings, size="240x240")
            codes[scale] = list(Image.open(picture).convert("L").getdata())
        for scale, most in self.most.items():  # the edges of shadows
            with self.subTest(scale=scale):
                self.assertLess(sum(abs(a - b) > 20 for a, b in zip(codes[1], codes[scale])), most)


class PlaygroundScaleTest(ScaleTest):
    """Chapter 18 draws it forward."""
    chapter, settings, drawing = "18_playground", ("--set", "post.tone=off"), None
    most = {0.001: 300, 1000: 150}
