"""Pictures of chapter 04 that must agree with others, or differ by a known amount."""
import math
import pathlib

from PIL import Image, ImageChops

from parts import Gltf
from picture_drawing import sets
from pictures import ROOT, ChapterPictures

TEXTURES = ROOT / "assets" / "textures"


class PicturesTest(ChapterPictures):
    chapter = "04_surface_maps"

    def wall(self, maps, **material) -> dict:
        """One texture's width of wall that fills the picture."""
        return {"camera": {"position": [0, 0, 1], "target": [0, 0, 0], "fov_deg": 28, "near_m": 0.1, "far_m": 10},
                "objects": [{"model": "models/plane.obj", "rotation_deg": [90, 0, 0],
                             "material": {"diffuse": [1, 1, 1], "maps": maps} | material}],
                "lights": [{"type": "directional", "direction": [-0.6, -0.4, -0.7], "intensity": 3}],
                "ambient": [0.2, 0.2, 0.2]}

    # --- model files: one surface, written in two ways

    def square(self, name, *, image, material, uv, uv1=None, joint=None, node=None) -> pathlib.Path:
        """A square from -1 to 1 that faces +z, with a camera, a light and one texture. `joint`: a key of rotation."""
        gltf = Gltf(material, camera=False).texture({"uri": image})
        attributes = gltf.primitive()["attributes"]
        attributes |= {f"TEXCOORD_{i}": gltf.floats(one) for i, one in enumerate((uv, uv1)) if one}
        light = {"extensions": {"KHR_lights_punctual": {"light": 0}}, "rotation": [-0.258, -0.155, 0, 0.954]}
        gltf.json |= {"nodes": [{"camera": 0, "translation": [0, 0, 4]}, light, {"mesh": 0} | (node or {})],
                      "cameras": [{"type": "perspective", "perspective": {"yfov": 0.8, "znear": 0.1}}],
                      "extensions": {"KHR_lights_punctual": {"lights": [{"type": "directional", "intensity": 3.14}]}}}
        if joint:
            attributes |= {"JOINTS_0": gltf.accessor(bytes(16), 5121, "VEC4", 4), "WEIGHTS_0": gltf.floats([[1, 0, 0, 0]] * 4)}
            gltf.json["nodes"][2]["skin"] = 0
            gltf.json["nodes"].append(joint)
            half = math.sin(math.pi / 4)
            turn = {"input": gltf.floats([[0], [1]]), "output": gltf.floats([[0, 0, 0, 1], [0, 0, half, half]])}
            gltf.json |= {"skins": [{"joints": [3]}], "animations": [
                {"channels": [{"sampler": 0, "target": {"node": 3, "path": "rotation"}}], "samplers": [turn]}]}
        gltf.json["scenes"] = [{"nodes": list(range(len(gltf.json["nodes"])))}]
        gltf.write(str(self.folder / name))
        return self.folder / name

    def shown(self, model, *options) -> Image.Image:
        """The middle of the square: the ground below a model lies where its pose at 0 s leaves it."""
        picture = self.draw(model, "--camera-of-file", "1", *options, size="160x160", name="model")
        return Image.open(picture).convert("RGB").crop((58, 66, 102, 94))

    def largest_difference(self, a, b) -> int:
        return max(high for _, high in ImageChops.difference(a, b).getextrema())

    def waves(self) -> str:
        """A normal map that leans along u alone, by up to 30 degrees."""
        image = Image.new("RGB", (64, 64))
        lean = [0.5 * math.sin(x * math.tau / 16) for x in range(64)]
        image.putdata([(round(127.5 + 127.5 * lean[i % 64]), 128, round(127.5 + 127.5 * math.sqrt(1 - lean[i % 64] ** 2)))
                       for i in range(64 * 64)])
        image.save(self.folder / "waves.png")
        return "waves.png"

    PLAIN = {"pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 1}}
    UPRIGHT = [[0, 1], [1, 1], [1, 0], [0, 0]]  # u to the right, v down
    TURNED = [[0, 0], [0, 1], [1, 1], [1, 0]]   # by a quarter

    def test_normal_map_of_the_second_coordinates(self):
        """Tangents are those of the coordinates that the map has."""
        image = self.waves()
        first, second = ({**self.PLAIN, "normalTexture": {"index": 0, "texCoord": n}} for n in (0, 1))
        by_first = self.shown(self.square("a.gltf", image=image, material=first, uv=self.TURNED))
        by_second = self.shown(self.square("b.gltf", image=image, material=second, uv=self.UPRIGHT, uv1=self.TURNED))
        upright = self.shown(self.square("c.gltf", image=image, material=first, uv=self.UPRIGHT))
        self.assertLessEqual(self.largest_difference(by_first, by_second), 1)
        self.assertGreater(self.largest_difference(by_first, upright), 40)

    def test_a_scaled_normal_map_has_the_normals_of_its_texels(self):
        """KHR_texture_transform moves texels apart; what they hold are unit vectors. A turned map's lean with it."""
        Image.new("RGB", (4, 4), (204, 128, 230)).save(self.folder / "right.png")  # leans towards u by 37 degrees
        Image.new("RGB", (4, 4), (128, 52, 230)).save(self.folder / "down.png")

        def middle(image, **transform) -> int:
            placed = {"index": 0} | ({"extensions": {"KHR_texture_transform": transform}} if transform else {})
            return self.shown(self.square("placed.gltf", image=image, material={**self.PLAIN, "normalTexture": placed},
                                          uv=self.UPRIGHT)).getpixel((22, 14))[0]

        right, down, quarter = middle("right.png"), middle("down.png"), math.pi / 2
        self.assertGreater(abs(right - down), 10)
        for scale in ([1, 1], [4, 1], [1, 4], [0.2, 0.2]):
            with self.subTest(scale=scale):
                self.assertAlmostEqual(middle("right.png", scale=scale), right, delta=1)
                self.assertAlmostEqual(middle("right.png", scale=scale, rotation=quarter), down, delta=1)

    def test_normal_map_of_a_skin_turns_with_its_joint(self):
        """A joint that turns the square looks like a node that does; also where both are mirrored or stretched."""
        image, material = self.waves(), {**self.PLAIN, "normalTexture": {"index": 0}}
        for scale in ([1, 1, 1], [-1, 1, 1], [1, 0.5, 1]):
            quarter = {"rotation": [0, 0, math.sin(math.pi / 8), math.cos(math.pi / 8)], "scale": scale}
            node = self.square("node.gltf", image=image, material=material, uv=self.UPRIGHT, node=quarter)
            joint = self.square("joint.gltf", image=image, material=material, uv=self.UPRIGHT, joint={"scale": scale})
            by_node = self.shown(node)
            with self.subTest(scale=scale):
                even = Image.new("RGB", by_node.size, by_node.getpixel((0, 0)))
                self.assertGreater(self.largest_difference(by_node, even), 15)
                self.assertLessEqual(self.largest_difference(by_node, self.shown(joint, "--time", "0.5")), 6)

    def test_the_place_of_a_skin_s_node_says_nothing(self):
        """glTF 2.0, 3.7.3.3: the transform of the node with the mesh is ignored."""
        image, material = self.waves(), {**self.PLAIN, "normalTexture": {"index": 0}}
        far = {"translation": [3, 2, -4], "scale": [2, 0.2, -1], "rotation": [0, 0.6, 0, 0.8]}
        at_home, elsewhere = (self.shown(self.square(f"{name}.gltf", image=image, material=material, uv=self.UPRIGHT,
                                                     joint={"scale": [1, 1, 1]}, node=node), "--time", "0.5")
                              for name, node in (("home", {}), ("elsewhere", far)))
        self.assertLessEqual(self.largest_difference(at_home, elsewhere), 1)

    def test_a_mask_with_a_factor_keeps_its_share_however_small_it_is_seen(self):
        """Alpha .8 times .7 is below a cutoff of .6, alpha 1 times .7 above it: half of the stripes stay."""
        image = Image.new("RGBA", (64, 64))
        image.putdata([(255, 0, 0, 255 if x // 4 % 2 else 204) for _ in range(64) for x in range(64)])
        image.save(self.folder / "stripes.png")
        material = {"pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 0.7], "baseColorTexture": {"index": 0}},
                    "alphaMode": "MASK", "alphaCutoff": 0.6, "extensions": {"KHR_materials_unlit": {}}}
        for repeats in (1, 4, 8, 24):
            model = self.square("mask.gltf", image="stripes.png", material=material, uv=[[repeats * x for x in corner] for corner in self.UPRIGHT])
            pixels = list(self.shown(model).getdata())
            kept = sum(r - (g + b) / 2 for r, g, b in pixels) / (255 * len(pixels))
            with self.subTest(repeats=repeats):
                self.assertAlmostEqual(kept, 0.5, delta=0.1)

    def test_far_grass_covers_what_many_samples_of_it_cover(self):
        blade = {"model": "models/plane.obj", "rotation_deg": [90, 0, 0],
                 "material": {"diffuse": [0, 0, 0], "maps": {"diffuse": str(TEXTURES / "grass_cutout.png")}}}
        scene = {"camera": {"position": [0, 0, 18], "target": [0, 0, 0], "fov_deg": 30}, "background": [1, 1, 1],
                 "ambient": [0, 0, 0], "lights": [],
                 "objects": [blade | {"position": [x, y, 0]} for x in range(-5, 6) for y in range(-3, 4)]}

        def share(*options, size="160x90"):
            codes = Image.open(self.draw(scene, *options, size=size)).convert("L").tobytes()
            return sum(code < 128 for code in codes) / len(codes)

        truth = share(size="2560x1440")  # where every texel has a pixel
        kept, averaged = share("--maps.coverage", "kept"), share("--maps.coverage", "averaged")
        self.assertLess(abs(kept - truth), 0.15 * truth, (truth, kept, averaged))
        self.assertGreater(abs(averaged - truth), 0.2 * truth, (truth, kept, averaged))

    # --- objects

    def test_an_object_looks_the_same_beside_another_of_its_model(self):
        """One has the microfacets of its file, the other a highlight that the scene states."""
        Gltf({"pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.1, 0.1, 1], "metallicFactor": 0, "roughnessFactor": 0.4}},
             camera=False).write(str(self.folder / "square.gltf"))
        plain = {"model": str(self.folder / "square.gltf"), "position": [-1.1, 0, 0], "rotation_deg": [0, 30, 0]}
        shiny = plain | {"position": [1.1, 0, 0], "material": {"specular": [0.4, 0.4, 0.4], "shininess": 20}}

        def halves(*objects):
            scene = {"camera": {"position": [0, 0, 5], "target": [0, 0, 0], "fov_deg": 30}, "objects": objects,
                     "lights": [{"type": "directional", "direction": [-0.7, 0, -0.7]}], "ambient": [0.1, 0.1, 0.1]}
            picture = Image.open(self.draw(scene, size="80x40")).convert("RGB")
            return picture.crop((0, 0, 40, 40)), picture.crop((40, 0, 80, 40))

        left, right = halves(plain)[0], halves(shiny)[1]
        for order in ((plain, shiny), (shiny, plain)):
            both = halves(*order)
            self.assertLessEqual(self.largest_difference(both[0], left), 1)
            self.assertLessEqual(self.largest_difference(both[1], right), 1)

    # --- lamps

    def test_lamps_scale_with_the_scene(self):
        """A light that is a thousandth as large and as far has the same shape in the sky."""
        def seen(method, scale, **lamp):
            light = {"type": "point", "position": [0, 0.5 * scale, 0], "range_m": 100 * scale} | {
                key: [scale * x for x in one] if isinstance(one, list) else scale * one for key, one in lamp.items()}
            scene = {"camera": {"position": [0, 0.6 * scale, 1.5 * scale], "target": [0, 0, 0], "fov_deg": 40,
                                "near_m": 0.05 * scale, "far_m": 100 * scale}, "lights": [light],
                     "objects": [{"model": "models/plane.obj", "scale": 4 * scale,
                                  "material": {"diffuse": [0.1, 0.1, 0.1], "roughness": 0.3, "metalness": 0}}]}
            return Image.open(self.draw(scene, *sets(f"lamps.method={method}", "falloff=range_fade", "fade_k=0"),
                                        size="48x36")).convert("RGB")

        for method, lamp in (("representative", {"tube_m": [0.4, 0, 0], "size_m": 0.02}), ("sampled", {"size_m": 0.01})):
            with self.subTest(method=method):
                self.assertLessEqual(self.largest_difference(seen(method, 1, **lamp), seen(method, 0.001, **lamp)), 2)

    # --- hits

    def test_exact_hits_look_like_the_displaced_mesh(self):
        """Two programs that share nothing but the height map: a ray through texels, and a mesh that was moved."""
        options = ["--height_m", "0.03", "--samples", "4"]
        wall = self.wall({"diffuse": str(TEXTURES / "castle_wall_albedo.jpg"),
                          "height": str(TEXTURES / "castle_wall_height.png")})
        wall["camera"]["position"] = [0.5, 0, 0.8]
        wall["camera"]["fov_deg"] = 20
        mesh = self.draw(wall, *options, "--mesh", "displaced", "--subdivide", "512", name="mesh")
        errors = {method: self.flip(mesh, self.draw(wall, *options, "--method", method, "--steps", "64"))
                  for method in ("normal", "offset", "occlusion", "exact")}
        self.assertLess(errors["exact"], 0.02, errors)
        self.assertLess(errors["exact"], 0.3 * errors["offset"], errors)
        self.assertLess(errors["occlusion"], 0.3 * errors["offset"], errors)
        self.assertLess(errors["offset"], errors["normal"], errors)

    def test_the_outline_is_the_mesh_s_and_not_the_height_map_s(self):
        """Intersection over union of the covered background: the same for all parallax, less for the truth."""
        def covered(*options):
            picture = Image.open(self.draw("column", "--show", "normal", *options, size="320x180")).convert("RGB")
            background = picture.getpixel((1, 90))
            return [pixel != background for pixel in picture.getdata()]

        loaded, flat = covered("--method", "exact"), covered("--method", "flat")
        displaced = covered("--mesh", "displaced", "--subdivide", "6")
        self.assertEqual(loaded, flat)
        both = sum(a and b for a, b in zip(loaded, displaced))
        either = sum(a or b for a, b in zip(loaded, displaced))
        self.assertFalse(any(b and not a for a, b in zip(loaded, displaced)))  # bumps go inwards
        self.assertGreater(both / either, 0.85)
        self.assertLess(both / either, 0.97)

    # --- maps

    def test_a_switch_that_is_off_is_a_map_that_is_missing(self):
        every = {"diffuse": "castle_wall_albedo.jpg", "specular": "castle_wall_specular.png",
                 "emissive": "lava_emissive.jpg", "opacity": "castle_wall_height.png",
                 "normal": "castle_wall_normal.png", "height": "castle_wall_height.png", "orm": "wood_orm.png",
                 "occlusion": "stone_tiles_height.png", "gloss": "stone_tiles_specular.png",
                 "detail_normal": "detail_normal.png", "displacement": "lava_height.png"}
        for slot, file in every.items():
            every[slot] = str(self.folder / f"{slot}.png")
            Image.open(TEXTURES / file).resize((64, 64)).save(every[slot])
        more = {"emissive": [0.3, 0.3, 0.3], "specular": [0.3, 0.3, 0.3]}
        whole = self.draw(self.wall(every, **more), name="whole")
        for slot in every:
            with self.subTest(slot=slot):
                off = self.draw(self.wall(every, **more), f"--{slot}", "off", name="off")
                missing = self.draw(self.wall({s: f for s, f in every.items() if s != slot}, **more), name="missing")
                self.assertEqual(off.read_bytes(), missing.read_bytes())
                self.assertNotEqual(off.read_bytes(), whole.read_bytes())

    def test_a_normal_map_of_the_other_convention(self):
        up = Image.open(TEXTURES / "castle_wall_normal.png").convert("RGB")
        red, green, blue = up.split()
        Image.merge("RGB", (red, green.point(lambda code: 255 - code), blue)).save(self.folder / "down.png")
        right = self.draw(self.wall({"normal": str(TEXTURES / "castle_wall_normal.png")}), name="right")
        wrong = self.draw(self.wall({"normal": str(self.folder / "down.png")}), name="wrong")
        flipped = self.draw(self.wall({"normal": str(self.folder / "down.png")}), "--normal_y", "down", name="flipped")
        self.assertLess(self.flip(right, flipped), 0.015)  # the device's filter rounds down
        self.assertGreater(self.flip(right, wrong), 0.1)

    def test_roughness_and_metalness_of_the_scene_take_the_place_of_the_map_s(self):
        def orm(color):
            Image.new("RGB", (4, 4), color).save(self.folder / "orm.png")
            return {"orm": str(self.folder / "orm.png")}

        lit = {"diffuse": [0.9, 0.6, 0.3]}
        of_map = self.draw(self.wall(orm((255, 102, 204)), **lit), name="map")
        overridden = self.draw(self.wall(orm((255, 0, 0)), **lit, roughness=0.4, metalness=0.8), name="overridden")
        without = self.draw(self.wall({}, **lit, roughness=0.4, metalness=0.8), name="without")
        self.assertEqual(overridden.read_bytes(), without.read_bytes())
        self.assertLess(self.flip(of_map, overridden), 0.005)  # 102 / 255 as the device reads it
        only_rough = self.draw(self.wall(orm((255, 0, 0)), **lit, roughness=0.4), name="rough")
        self.assertNotEqual(of_map.read_bytes(), only_rough.read_bytes())
        self.draw(self.wall(orm((255, 0, 0)), **lit))  # roughness 0: no NaN, or it would have failed

    # --- displacement

    def test_a_displacement_map_that_is_off_or_of_strength_0_changes_no_bit(self):
        maps = {"diffuse": str(TEXTURES / "castle_wall_albedo.jpg"), "height": str(TEXTURES / "castle_wall_height.png")}
        swell = self.wall(maps | {"displacement": str(TEXTURES / "swell_displacement.png")})
        for method in ("flat", "normal", "occlusion"):
            before = self.draw(self.wall(maps), "--method", method, name="before").read_bytes()
            for options in (("--displacement", "off"), ("--displacement_m", "0"),
                            ("--mesh", "displaced", "--subdivide", "4")):
                with self.subTest(method=method, options=options):
                    if "--mesh" in options:
                        before = self.draw(self.wall(maps), "--method", method, *options, name="mesh").read_bytes()
                    self.assertEqual(self.draw(swell, "--method", method, *options).read_bytes(), before)
            self.assertNotEqual(self.draw(swell, "--method", method).read_bytes(), before)

    # --- filters

    def test_toksvig_is_nearer_to_many_samples_than_renormalised_normals_are(self):
        floor = {"camera": {"position": [0, 5, 5], "target": [0, 0, -0.3], "fov_deg": 40, "near_m": 0.05, "far_m": 100},
                 "objects": [{"model": "models/ground.obj",
                              "material": {"diffuse": [0.05, 0.055, 0.06], "specular": [0.35, 0.33, 0.3], "shininess": 30,
                                           "maps": {"normal": str(TEXTURES / "stone_tiles_normal.png")}}}],
                 "lights": [{"type": "directional", "direction": [0.1, -0.75, 0.7], "intensity": 0.7}],
                 "ambient": [0.1, 0.11, 0.13]}
        truth = self.draw(floor, "--samples", "256", "--filter", "renormalised", name="truth")
        fewer = self.draw(floor, "--samples", "144", "--filter", "renormalised", name="fewer")
        toksvig = self.flip(truth, self.draw(floor, "--filter", "toksvig"))
        renormalised = self.flip(truth, self.draw(floor, "--filter", "renormalised"))
        self.assertLess(self.flip(truth, fewer), 0.25 * renormalised)
        self.assertLess(toksvig, 0.75 * renormalised)
