"""Methods documented as equal draw equal pictures, in every chapter that has their module, in the first frame after a
start: reading an earlier frame's results shows as a difference."""
import json
import unittest
from dataclasses import dataclass
from pathlib import Path

from folder_case import FolderCase
from picture_drawing import BUILT, CHAPTERS, EVERYTHING, HAS_SOLUTION, ROOT, Drawer, cheap, knobs_of, pixels_beyond, sets, steps


@dataclass(frozen=True)
class Equal:
    """The knob's values draw one picture, up to steps of at most `codes` of 255. Two approximations may differ by more in
    a `share` of the pixels. `sets`: settings that make the chapter use the knob. `frames`: drawn up to and including
    the compared picture."""
    knob: str
    values: tuple
    codes: int = 0
    share: float = 0.0
    sets: tuple = ()
    frames: int = 1
    scenes: tuple = ("default", "everything")


LIGHTS = ("every_light", "per_object", "tiled", "clustered")
# A height map moves the point that is lit, and a depth buffer holds the mesh (docs/06_deferred.md).
MESH = "maps.method=normal"
EQUAL = [
    # docs/03: to the last bit, where a falloff ends.
    Equal("lights.method", LIGHTS),
    Equal("lights.method", LIGHTS, sets=("gbuffer.method=forward",)),
    # docs/05: single gives the same picture; a workgroup's shared memory changes the readers, not the result.
    Equal("shadow.fetch", ("single", "gather"), codes=1, share=0.0001, sets=("shadow.method=pcf",)),
    Equal("shadow.blur_by", ("naive", "shared"), sets=("shadow.method=evsm", "shadow.resolution=256")),
    Equal("shadow.keep", ("on", "off"), frames=3),
    # docs/06: at edges of triangles a fragment shader takes another mip level.
    Equal("objects.shaded", ("raster", "visibility"), codes=4, share=0.002),
    Equal("objects.shaded", ("raster", "visibility"), codes=4, share=0.002, sets=("gbuffer.method=forward",)),
    # docs/05: rays of one seed.
    Equal("objects.shaded", ("raster", "visibility"), codes=4, share=0.002, sets=("visibility=rays",), scenes=("default",)),
    Equal("objects.shaded", ("raster", "visibility"), codes=4, share=0.002, sets=("show=wrong",), scenes=("default",)),
    # docs/14: rays for the environment.
    Equal("objects.shaded", ("raster", "visibility"), codes=4, share=0.002, sets=("objects.occlusion=rays",), scenes=("default",)),
    Equal("terrain.shaded", ("raster", "visibility"), codes=4, share=0.002, scenes=("terrain",)),
    Equal("skin.shaded", ("raster", "visibility"), codes=4, share=0.002, scenes=("default",)),
    # docs/06: fat holds all as floats; the others lose bits of normals. Volumes add lights in another order.
    Equal("gbuffer.method", ("forward", "fat"), codes=1, share=0.005, sets=(MESH,)),
    Equal("gbuffer.method", ("fat", "depth", "packed", "tiled"), codes=4, share=0.01, sets=(MESH,)),
    Equal("gbuffer.method", ("packed", "tiled"), codes=1, sets=(MESH,)),
    Equal("gbuffer.volumes", ("on", "off"), codes=1),
    Equal("cull", ("fixed", "geometry"), codes=1),
    # docs/06a: from the frame before, hidden objects; the picture is the same from the first frame on.
    Equal("culling.method", ("none", "frustum_cpu", "frustum_gpu", "occlusion"), sets=("culling.least=0",), frames=3),
    Equal("culling.method", ("none", "frustum_cpu", "occlusion"), sets=("gbuffer.method=forward", "culling.least=0")),
    Equal("culling.bounds", ("box", "sphere"), sets=("culling.least=0", "culling.method=frustum_gpu")),
    Equal("culling.least", ("0", "1000000"), sets=("culling.method=frustum_cpu",)),
    Equal("prepass", ("on", "off")),
    Equal("overdraw", ("1", "3")),
    Equal("order", ("file", "front_to_back", "random", "back_to_front")),
    # docs/07: for a texture with powers of two as sides, 2x2 means; single_pass rounds to codes later than box does.
    Equal("mips.method", ("box", "polyphase")),
    Equal("mips.method", ("box", "single_pass"), codes=4),
    Equal("mips.reduction", ("auto", "shared", "shuffle"), codes=1, sets=("mips.method=single_pass",)),
    Equal("mips.bilinear", ("on", "off"), codes=1, sets=("mips.method=single_pass",)),
    Equal("remake", ("on", "off"), frames=2),
    Equal("remake", ("on", "off")),
    # docs/08: one Gaussian, read in four ways.
    Equal("bloom.method", ("separable", "paired", "shared", "window"), codes=1, sets=("bloom.sigma_px=4",)),
    # docs/09: to the last bit.
    Equal("post.method", ("fused", "pass_each")),
    Equal("post.method", ("fused", "pass_each"),
          sets=("post.contrast=on", "post.saturation=on", "post.vignette=on", "post.dither=bayer_8", "post.exposure=fixed")),
    Equal("atmosphere.refresh", ("changed", "always"), frames=2),
    # uniform is height with a falloff of 0.
    Equal("fog.method", ("uniform", "height"), sets=("fog.falloff=0", "fog.density=0.00003")),
    Equal("terrain.fog.method", ("uniform", "height"), sets=("terrain.fog.falloff=0", "world=terrain"), scenes=("default",)),
    # docs/13: distances double or quadruple, or come from words of edges.
    Equal("mlaa.reads", ("two", "four", "words")),
    # docs/01: they read one file; assimp rounds a normal otherwise.
    Equal("loader", ("textbook", "tinyobjloader", "assimp", "scan", "parallel"), codes=1, scenes=("default",)),
]
# (options, the picture's size); every chapter's own scene, and one with many lights and transparent surfaces, at a
# size that no tile divides. Where things move, the time is one at which they have.
SCENES = {"default": ["--size", "240x135"], "terrain": ["--scene", "scenes/terrain_noon.json", "--size", "192x108"], "everything": ["--size", "127x71", "--time", "0.5"]}
# Of these the other scene is nothing: they draw no objects, or those alone that are skin.
OWN_SCENE_ALONE = ("01", "02", "10", "11", "12")
# And of these the own scene is nothing new: all of these methods are borrowed, and a workbench or a film takes seconds to load.
OTHER_SCENE_ALONE = ("18", "19")


def scenes_of(chapter: str, equal: Equal) -> list[str]:
    return [scene for scene in equal.scenes
            if not chapter.startswith(OWN_SCENE_ALONE if scene == "everything" else OTHER_SCENE_ALONE)]


def usable(equal: Equal, knobs: dict) -> tuple | None:
    """Settings beside the knob; None if the chapter lacks a requirement."""
    if equal.knob not in knobs or not set(equal.values) <= set(knobs[equal.knob].get("options", equal.values)):
        return None
    needed = (one.split("=") for one in equal.sets if one != MESH)
    return equal.sets if all(name in knobs and value in knobs[name].get("options", value) for name, value in needed) else None


def is_default(setting: str, knobs: dict) -> bool:
    name, value = setting.split("=")
    return name in knobs and knobs[name]["default"] in (value, {"on": True, "off": False}.get(value))


@unittest.skipUnless(BUILT and HAS_SOLUTION, "the chapters are not built, or there is no reference")
class EqualMethods(FolderCase):
    def setUp(self):
        self.pictures = {}
        self.scene = self.folder / "everything.json"
        self.scene.write_text(json.dumps(EVERYTHING))

    def picture(self, drawer: Drawer, *options) -> Path:
        picture, wrong = drawer.draw(*options)
        self.assertEqual(wrong, "", f"{drawer.chapter} {' '.join(map(str, options))}")
        return picture

    def drawn(self, drawer: Drawer, equal: Equal, scene: str, value: str, knobs: dict) -> Path:
        """The picture of a value. One scene has no knobs: a default value reuses its picture."""
        options = [*SCENES[scene], *cheap(drawer.chapter), "--frames", str(equal.frames)]
        settings = [*equal.sets, f"{equal.knob}={value}"]
        if scene == "everything":
            options += ["--scene", str(self.scene)]
            if "shadow.resolution" in knobs:  # nine maps of 1,024 texels take longer than all else of the picture
                options += sets("shadow.resolution=256")
            settings = [one for one in settings if not is_default(one, knobs)]
        key = (drawer.chapter, *options, *sorted(settings))
        if key not in self.pictures:
            self.pictures[key] = self.picture(drawer, *options, *sets(*settings))
        return self.pictures[key]

    def compare(self, drawer: Drawer, equal: Equal, scene: str, values: tuple, knobs: dict):
        first, *others = [(value, self.drawn(drawer, equal, scene, value, knobs)) for value in values]
        for value, picture in others:
            with self.subTest(chapter=drawer.chapter, scene=scene, knob=equal.knob, values=(first[0], value), sets=equal.sets):
                if equal.share:
                    self.assertLessEqual(pixels_beyond(first[1], picture, equal.codes), equal.share)
                else:
                    self.assertLessEqual(steps(first[1], picture), equal.codes)

    def test_equal_methods_draw_equal_pictures(self):
        """All values in the first chapter that has them. In later ones the first and the last value, in one scene: that of many
        lights where the chapter draws it. What needs settings or frames of its own is compared there in the last chapter alone."""
        knobs = {chapter: knobs_of(chapter) for chapter in CHAPTERS}
        having = {equal: [chapter for chapter in CHAPTERS if usable(equal, knobs[chapter]) is not None] for equal in EQUAL}
        for chapter in CHAPTERS:
            with Drawer(chapter, self.folder) as drawer:
                for equal in (equal for equal in EQUAL if chapter in having[equal]):
                    scenes, values = scenes_of(chapter, equal), equal.values
                    if chapter != having[equal][0]:
                        is_small = not equal.sets and equal.frames == 1
                        scenes, values = scenes[-1:] if is_small or chapter == having[equal][-1] else [], (values[0], values[-1])
                    for scene in scenes:
                        self.compare(drawer, equal, scene, values, knobs[chapter])
        self.assertEqual([equal for equal in EQUAL if not having[equal]], [])  # a knob that no chapter has any more

    def test_the_scene_shows_what_methods_could_get_wrong(self):
        """Without its lights, its shadows or its transparent surfaces the scene is another picture: it would show."""
        def less(name, change):
            scene = json.loads(json.dumps(EVERYTHING))
            change(scene)
            file = self.folder / f"{name}.json"
            file.write_text(json.dumps(scene))
            return file
        with Drawer(next(chapter for chapter in CHAPTERS if chapter.startswith("05_")), self.folder) as drawer:
            whole = self.picture(drawer, "--scene", self.scene, *SCENES["everything"])
            for file in (less("dim", lambda s: s["lights"].__delitem__(slice(3, None))),
                         less("shadowless", lambda s: [light.pop("shadow", None) for light in s["lights"]]),
                         less("solid", lambda s: [o.get("material", {}).pop("opacity", None) for o in s["objects"]])):
                picture = self.picture(drawer, "--scene", file, *SCENES["everything"])
                self.assertGreater(pixels_beyond(whole, picture, 4), 0.005, file.name)

    def test_a_lens_of_no_width_shows_what_moves_where_a_pinhole_does(self):
        """A screenshot is one frame: the lens's inputs are placed before it is drawn."""
        options = ["--scene", ROOT / "assets/scenes/control_room.json", "--size", "240x135", "--time", "1.5"]
        lens = sets("dof.method=lens", "dof.views=3", "dof.f_number=64")
        with Drawer(next(chapter for chapter in CHAPTERS if chapter.startswith("09_")), self.folder) as drawer:
            pinhole = self.picture(drawer, *options, *sets("dof.method=off"))
            before = self.picture(drawer, *options[:-1], "0", *sets("dof.method=off"))
            self.assertGreater(pixels_beyond(pinhole, before, 8), LENS_SHARE)  # so that it matters where things stand
            self.assertLess(pixels_beyond(pinhole, self.picture(drawer, *options, *lens), 8), LENS_SHARE)


LENS_SHARE = 0.004  # of the pixels: measured 0.015 for 1.5 s of motion
