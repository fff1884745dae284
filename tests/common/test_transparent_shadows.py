"""Shadows of transparent surfaces: the transmittance of sheets is a product, by colour, in every chapter that draws
transparent surfaces, for any drawing of the others; an object before a sheet has none of its shadow."""
import json
import unittest

from PIL import Image

from folder_case import FolderCase
from picture_drawing import BUILT, HAS_SOLUTION, Drawer, sets, thing

RED, GREEN = ([0.9, 0.2, 0.1], 0.6), ([0.1, 0.7, 0.3], 0.3)
LIGHTS = {"sun": {"type": "directional", "direction": [1, -1, 0], "intensity": 0.7, "shadow": True},
          "spot": {"type": "spot", "position": [-20, 20, 0], "direction": [1, -1, 0], "intensity": 400, "range_m": 100,
                   "inner_deg": 20, "outer_deg": 30, "shadow": True}}


def scene(light: dict, sheets: list) -> dict:
    """A floor seen from above, and level sheets over its left half, 1 m and 2 m high, with shadows 1 m and 2 m to the
    right: at x = 0.5 of both, at 1.5 of the upper one; at -3.4 the lower sheet is seen."""
    objects = [thing("ground", [0, 0, 0], name="floor", material={"diffuse": [0.8, 0.8, 0.8]})]
    for height, (color, opacity, *tint) in enumerate(sheets, 1):
        objects.append(thing("plane", [-2, height, 0], name=f"sheet {height}", scale=4,
                             material={"diffuse": color, "opacity": opacity} | ({"transmission": tint[0]} if tint else {})))
    return {"camera": {"position": [0, 10, 0], "target": [0, 0, 0], "up": [0, 0, -1], "fov_deg": 40, "near_m": 1,
                       "far_m": 40},
            "background": [0, 0, 0], "ambient": [0, 0, 0], "objects": objects, "lights": [light]}


def passes(color: list, opacity: float) -> list[float]:
    """05_shadow_maps/passed.frag"""
    return [(1 - opacity) * (1 - opacity + opacity * c) for c in color]


def linear(code: int) -> float:
    share = code / 255
    return share / 12.92 if share <= 0.04045 else ((share + 0.055) / 1.055) ** 2.4


@unittest.skipUnless(BUILT and HAS_SOLUTION, "needs the programs and the reference solutions")
class TransparentShadows(FolderCase):
    def shares(self, drawer: Drawer, light: str, sheets: list, *settings: str) -> dict:
        """The share of the light on the floor at places along x, by colour."""
        file = self.folder / "scene.json"
        found = []
        for these in (sheets, []):
            file.write_text(json.dumps(scene(LIGHTS[light], these)))
            picture, wrong = drawer.draw("--scene", str(file), "--size", "200x100", *sets(*settings))
            self.assertEqual(wrong, "")
            with Image.open(picture) as image:
                pixels = image.convert("RGB").load()
            # 10 m below the eye a pixel is 2 * 10 * tan(20 deg) / 100 m wide.
            found.append({x: [linear(code) for code in pixels[100 + round(x / 0.0728), 50]] for x in (-1.0, 0.5, 1.5, 3.0)})
        return {x: [a / b for a, b in zip(found[0][x], found[1][x])] for x in found[0]}

    def assert_near(self, got: list, expected: list, why):
        for a, b in zip(got, expected):
            self.assertAlmostEqual(a, b, delta=0.012, msg=f"{why}: {got} and not {expected}")

    def test_what_sheets_let_through_is_multiplied(self):
        both = [a * b for a, b in zip(passes(*RED), passes(*GREEN))]
        for chapter, method in (("05_shadow_maps", "pcf"), ("05_shadow_maps", "evsm"), ("06_deferred", "pcf"),
                                ("14_environment", "pcf")):
            tones = ("post.tone=clamp",) if chapter[:2] == "14" else ()
            with Drawer(chapter, self.folder) as drawer:
                for light in LIGHTS:
                    why = f"{chapter} {method} {light}"
                    shares = self.shares(drawer, light, [RED, GREEN], "shadow.transparent=colored",
                                         f"shadow.method={method}", *tones)
                    self.assert_near(shares[0.5], both, why)
                    self.assert_near(shares[1.5], passes(*GREEN), why)
                    self.assert_near(shares[3.0], [1, 1, 1], why)

    def test_a_materials_own_transmission_filters_light_and_view(self):
        """Glass without a body: at x = 0.5 the sun came through both sheets, at -1 it is also seen through both."""
        red, green = [0.9, 0.5, 0.3], [0.4, 0.8, 0.6]
        sheets = [([0.8, 0.1, 0.1], 0, red), ([0.1, 0.8, 0.1], 0, green)]
        product = [a * b for a, b in zip(red, green)]
        for chapter in ("05_shadow_maps", "06_deferred"):
            with Drawer(chapter, self.folder) as drawer:
                shares = self.shares(drawer, "sun", sheets, "shadow.transparent=colored")
                self.assert_near(shares[0.5], product, chapter)
                self.assert_near(shares[-1.0], [share * share for share in product], chapter)
                self.assert_near(shares[1.5], green, chapter)

    def test_none_is_none(self):
        with Drawer("05_shadow_maps", self.folder) as drawer:
            for settings in (("shadow.transparent=none",), ("shadow.transparent=colored", "shadow.method=none")):
                shares = self.shares(drawer, "sun", [RED, GREEN], *settings)
                for x in (0.5, 1.5, 3.0):  # beside the sheets
                    self.assert_near(shares[x], [1, 1, 1], settings)

    def test_a_sheet_is_in_the_shadow_of_what_is_above_it_alone(self):
        """Two sheets of which the lower is nearly opaque: where the upper one's shadow ends on it, it is as bright as alone."""
        lower, upper = ([0.8, 0.8, 0.8], 0.95), GREEN
        with Drawer("05_shadow_maps", self.folder) as drawer:
            pictures = []
            for sheets in ([lower], [lower, upper]):
                file = self.folder / "scene.json"
                made = scene(LIGHTS["sun"], sheets)
                if len(sheets) == 2:  # far to the left: its shadow reaches the left half of the lower sheet
                    made["objects"][-1]["position"][0] = -5
                file.write_text(json.dumps(made))
                picture, wrong = drawer.draw("--scene", str(file), "--size", "200x100", *sets("shadow.transparent=colored"))
                self.assertEqual(wrong, "")
                pictures.append(Image.open(picture).convert("RGB").load())
            # 9 m below the eye: x = -1 is lit on the lower sheet, x = -2.7 lies below the upper one's shadow.
            at = {x: 100 + round(x / 0.0655) for x in (-1, -2.7)}
            self.assertEqual(pictures[0][at[-1], 50], pictures[1][at[-1], 50])
            before, after = (linear(picture[at[-2.7], 50][0]) for picture in pictures)
            self.assertAlmostEqual(after / before, passes(*upper)[0], delta=0.03)
