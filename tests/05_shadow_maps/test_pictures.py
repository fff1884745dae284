"""Pictures of chapter 05: the sky of its first scene, and shadows on models of few polygons."""
import json
import math

from PIL import Image, ImageChops, ImageFilter

from parts import Gltf
from pictures import ROOT, ChapterPictures

SCENE = ROOT / "assets/scenes/colonnade_evening.json"
SIDES = 5  # pictures of 80 degrees each
BARE = (255, 0, 255)


class SkyTest(ChapterPictures):
    chapter = "05_shadow_maps"

    def test_no_turn_of_the_camera_shows_a_gap_above_the_horizon(self):
        scene = json.loads(SCENE.read_text())
        x, y, z = scene["camera"]["position"]
        for side in range(SIDES):
            turn, rise = 2 * math.pi * side / SIDES, math.tan(math.radians(8.5))  # from half a degree above the horizon on
            camera = scene["camera"] | {"fov_deg": 16, "target": [x + math.sin(turn), y + rise, z + math.cos(turn)]}
            picture = self.draw(scene | {"camera": camera, "background": [1, 0, 1]}, "--set", "shadow.method=none", size="144x24")
            found = {color: count for count, color in Image.open(picture).convert("RGB").getcolors(144 * 24)}
            self.assertGreater(len(found), 100)
            self.assertNotIn(BARE, found, f"{found.get(BARE)} pixels, {360 * side / SIDES:.0f} degrees around")


def turned(outline, sides):
    """An outline of (radius, height), upwards, turned about the y axis; ends at radius 0 are one point each."""
    points, faces, rows = [], [], []
    for radius, height in outline:
        turns = [2 * math.pi * side / sides for side in range(sides if radius else 1)]
        rows.append([len(points) + i for i in range(len(turns))])
        points += [(radius * math.cos(turn), height, radius * math.sin(turn)) for turn in turns]
    for low, high in zip(rows, rows[1:]):
        for side in range(sides):
            a, b = low[side % len(low)], low[(side + 1) % len(low)]
            c, d = high[(side + 1) % len(high)], high[side % len(high)]
            faces.append(tuple(dict.fromkeys((a, d, c, b))))
    return points, faces


def ball(rings):
    """A ball of `rings` rings, open to no side."""
    inner = [(math.sin(math.pi * i / rings), -math.cos(math.pi * i / rings)) for i in range(1, rings)]
    return turned([(0, -1), *inner, (0, 1)], 2 * rings)


def torus(around, across):
    points = [((1 + 0.45 * math.cos(v)) * math.cos(u) * 0.7, 0.32 * math.sin(v), (1 + 0.45 * math.cos(v)) * math.sin(u) * 0.7)
              for u in (2 * math.pi * i / around for i in range(around)) for v in (2 * math.pi * j / across for j in range(across))]
    at = lambda i, j: i % around * across + j % across  # noqa: E731
    return points, [(at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)) for i in range(around) for j in range(across)]


def box():
    points = [(x, y, z) for x in (-0.8, 0.8) for y in (-0.8, 0.8) for z in (-0.8, 0.8)]
    return points, [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]


SHAPES = {
    "ball_3": ball(3), "ball_4": ball(4), "ball_6": ball(6), "ball_8": ball(8), "ball_12": ball(12), "box": box(),
    "octahedron": turned([(0, -1), (1, 0), (0, 1)], 4), "cone": turned([(0, -0.9), (0.9, -0.9), (0, 1)], 5),
    "prism": turned([(0, -0.8), (0.8, -0.8), (0.8, 0.8), (0, 0.8)], 6), "torus": torus(7, 5),
    "vase": turned([(0, -1), (0.6, -0.9), (0.9, -0.3), (0.4, 0.4), (0.7, 1), (0, 0.8)], 7),
    "drum": turned([(0, -0.5), (1, -0.5), (0.7, 0.5), (0, 0.5)], 9)}


def write_smooth(path, points, faces):
    """An OBJ file whose corners share one normal each, the mean of their faces'."""
    normals = [[0.0, 0.0, 0.0] for _ in points]
    for face in faces:
        for b, c in zip(face[1:], face[2:]):
            u, v = ([points[to][i] - points[face[0]][i] for i in range(3)] for to in (b, c))
            across = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
            for corner in (face[0], b, c):
                normals[corner] = [n + a for n, a in zip(normals[corner], across)]
    lines = ["v %f %f %f" % point for point in points]
    lines += ["vn %f %f %f" % tuple(n / math.hypot(*normal) for n in normal) for normal in normals]
    path.write_text("\n".join(lines + ["f " + " ".join(f"{i + 1}//{i + 1}" for i in face) for face in faces]) + "\n")


# Smooth shapes whose waists and hems are bent inwards: beyond such an edge the surface rises above a triangle's plane.
HOLLOW_SHAPES = {
    "spool": turned([(0, -1), (0.95, -1), (0.6, -0.55), (0.45, 0), (0.6, 0.55), (0.95, 1), (0, 1)], 12),
    "bell": turned([(0, -1), (1, -1), (0.62, -0.75), (0.42, -0.2), (0.3, 0.5), (0, 0.95)], 14),
    "dumb_bell": turned([(0, -1), (0.6, -0.85), (0.75, -0.5), (0.4, -0.15), (0.4, 0.15), (0.75, 0.5), (0.6, 0.85), (0, 1)],
                        10)}


class LowPolyTest(ChapterPictures):
    """Interpolated normals are tilted against their triangles by up to half the angle between two of them."""
    chapter = "05_shadow_maps"

    def pictures(self, shapes, columns, camera, size, *settings):
        """Grey pictures of shapes on a floor, all defaults but for one setting each."""
        matt = {"diffuse": [0.7, 0.7, 0.7], "specular": [0, 0, 0]}
        objects = [{"model": "models/plane.obj", "scale": [30, 1, 30], "material": matt}]
        for i, (name, shape) in enumerate(shapes.items()):
            write_smooth(self.folder / f"{name}.obj", *shape)
            objects.append({"model": str(self.folder / f"{name}.obj"), "material": matt,
                            "position": [3 * (i % columns) - 1.5 * (columns - 1), 1.3, 3.2 * (i // columns) - 3.2]})
        scene = {"ambient": [0.05, 0.05, 0.05], "objects": objects}
        scene["camera"] = {"position": [3, 9, 12], "fov_deg": 36, "near_m": 0.1, "far_m": 100} | camera
        scene["lights"] = [{"type": "directional", "direction": [-0.5, -0.8, -0.45], "intensity": 0.9, "shadow": True}]
        return [Image.open(self.draw(scene, "--set", setting, size=size, name=setting)).convert("L") for setting in settings]

    def test_all_defaults_are_as_rays_on_smooth_shapes_of_few_polygons(self):
        maps, rays = self.pictures(SHAPES, 4, {"target": [0, 0.6, 0]}, "360x240", "visibility=maps", "visibility=rays")
        off = list(ImageChops.difference(maps, rays).getdata())
        far_off = sum(one > 40 for one in off)
        print(f"maps against rays on {len(SHAPES)} shapes: mean {sum(off) / len(off):.3f} codes, {far_off} pixels above 40")
        self.assertLess(sum(off) / len(off), 0.8)
        self.assertLess(far_off, 0.008 * len(off))

    def test_no_edge_bent_inwards_darkens_what_rays_find_lit(self):
        """A filter reads beyond the triangle, whose plane lies behind its neighbour there."""
        camera = {"position": [2, 4.5, 5], "target": [0, 1, -3.2], "fov_deg": 42}
        lit, maps, rays = self.pictures(HOLLOW_SHAPES, 3, camera, "300x180", "shadow.method=none", "visibility=maps",
                                        "visibility=rays")
        # Away from edges of shadows, by four pixels.
        is_lit = ImageChops.difference(lit, rays).point(lambda code: 255 * (code <= 1)).filter(ImageFilter.MinFilter(9))
        darker = list(ImageChops.multiply(ImageChops.subtract(lit, maps), is_lit).getdata())
        print(f"lit by rays: {sum(code > 0 for code in is_lit.getdata())} pixels; maps darken {sum(one > 4 for one in darker)}"
              f" of them by more than 4 codes, by up to {max(darker)}, together by {sum(darker)}")
        self.assertLess(sum(one > 4 for one in darker), 60)


class TwoSidedTest(ChapterPictures):
    chapter = "05_shadow_maps"

    def test_a_closed_surface_looks_the_same_with_both_sides_drawn(self):
        """Of a ball no back is seen; the normals of its corners face away at its outline. Also mirrored."""
        write_smooth(self.folder / "ball.obj", *ball(4))
        for shaded in ("raster", "visibility"):
            for scale in (1, [-1, 1, 1]):
                one, both = [Image.open(self.draw(
                    {"camera": {"position": [0, 0.5, 4], "target": [0, 0, 0], "fov_deg": 35}, "ambient": [0.1, 0.1, 0.1],
                     "objects": [{"model": str(self.folder / "ball.obj"), "scale": scale,
                                  "material": {"diffuse": [0.7, 0.7, 0.7], "two_sided": two_sided}}],
                     "lights": [{"type": "directional", "direction": [-1, -0.5, -0.4]}]},
                    "--set", f"shaded={shaded}", size="96x96")).convert("L") for two_sided in (False, True)]
                with self.subTest(shaded=shaded, scale=scale):
                    self.assertGreater(max(one.getdata()), 150)
                    self.assertEqual(sum(code > 2 for code in ImageChops.difference(one, both).getdata()), 0)


class HoleTest(ChapterPictures):
    """Holes let the sun through, whatever cuts them: by maps and by rays."""
    chapter = "05_shadow_maps"
    UPRIGHT = [[0, 1], [1, 1], [1, 0], [0, 0]]
    MIRRORED = [[1, 1], [0, 1], [0, 0], [1, 0]]

    def pane(self, name, *, uv=UPRIGHT, second=None, alphas=None, factor=1.0, texture=None, sampler=None) -> dict:
        """A square from -1 to 1 with a cutoff of .5 whose left half is meant to be a hole."""
        color = {"baseColorFactor": [1, 1, 1, factor]}
        if texture is not None:
            color["baseColorTexture"] = {"index": 0, **texture}
        gltf = Gltf({"pbrMetallicRoughness": color, "alphaMode": "MASK"}, camera=False)
        gltf.texture({"uri": "half.png"}, sampler).uses("KHR_texture_transform")
        attributes = gltf.primitive()["attributes"]
        more = {"TEXCOORD_0": uv, "TEXCOORD_1": second, "COLOR_0": alphas and [[1, 1, 1, a] for a in alphas]}
        attributes |= {name: gltf.floats(rows) for name, rows in more.items() if rows}
        gltf.write(str(self.folder / f"{name}.gltf"))
        return {"model": str(self.folder / f"{name}.gltf"), "rotation_deg": [-90, 0, 0]}

    def test_the_sun_shines_through_the_half_that_is_cut_out(self):
        half = Image.new("RGBA", (64, 64), (255, 255, 255, 255))
        half.paste((255, 255, 255, 0), (0, 0, 32, 64))
        half.save(self.folder / "half.png")
        mirror = {"KHR_texture_transform": {"scale": [-1, 1], "offset": [1, 0]}}
        panes = [self.pane("texture", texture={}),
                 self.pane("moved", uv=self.MIRRORED, texture={"extensions": mirror}),
                 self.pane("second", uv=self.MIRRORED, second=self.UPRIGHT, texture={"texCoord": 1}),
                 self.pane("clamped", uv=[[-1, 1], [2, 1], [2, 0], [-1, 0]], texture={}, sampler={"wrapS": 33071, "wrapT": 33071}),
                 self.pane("colors", alphas=[0, 1, 1, 0]), self.pane("factor", factor=0.3)]
        matt = {"diffuse": [0.7, 0.7, 0.7], "specular": [0, 0, 0]}
        scene = {"camera": {"position": [1, 60, 0], "target": [1, 0, 0], "up": [0, 0, -1], "fov_deg": 16, "near_m": 1, "far_m": 100},
                 "objects": [{"model": "models/plane.obj", "scale": [30, 1, 30], "material": matt}] +
                            [pane | {"position": [0, 2.5, 2.4 * i - 6]} for i, pane in enumerate(panes)],
                 "lights": [{"type": "directional", "direction": [1, -1, 0], "intensity": 0.9, "shadow": True}], "ambient": [0.1, 0.1, 0.1]}
        per_m = 120 / (2 * 60 * math.tan(math.radians(8)))
        for visibility in ("maps", "rays"):
            picture = Image.open(self.draw(scene, "--set", f"visibility={visibility}", size="120x120", silent=False)).convert("L")
            lit = picture.getpixel((118, 2))
            for i, pane in enumerate(panes):
                # Shadows lie as far to the right as the panes are high.
                row = round(60 + per_m * (2.4 * i - 6))
                through, behind = (picture.getpixel((round(60 + per_m * x), row)) for x in (1, 2))
                with self.subTest(pane=pane["model"], visibility=visibility):
                    self.assertAlmostEqual(through, lit, delta=2)
                    if "factor" in pane["model"]:
                        self.assertAlmostEqual(behind, lit, delta=2)
                    else:
                        self.assertLess(behind, lit - 40)


class PaneTest(ChapterPictures):
    chapter = "05_shadow_maps"

    def test_a_pane_has_its_shadows_where_rays_shade_what_is_opaque(self):
        """Transparent surfaces read the maps in both: in a picture of a pane alone nothing else can differ."""
        scene = {"camera": {"position": [0, 3, 4], "target": [0, 0, 0], "fov_deg": 30, "near_m": 0.1, "far_m": 50}, "background": [0.1, 0.2, 0.3],
                 "objects": [{"model": "models/plane.obj", "scale": 6, "material": {"diffuse": [0.8, 0.8, 0.8], "opacity": 0.6}},
                             {"model": "models/sphere.obj", "position": [0, 5, 0]}],
                 "lights": [{"type": "directional", "direction": [0, -1, 0.1], "intensity": 0.9, "shadow": True}]}
        maps, rays, lit = [Image.open(self.draw(scene, "--set", setting, name=setting)).convert("L")
                           for setting in ("visibility=maps", "visibility=rays", "shadow.method=none")]
        self.assertGreater(sum(one > 20 for one in ImageChops.difference(maps, lit).getdata()), 100)  # the ball's shadow is in view
        self.assertEqual(max(ImageChops.difference(maps, rays).getdata()), 0)


class ScaleTest(ChapterPictures):
    """Maps show the shadows that rays find, whatever the scale of the scene and however far it is from the camera."""
    chapter = "05_shadow_maps"

    def codes(self, scale, away=1.0, light="directional", visibility="maps"):
        matt = {"diffuse": [0.7, 0.7, 0.7], "specular": [0, 0, 0]}
        at = lambda *place: [scale * x for x in place]  # noqa: E731
        intensity = 0.9 if light == "directional" or scale < 1 else min(6 * scale * scale, 1e6)
        light = {"type": light, "intensity": intensity, "shadow": True} | (
            {"direction": [-0.5, -0.8, -0.3]} if light == "directional" else {"position": at(1, 3, 0.5), "range_m": 1e5})
        scene = {"camera": {"position": at(0, 2.4 * away, 5 * away), "target": at(0, 0.5, 0), "fov_deg": 40 / away,
                            "near_m": 0.05 * scale * away, "far_m": 100 * scale * away}, "lights": [light],
                 "objects": [{"model": "models/plane.obj", "scale": at(9, 1, 9), "material": matt},
                             {"model": "models/cube.obj", "scale": scale, "position": at(0, 0.5, 0), "material": matt}]}
        falloff = "falloff=" + ("range_fade" if scale < 1 else "inverse_square")  # the inverse square has a least distance
        picture = self.draw(scene, "--set", falloff, "--set", f"visibility={visibility}", size="120x90", silent=False)
        return list(Image.open(picture).convert("L").getdata())

    def test_shadows_scale_with_the_scene(self):
        for light in ("directional", "point"):
            for scale in (0.001, 1, 100, 1000):
                with self.subTest(light=light, scale=scale):
                    right = self.codes(scale, light=light, visibility="rays")
                    dark, bright = min(right), max(right)
                    self.assertGreater(bright - dark, 20, "there is a shadow")
                    off = [abs(a - b) for a, b in zip(self.codes(scale, light=light), right)]
                    self.assertLess(sum(one > 0.25 * (bright - dark) for one in off), 0.01 * len(off))

    def test_coordinates_far_from_the_origin_are_named(self):
        """Floats at 5,000,000 are 0.5 apart (IEEE 754)."""
        model, scene, picture = (self.folder / name for name in ("far.obj", "scene.json", "far.png"))
        for offset, said in ((5e6, "floats are 0.5"), (0, "")):
            points, faces = box()
            model.write_text("".join(f"v {x + offset} {y} {z}\n" for x, y, z in points)
                             + "".join("f " + " ".join(str(i + 1) for i in face) + "\n" for face in faces))
            scene.write_text(json.dumps({"camera": {"position": [offset, 1, 5], "target": [offset, 0, 0]},
                                         "objects": [{"model": str(model)}]}))
            done = self.run_program("--scene", scene, "--size", "16x16", "--screenshot", picture, silent=False,
                                    GALLIVM_PERF="nopt")
            self.assertIn(said, done.stderr)
            self.assertEqual("m apart" in done.stderr, bool(said))

    def test_a_caster_200_m_away_has_its_shadow(self):
        self.assertGreater(sum(code < 40 for code in self.codes(1, away=36)), 200)

    def test_objects_beyond_the_shadows_are_named(self):
        """Not where the distance reaches them, nor where one map holds the whole scene."""
        boxes = lambda *places: [{"model": "models/cube.obj", "scale": 10, "position": [0, 0, z]} for z in places]  # noqa: E731
        file, picture = self.folder / "scene.json", self.folder / "picture.png"
        for objects, options, said in ((boxes(-10, -210), (), True), (boxes(-10, -210), ("--shadow.distance_m", "300"), False),
                                       (boxes(-10), (), False)):
            file.write_text(json.dumps({"camera": {"position": [25, 15, 0], "target": [24, 14.6, -5]}, "objects": objects,
                                        "lights": [{"type": "directional", "direction": [-1, -1, 0], "shadow": True}]}))
            done = self.run_program("--scene", file, *options, "--size", "240x180", "--screenshot", picture, silent=False,
                                    GALLIVM_PERF="nopt")
            self.assertEqual("shadow.distance_m: shadows end 30 m" in done.stderr, said, done.stderr)
