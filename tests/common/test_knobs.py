"""Every chapter draws with every knob that it has, its modules' too, at the ends of its range, in each of its choices, on
and off; and a knob that never changes a picture is a finding.
"""
import tempfile
import unittest

from picture_drawing import BUILT, CHAPTERS, Drawer, cheap, knobs_of, sets


# Values in place of the ends for chapters that borrow the knob: their scenes have many more triangles and lights than that
# of the chapter whose knob it is, and draw seconds for one picture there.
BORROWED = {"maps.subdivide": ["1", "2"], "shadow.resolution": ["16", "512"], "shadow.blur": ["0", "4"],
            "rays.truth_samples": ["1", "4"], "shadow.taps": ["1", "64"], "shadow.search_taps": ["1", "64"],
            "maps.steps": ["1", "64"], "julia.iterations": ["1", "64"], "skin.map_size": ["0", "64"],
            "skin.sky_rays": ["1", "4"], "skin.sky_size": ["16", "32"], "dof.views": ["1", "4"],
            "environment.turn_deg": ["0", "90"]}


def settings_of(knob, borrowed: bool) -> list[str]:
    """The values to try: as --set takes them."""
    if borrowed and knob["name"] in BORROWED:
        return BORROWED[knob["name"]]
    if knob["type"] == "switch":
        return ["on", "off"]
    if "options" in knob:
        return knob["options"]
    if knob["name"] == "samples":
        return ["2", "7"]  # the end is 4,096 pictures
    count = len(knob["default"]) if isinstance(knob["default"], list) else 1
    return [",".join([str(int(end) if knob["type"] == "whole number" else end)] * count) for end in knob["range"]]


# What else is set with those that begin so. A window reads as many texels as its width's square: it refuses the default
# width. The others cost seconds by the product of several knobs, of which the rest is then small.
WITH = {"bloom.method=window": ["sigma_px=4"], "skin.sky_rays=1024": ["skin.sky_size=16"],
        "skin.map_size=4096": ["skin.sky_rays=1", "skin.method=gaussians_1", "shadow.method=none"],
        "skin.": ["skin.sky_rays=1"],
        "maps.mesh=displaced": ["maps.subdivide=2"], "finish.width=4096": ["finish.bake_rays=1"]}


def others_of(setting: str) -> list[str]:
    return next((others for begin, others in WITH.items() if setting.startswith(begin)), [])


# What makes a chapter use a knob, by how the knob's name begins; the longest beginning counts. Set where the chapter has
# it.
USED_WITH = {
    "shadow.blur": ["shadow.method=evsm"], "shadow.format": ["shadow.method=evsm"], "shadow.mips": ["shadow.method=evsm"],
    "shadow.exponent": ["shadow.method=evsm"], "shadow.bleed": ["shadow.method=vsm"],
    "shadow.min_variance": ["shadow.method=vsm"], "shadow.moment_bias": ["shadow.method=msm"],
    "shadow.taps": ["shadow.method=pcss"], "shadow.search_taps": ["shadow.method=pcss"],
    "shadow.slope": ["shadow.receiver_plane=off"], "shadow.normal_offset": ["shadow.receiver_plane=off"],
    "lights.fade_k": ["lights.falloff=range_fade"],
    "lights.threshold": ["lights.falloff=inverse_square", "lights.method=clustered"],
    "wrap": ["diffuse=wrapped"], "bloom.": ["bloom.cut=none"], "bloom.knee": [], "bloom.threshold": [],
    "bloom.truncation": ["bloom.method=separable", "bloom.cut=none"],
    "bloom.border": ["bloom.method=separable", "bloom.cut=none"], "bloom.method": ["bloom.cut=none"],
    "dof.": ["dof.method=gather"], "dof.views": ["dof.method=lens"],
    "post.blur_": ["post.radial_blur=on"], "post.mouse": ["post.radial_blur=on"], "post.aberration_": ["post.aberration=on"],
    "post.kernel": ["post.sharpen=on"], "post.sharpen_by": ["post.sharpen=on"], "post.stops": ["post.exposure=fixed"],
    "post.automatic.": ["post.exposure=automatic"], "post.white_k": ["post.white_balance=on"],
    "post.contrast_by": ["post.contrast=on"], "post.brightness_by": ["post.brightness=on"],
    "post.saturation_by": ["post.saturation=on"], "post.greyscale_by": ["post.greyscale=on"],
    "post.invert_by": ["post.invert=on"], "post.vignette_": ["post.vignette=on"], "post.scan_": ["post.scanlines=on"],
    "post.fade_": ["post.fade=on"], "post.gamma_by": ["post.gamma=on"], "post.grain_by": ["post.grain=white"],
    "mlaa.search": ["mlaa.method=fxaa_like"], "viewer.": ["show=level"], "half_plane.": ["world=half_plane"],
    "terrain.": ["world=terrain"], "julia.": ["world=julia"], "environment.": ["world=julia"], "skin.": ["world=head"],
    "fog.": ["fog.method=height", "fog.density=0.0001"], "planet.": [], "atmosphere.turbidity": ["atmosphere.method=preetham"],
    "spot_x": ["source=spot"], "level": ["show=level"], "gain": ["show=spread"], "backdrop": ["world=head"],
    "sphere_shadow.": ["sphere_shadow.method=exact"], "maps.subdivide": ["maps.mesh=displaced"],
}


def used_with(name: str, knobs: dict) -> list[str]:
    begin = max((begin for begin in USED_WITH if name.startswith(begin)), key=len, default="")
    return [one for one in USED_WITH.get(begin, []) if one.split("=")[0] in knobs and one.split("=")[0] != name]


# Chapters whose knobs are all looked at, borrowed ones as well. In the others a knob is tried in the first chapter that has
# it, and need only be accepted: their pictures cost minutes.
LOOKED_AT = ("01", "02", "03", "04")
# Those that by design change nothing in the chapter's own scene, and why; "NN NAME" for one chapter.
SILENT = {
    "01 loader": "all read one file alike",
    "lights.method": "they draw equal pictures (test_equal_methods.py)",
    "lights.slices": "says how many lights a pixel computes, not what they shed",
    "maps.scroll": "nothing has flowed at 0 s",
} | {f"04 maps.{name}": "no material of its scene has such a map"
     for name in ("displacement", "displacement_m", "detail_normal", "detail_tiles", "opacity", "coverage", "cutoff",
                  "emissive", "orm", "occlusion", "gloss")}


@unittest.skipUnless(BUILT, "the chapters are not built")
class KnobsTest(unittest.TestCase):
    def test_every_knob_at_its_ends_and_what_it_changes(self):
        silent, known = [], set()
        for chapter in CHAPTERS:
            knobs, looked_at = knobs_of(chapter), chapter.startswith(LOOKED_AT)
            with tempfile.TemporaryDirectory() as folder, Drawer(chapter, folder) as drawer:
                drawn = {}  # pictures by what is set: each is drawn once

                def draw(*settings):
                    if settings not in drawn:
                        picture, wrong = drawer.draw(*cheap(chapter), *sets(*settings), "--size", "32x24")
                        with self.subTest(chapter=chapter, set=settings):
                            self.assertEqual(wrong, "")
                        drawn[settings] = picture.read_bytes() if picture.exists() else b""
                    return drawn[settings]

                for name, knob in knobs.items():
                    if name in known and not looked_at:
                        continue
                    used = used_with(name, knobs) if looked_at else []
                    pictures = {draw(*used, *others_of(setting), setting)
                                for setting in (f"{name}={value}" for value in settings_of(knob, name in known))}
                    if looked_at and len(pictures | {draw(*used)}) == 1 and not {name, f"{chapter[:2]} {name}"} & SILENT.keys():
                        silent.append(f"{chapter[:2]} {name}")
            known |= knobs.keys()
        self.assertEqual(silent, [], "they never change a picture; what is so by design stands in SILENT with its reason")


if __name__ == "__main__":
    unittest.main()
