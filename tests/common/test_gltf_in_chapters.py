"""What glTF 2.0 states of alpha, and KHR_lights_punctual of lights, holds in every chapter that lights such files."""
# Builds: 02_lambert_phong 03_attenuation 04_surface_maps 05_shadow_maps 06_deferred 14_environment 15_terrain_water 18_playground
import functools
import math
import os

from PIL import Image

from parts import Gltf
from picture_drawing import cheap, sets
from pictures import LINEAR, ChapterPictures

os.environ.setdefault("GALLIVM_PERF", "nopt")

LINEAR_TONES = ("post.tone=off", "bloom.method=none")
PLASTIC = {"metallicFactor": 0, "roughnessFactor": 1}
UNLIT = {"KHR_materials_unlit": {}}


def turned(degrees):
    """About the x axis."""
    return [math.sin(math.radians(degrees) / 2), 0, 0, math.cos(math.radians(degrees) / 2)]


class File(ChapterPictures):
    settings = ()

    def seen(self, gltf) -> float:
        """Linear light in the middle of what the file's own camera sees."""
        model, picture = self.folder / "model.gltf", self.folder / "picture.png"
        gltf.write(str(model))
        self.run_program("--scene", model, "--camera-of-file", "1", *cheap(self.chapter), *sets(*self.settings),
                         "--size", "33x33", "--screenshot", picture, silent=False)
        return LINEAR[Image.open(picture).convert("RGB").getpixel((16, 16))[0]]


def lit_from_above(light, height, slant):
    """A matt white square of 4 m below one light of KHR_lights_punctual, seen from above."""
    gltf = Gltf({"pbrMetallicRoughness": PLASTIC}, camera=False).uses("KHR_lights_punctual")
    return with_nodes(gltf, light, [{"mesh": 0, "scale": [2, 2, 1], "rotation": turned(-90)},
                                    {"translation": [0, height, 0], "rotation": turned(-90 + slant)},  # it shines along its -z
                                    {"camera": 0, "translation": [0, 3, 0], "rotation": turned(-90)}], 0.35)


def with_nodes(gltf, light, nodes, yfov):
    """With the light in the second of these nodes."""
    nodes[1]["extensions"] = {"KHR_lights_punctual": {"light": 0}}
    gltf.json |= {"scenes": [{"nodes": list(range(len(nodes)))}], "nodes": nodes,
                  "extensions": {"KHR_lights_punctual": {"lights": [light]}},
                  "cameras": [{"type": "perspective", "perspective": {"yfov": yfov, "znear": 0.1, "aspectRatio": 1}}]}
    return gltf


class Punctual(File):
    """Lights of files have the falloff of KHR_lights_punctual, whatever the scene's own lights have."""
    has_sun = False  # of the sky, in place of the file's first directional light

    @functools.cached_property
    def ambient(self) -> float:
        """A model that is shown alone has ambient light, too."""
        return self.seen(lit_from_above({"type": "point", "intensity": 0}, 1.0, 0.0))

    def middle(self, light, height=1.0, slant=0.0) -> float:
        """Light of the light itself."""
        return self.seen(lit_from_above(light, height, slant)) - self.ambient

    def test_candela_at_a_distance_are_lux(self):
        lux = self.middle({"type": "point" if self.has_sun else "directional", "intensity": 1.2})
        self.assertGreater(lux, 0.2)
        for candela, metres in ((1.2, 1), (0.048, 0.2), (30, 5), (1.2e-6, 0.001)):
            with self.subTest(candela=candela, metres=metres):
                self.assertAlmostEqual(self.middle({"type": "point", "intensity": candela}, metres) / lux, 1, delta=0.02)

    def test_range_and_cone(self):
        bare = self.middle({"type": "point", "intensity": 2})
        self.assertLess(bare, 0.75)  # with ambient light below 1
        ranged = self.middle({"type": "point", "intensity": 2, "range": 1.25})
        self.assertAlmostEqual(ranged / bare, 1 - 0.8 ** 4, delta=0.02)
        cone = {"innerConeAngle": math.radians(10), "outerConeAngle": math.radians(40)}
        share = (math.cos(math.radians(25)) - math.cos(math.radians(40))) / (
            math.cos(math.radians(10)) - math.cos(math.radians(40)))
        spot = self.middle({"type": "spot", "intensity": 2, "spot": cone}, slant=25)
        self.assertAlmostEqual(spot / bare, share ** 2, delta=0.02)


def before_black(material):
    """A square of that material before a black wall, in a light that is off."""
    gltf = Gltf(material, camera=False).uses("KHR_lights_punctual", "KHR_materials_unlit")
    gltf.json["materials"].append({"pbrMetallicRoughness": {"baseColorFactor": [0, 0, 0, 1]}, "extensions": UNLIT})
    gltf.json["meshes"].append({"primitives": [gltf.primitive() | {"material": 1}]})
    return with_nodes(gltf, {"type": "point", "intensity": 0},
                      [{"mesh": 0}, {"translation": [0, 0, 1]}, {"mesh": 1, "translation": [0, 0, -0.5], "scale": [3, 3, 1]},
                       {"camera": 0, "translation": [0, 0, 2]}], 2 * math.atan(0.5))


class Alpha(File):
    """glTF 2.0, 3.9.4: alpha is the share of what lies behind that a surface covers, whatever makes it bright."""

    def test_emission_and_unlit_colour_count_by_alpha(self):
        glow = {"emissiveFactor": [0.9, 0.9, 0.9]}  # with ambient light below 1: a brighter picture is exposed by itself
        for bright, color, more in ((glow, [0, 0, 0], PLASTIC), ({"extensions": UNLIT}, [0.9, 0.9, 0.9], {})):
            for alpha in (0, 0.25, 1):
                with self.subTest(bright, alpha=alpha):
                    pbr = {"baseColorFactor": [*color, alpha], **more}
                    found = self.seen(before_black({"alphaMode": "BLEND", "pbrMetallicRoughness": pbr, **bright}))
                    self.assertAlmostEqual(found, 0.9 * alpha, delta=0.012)  # black plastic reflects ambient light


class Sides(File):
    """glTF 2.0, 3.9.6: of a material with two sides the back is lit with its normal reversed."""

    def test_the_back_is_lit_as_the_front_is(self):
        found = []
        for degrees in (-90, 90):  # about the x axis: its front is above, or its back
            gltf = lit_from_above({"type": "directional", "intensity": 1.2}, 1.0, 0.0)
            gltf.json["materials"][0]["doubleSided"] = True
            gltf.json["nodes"][0]["rotation"] = turned(degrees)
            found.append(self.seen(gltf))
        self.assertGreater(found[0], 0.2)
        self.assertAlmostEqual(found[1], found[0], delta=0.01)


class Metalness(File):
    """glTF 2.0, appendix B: a metalness of one half is half of the plastic and half of the metal."""

    def test_half_a_metal_is_half_of_each(self):
        def seen(metalness):
            gltf = lit_from_above({"type": "point", "intensity": 1.2}, 1.0, 0.0)
            gltf.json["materials"][0]["pbrMetallicRoughness"] = {"metallicFactor": metalness, "roughnessFactor": 1}
            return self.seen(gltf)

        plastic, half, metal = seen(0), seen(0.5), seen(1)
        self.assertGreater(metal, 0.2)
        self.assertAlmostEqual(half, (plastic + metal) / 2, delta=0.015)


class LambertPhong(Sides):
    chapter = "02_lambert_phong"


class Attenuation(Punctual, Sides):
    chapter = "03_attenuation"


class SurfaceMaps(Punctual, Alpha, Sides, Metalness):
    chapter = "04_surface_maps"


class ShadowMaps(Punctual, Alpha):
    chapter = "05_shadow_maps"


class Deferred(Punctual, Alpha):
    chapter = "06_deferred"


class Environment(Punctual, Alpha):
    chapter, settings = "14_environment", LINEAR_TONES


class TerrainWater(Punctual, Alpha):
    chapter, settings, has_sun = "15_terrain_water", (*LINEAR_TONES, "atmosphere.sun_klx=0"), True


class WeightedSums(File):
    """One surface is its own weighted mean, whatever it weighs."""
    chapter = "15_terrain_water"
    settings = (*LINEAR_TONES, "atmosphere.sun_klx=0", "transparency.method=wboit", "transparency.sums=fp32")

    def test_a_faint_surface_far_away_keeps_its_light(self):
        gltf = before_black({"alphaMode": "BLEND", "pbrMetallicRoughness": {"baseColorFactor": [0, 0, 0, 0.02], **PLASTIC},
                             "emissiveFactor": [1, 1, 1], "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 20}}})
        gltf.json["extensionsUsed"].append("KHR_materials_emissive_strength")
        square, _, wall, camera = gltf.json["nodes"]
        square["scale"], wall["scale"], camera["translation"] = [100, 100, 1], [300, 300, 1], [0, 0, 400]
        self.assertAlmostEqual(self.seen(gltf), 0.02 * 20, delta=0.02)


class Playground(Punctual, Alpha):
    chapter, settings = "18_playground", LINEAR_TONES


class DeferredPlayground(Metalness):
    chapter, settings = "18_playground", (*LINEAR_TONES, "gbuffer.method=packed", "surface.model=ggx")


del File, Punctual, Alpha, Sides, Metalness, ChapterPictures  # no tests of their own
