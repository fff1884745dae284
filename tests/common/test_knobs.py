"""Every chapter draws with every knob that it has, its modules' too, at the ends of its range, in each of its choices, on
and off. A knob that never changes a picture is a finding, and so is a picture of a program in which knobs have changed
that differs from the picture of a cold start.
"""
import functools
import json
import tempfile
import unittest
from pathlib import Path

from picture_drawing import BUILT, CHAPTERS, EVERYTHING, ROOT, Drawer, Live, cheap, knobs_of, sets, steps, thing
from shots.rendering import text
from test_equal_methods import EQUAL
from tree import shots

# A small scene for knobs of materials, lights and shadows: a map for every slot, holes, and three kinds of light with
# shadows.
TILES = {"diffuse": "textures/stone_tiles_albedo.jpg", "normal": "textures/stone_tiles_normal.png",
         "height": "textures/stone_tiles_height.png", "specular": "textures/castle_wall_specular.png",
         "gloss": "textures/stone_tiles_specular.png", "emissive": "textures/lava_emissive.jpg",
         "detail_normal": "textures/detail_normal.png"}
MAPPED = {
    "camera": {"position": [0, 1.6, 3.2], "target": [0, 0.4, 0], "fov_deg": 50, "near_m": 0.05, "far_m": 50},
    "ambient": [0.1, 0.1, 0.12], "background": [0.1, 0.2, 0.4],
    "objects": [
        thing("plane", [0, 0, 0], name="floor", scale=4,
              material={"specular": [0.3, 0.3, 0.3], "emissive": [0.1, 0.1, 0.1], "maps": TILES}),
        thing("plane", [0.6, 0.6, -0.4], name="holes", scale=1.4, rotation_deg=[90, 20, 0],
              material={"diffuse": [0.3, 0.3, 0.3], "maps": {"opacity": "textures/squares.png"}}),
        thing("plane", [-0.2, 0.4, -0.7], name="wood", scale=1.2, rotation_deg=[75, 10, 0],
              material={"diffuse": [0.3, 0.3, 0.3], "specular": [0.2, 0.2, 0.2], "maps": {"orm": "textures/wood_orm.png"}}),
        thing("plane", [-0.9, 0.5, 0], name="corners", scale=1, rotation_deg=[70, -20, 0],
              material={"diffuse": [0.6, 0.6, 0.6], "maps": {
                  "diffuse": "textures/stone_tiles_albedo.jpg", "occlusion": "textures/castle_wall_height.png",
                  "displacement": "textures/swell_displacement.png"}})],
    "lights": [
        {"type": "directional", "direction": [0.5, -1, -0.6], "intensity": 0.5, "shadow": True, "size_deg": 2},
        {"type": "spot", "position": [-1.5, 2.2, 1.5], "direction": [0.6, -0.8, -0.6], "intensity": 4, "range_m": 6,
         "inner_deg": 20, "outer_deg": 35, "shadow": True, "size_m": 0.3},
        {"type": "point", "position": [1.2, 1.2, 0.8], "intensity": 1, "range_m": 4, "shadow": True}]}

# A sheet of glass over the floor, with a possibly coloured shadow.
GLASS = {
    "camera": {"position": [0, 2, 3], "target": [0, 0, 0], "fov_deg": 50, "near_m": 0.05, "far_m": 50},
    "objects": [
        thing("plane", [0, 0, 0], name="floor", scale=4, material={"diffuse": [0.8, 0.8, 0.8]}),
        thing("plane", [0, 0.8, 0], name="sheet", scale=1.5, material={"diffuse": [0.9, 0.1, 0.1], "opacity": 0.5})],
    "lights": [{"type": "directional", "direction": [0.2, -1, -0.1], "intensity": 1, "shadow": True}]}
OWN = {"mapped": MAPPED, "everything": EVERYTHING, "glass": GLASS}

# Scenes by the beginning of a knob's name, where no shot of the chapter suits.
SCENES = {"terrain.": "scenes/terrain_noon.json", "maps.": "mapped", "lights.": "mapped", "rays.": "mapped", "shadow.near_m": "mapped",
          "maps.coverage": "scenes/meadow.json", "sphere_shadow.": "scenes/ringed_planet.json",
          "lamp": "mapped", "shadow.transparent": "glass",
          # Chapter 09's own scene has no light with cascades.
          **dict.fromkeys((f"09 shadow.{name}" for name in ("cascades", "split", "distance_m", "snap")), "everything"),
          "mlaa.taa.resample": "scenes/passing.json", "music.": "scenes/beat.json", "sphere.": "scenes/beat.json",
          "planets.flow": "scenes/jupiter.json", "planets.air": "scenes/earth_portrait.json"}


def settings_of(knob: dict, borrowed: bool) -> list[str]:
    """The values to try: as --set takes them."""
    if knob["type"] == "switch":
        return ["on", "off"]
    if "options" in knob:
        return knob["options"]
    if knob["name"] in ("samples", "dof.views", "mlaa.taa.warm_up"):
        return ["2", "7"]  # the end is 256, 4,096 or 65,536 pictures
    if knob["name"] == "town.objects":
        return ["0", "900"]  # the end is a million
    if knob["name"] == "select":
        return ["-1", "0"]  # numbers of objects
    if knob["range"] == [-360, 360]:
        return ["-360", "90", "360"]  # whole turns change nothing
    if borrowed and knob["type"] == "integer" and (half := knob["default"] // 2) > knob["range"][0]:
        return [str(knob["range"][0]), str(half)]  # more triangles and lights than in the knob's own chapter: the upper end takes seconds
    count = len(knob["default"]) if isinstance(knob["default"], list) else 1
    return [",".join([str(int(end) if knob["type"] == "integer" else end)] * count) for end in knob["range"]]


# Additional settings by the beginning of a knob's name. A window reads as many texels as its width's square: it
# refuses the default width. The others cost seconds by the product of several knobs, so the other factors are small.
WITH = {"bloom.method=window": ["sigma_px=4"], "skin.sky_rays=1024": ["skin.sky_size=16"],
        "skin.map_size=4096": ["skin.sky_rays=1", "skin.method=gaussians_1", "shadow.method=none"],
        "skin.": ["skin.sky_rays=1"],
        "maps.mesh=displaced": ["maps.subdivide=2"], "finish.width=4096": ["finish.bake_rays=1"],
        # No wave may be shorter than the shortest.
        "water.longest_m=0.00": ["water.shortest_m=0.01"], "water.shortest_m=1000": ["water.longest_m=1000"]}


def others_of(setting: str) -> list[str]:
    return next((others for begin, others in WITH.items() if setting.startswith(begin)), [])


# Settings that make a chapter use a knob, by the beginning of the knob's name; the longest one counts. Set if the chapter has it.
# A knob that acts in a shot of the chapter, with one option of another knob, at another time or in a scene of OWN needs no entry:
# guesses() finds that.
USED_WITH = {
    "lights.threshold": ["lights.falloff=inverse_square", "lights.method=clustered"],
    "bloom.": ["bloom.method=pyramid", "bloom.cut=none"], "bloom.knee": ["bloom.method=pyramid"], "mlaa.taa.resample": ["mlaa.method=taa", "walk_m_per_s=1.5"],
    "walk_m_per_s": ["time=0.5"],
    "turn_deg_per_s": ["time=0.5"], "terrain.": ["world=terrain"], "fog.": ["fog.method=height", "fog.density=0.0001"],
    "maps.subdivide": ["maps.mesh=displaced", "maps.strength=0"], "lamps.": ["surface.model=ggx"],
    "maps.scroll": ["time=0.3"], **dict.fromkeys(("sphere_shadow.width", "sphere_shadow.power"), ["sphere_shadow.method=power"]),
    "post.scan_speed": ["post.scanlines=on", "time=1.234"],
    "post.store": ["post.method=pass_each", "post.contrast=on", "post.gamma=on"], "sphere.": ["sphere.shown=on", "time=1.5"],
    "volume.wave_speed": ["volume.wave=0.1", "time=1.234"], "volume.shell_speed": ["time=1.234"],
    "planets.flow": ["planets.flow_days=1"], "planets.flow_days": ["planets.flow_period_days=1.7"],
    "flight.": ["flight.on=on", "time=5.5"], "marks.": ["select=0"], "post.white_balance": ["post.white_k=4000"],
    "post.gamma": ["post.gamma_by=2"], "06 lights": ["scene=scenes/field.json"],
}


def own_or_longest(table: dict, chapter: str, name: str, otherwise):
    """Of the entry "NN NAME" or "NN BEGINNING." of the chapter, else of that with the longest beginning."""
    own = f"{chapter[:2]} {name}"
    begins = [begin for begin in table if begin == own or begin.endswith(".") and own.startswith(begin)] or \
        [begin for begin in table if name.startswith(begin)]
    return table[max(begins, key=len)] if begins else otherwise


def used_with(chapter: str, name: str, knobs: dict) -> list[str]:
    """Settings for a knob of a chapter."""
    others = own_or_longest(USED_WITH, chapter, name, [])
    return [one for one in others
            if one.startswith(("time=", "scene=")) or one.split("=")[0] in knobs and one.split("=")[0] != name]


# Every chapter's own knobs are tested by pictures, except for landscapes and the film, where they need only be
# accepted. In the first eleven chapters borrowed ones are tested as well; in the others a knob is tested in the first
# chapter that has it.
LOOKED_AT = ("01", "02", "03", "04", "05", "06", "07", "08", "09", "10", "11")
ACCEPTED = ("15", "19")
# Knobs that by design change nothing in the chapter's own scene, and why; "NN NAME" for one chapter. Those whose values
# test_equal_methods.py shows to be equal need no entry.
SILENT = {
    "mtl.tr": "acts on files that state Tr (tests/01_obj/test_as_written.cpp)",
    **dict.fromkeys(("maps.metallic_roughness", "maps.vertex_colors"), "their files are in the conformance set (./course run --models)"),
    "overdraw": "draws the same surfaces again",
    "07 maps.coverage": "the levels of its textures are its own, and keep coverage",
    "lights.slices": "says how many lights a pixel computes, not what they shed",
    "post.automatic.adapt_s": "the first frame has nothing to adapt from",
    "terrain.stitch": "a crack is far narrower than a pixel of so small a picture",
    "mlaa.count": "counts pixels, and changes none",
    "planets.maps": "says when maps are loaded, not how they look",
    "picker.reach": "acts where somebody clicks",
    "environment.levels.bilinear": "as mips.bilinear", "environment.levels.reduction": "as mips.reduction",
}


# Settings that are not tried in a program that goes on, and why.
COLD_ALONE = {"select=0": "what is selected stays so", "environment.levels.method=none": "levels are left unwritten: those of before stay"}


def are_equal(knob: dict) -> bool:
    """Whether test_equal_methods.py compares all values of the knob that are tried here."""
    return any(set(settings_of(knob, False)) <= set(equal.values) for equal in EQUAL if equal.knob == knob["name"])


def scene_of(chapter: str, name: str) -> list[str]:
    scene = own_or_longest(SCENES, chapter, name, "")
    return [f"scene={scene}"] if scene else []


def options_of(settings, folder: Path) -> tuple[list[str], list[str]]:
    """Of settings as --set takes them, and of a scene=FILE and a time=SECONDS: the options for scene and time, and the
    knobs' settings. The scenes named here lie in the folder."""
    scenes = [setting.removeprefix("scene=") for setting in settings if setting.startswith("scene=")]
    times = [setting.removeprefix("time=") for setting in settings if setting.startswith("time=")]
    return [word for scene in scenes for word in ("--scene", str(folder / f"{scene}.json") if scene in OWN else scene)] + \
        [word for time in times for word in ("--time", time)], \
        [setting for setting in settings if not setting.startswith(("scene=", "time="))]


def path_of(name: str, knobs: dict) -> str:
    """The knob that a shot calls by its path, or by its last word."""
    called = [path for path in knobs if path.rpartition(".")[2] == name]
    return name if name in knobs else next((path for path in called if knobs[path].get("alone")), called[0])


def shown_by(shot: dict, knobs: dict) -> list[str]:
    """The scene, the time and the knobs of a shot."""
    return [f"{key}={shot[word]}" for key, word in (("scene", "scene"), ("time", "time_s")) if word in shot] + \
        [f"{path_of(name, knobs)}={text(value)}" for name, value in shot.get("set", {}).items()]


def guesses(chapter: str, name: str, knobs: dict) -> list[list[str]]:
    """Settings with which a knob may act that changes nothing otherwise: shots of the chapter that name the knob or its module;
    options of its module's knobs; other shots, other options, another time, other scenes."""
    module, _, word = name.rpartition(".")

    def names_it(shot: dict) -> bool:
        said = json.dumps(shot) + ((ROOT / shot["scene"]).read_text() if "scene" in shot else "")
        return f'{word}"' in said or f'"{name.partition(".")[0]}.' in said

    def options(is_near: bool) -> list[list[str]]:
        return [[f"{other}={option}"] for other, knob in knobs.items() if other != name and (other.rpartition(".")[0] == module) == is_near
                for option in knob.get("options", ["on", "off"] if knob["type"] == "switch" else []) if option != text(knob["default"])]
    likely, unlikely = ([shown_by(shot, knobs) for shot in shots(chapter) if names_it(shot) == named] for named in (True, False))
    return [*likely, *options(True), *unlikely, *options(False), ["time=1.5"], *([f"scene={scene}"] for scene in OWN)]


def acts(name: str, values: list[str], used: list[str], draw) -> bool:
    """Whether one of the knob's values draws another picture than its default, with the settings `used`."""
    pairs = ((draw(*used, *others_of(one), one), draw(*used, *others_of(one))) for one in (f"{name}={value}" for value in values))
    return any(None not in pair and pair[0] != pair[1] for pair in pairs)


def silent_knobs(chapter: str, known: set, draw) -> list[str]:
    """The knobs that change no picture. One of the chapter's own is drawn at all its values; one in `known`, which an earlier
    chapter has, until a picture changes."""
    knobs, silent = knobs_of(chapter), []
    for name, knob in knobs.items():
        if name in known and not chapter.startswith(LOOKED_AT):
            continue
        used, changes = scene_of(chapter, name) + used_with(chapter, name, knobs), False
        values = settings_of(knob, name in known)
        for value in values:
            changes |= (not changes or name not in known) and acts(name, [value], used, draw)
        if changes or chapter.startswith(ACCEPTED) or are_equal(knob) or {name, f"{chapter[:2]} {name}"} & SILENT.keys():
            continue
        tried = (list({one.split("=")[0]: one for one in [*used, *guess] if one.split("=")[0] != name}.values())
                 for guess in guesses(chapter, name, knobs))
        found = next((with_guess for with_guess in tried if acts(name, values, with_guess, functools.partial(draw, tries=True))), None)
        if not found:
            silent.append(f"{chapter[:2]} {name}")
        elif name not in known:
            for value in values:
                acts(name, [value], found, draw)
    return silent


@unittest.skipUnless(BUILT, "the chapters are not built")
class KnobsTest(unittest.TestCase):
    """One test a chapter, test_NN_NAME: they do not wait for each other."""

    def try_knobs(self, chapter: str):
        drawn = {}  # pictures by settings: each is drawn once
        known = {name for earlier in CHAPTERS[:CHAPTERS.index(chapter)] for name in knobs_of(earlier)}
        with tempfile.TemporaryDirectory() as folder, Drawer(chapter, folder) as drawer, Live(chapter, folder) as live:
            for name, scene in OWN.items():
                Path(folder, f"{name}.json").write_text(json.dumps(scene))

            def draw(*settings, tries=False):
                """The picture; None where the program refuses settings that are only tried."""
                if settings not in drawn:
                    options, given = options_of(settings, Path(folder))
                    words = [*cheap(chapter), *options]
                    picture, wrong = drawer.draw(*words, *sets(*given), "--size", "32x24")
                    if tries and wrong.startswith("exit code 2:"):
                        return None
                    with self.subTest(set=settings):
                        # A value may be warned of, by the name of its knob.
                        if not wrong.startswith(tuple(f"exit code 0: warning: {one.partition('=')[0]}:" for one in given)):
                            self.assertEqual(wrong, "")
                        if not COLD_ALONE.keys() & set(given):
                            changed, wrong = live.draw(words, (32, 24), set=dict(one.split("=", 1) for one in given))
                            self.assertEqual(wrong, "")
                            self.assertEqual(steps(picture, changed), 0, "changed while it runs, it is not the picture of a cold start")
                    drawn[settings] = picture.read_bytes() if picture.exists() else b""
                return drawn[settings]

            silent = silent_knobs(chapter, known, draw)
        self.assertEqual(silent, [], "they change no picture, alone, in a shot of the chapter or with any one option of another knob. In tests/common/test_knobs.py: "
                                     "USED_WITH has several settings with which a knob acts, SCENES a scene in which it does, SILENT what is "
                                     "so by design, with its reason")


def add_tests():
    for chapter in CHAPTERS:
        setattr(KnobsTest, f"test_{chapter}", lambda self, chapter=chapter: self.try_knobs(chapter))


add_tests()
