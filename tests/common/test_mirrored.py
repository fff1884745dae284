"""Chapters draw mirrored objects as they draw others: the same picture, whichever way the triangles wind."""
from PIL import Image

from pictures import ROOT, ChapterPictures

QUAD = ROOT / "tests" / "common" / "data" / "mirrored.gltf"  # two metres wide, below a node of scale [-1, 1, 1]


class Mirrored(ChapterPictures):
    def draw(self, *options, **keys) -> Image.Image:
        """One white object, lit from the camera by a light of 1/pi that makes its middle white."""
        thing = {"material": {"diffuse": [1, 1, 1], "specular": [0, 0, 0]}} | keys
        scene = {"camera": {"position": [0, 0, 4], "target": [0, 0, 0], "fov_deg": 40}, "background": [0, 0, 1],
                 "ambient": [0, 0, 0], "objects": [thing],
                 "lights": [{"type": "directional", "direction": [0, 0, -1], "intensity": 3.1416}]}
        return Image.open(super().draw(scene, *options, "--validate", "on", size="64x64")).convert("RGB")


class Lit(Mirrored):
    chapter = "02_lambert_phong"

    def test_a_sphere(self):
        whole = self.draw(model="models/sphere.obj")
        self.assertEqual(whole.getpixel((32, 32)), (255, 255, 255))
        for scale in ([-1, 1, 1], [1, 1, -1], -1):
            mirrored = self.draw(model="models/sphere.obj", scale=scale)
            self.assertEqual(mirrored.getpixel((32, 32)), (255, 255, 255))
            self.assertEqual(mirrored.getpixel((2, 2)), whole.getpixel((2, 2)))

    def test_a_quad_below_a_mirrored_node(self):
        for scale in ([1, 1, 1], [-1, 1, 1]):
            self.assertEqual(self.draw(model=str(QUAD), scale=scale).getpixel((32, 32)), (255, 255, 255))

    def test_it_moves(self):
        """At one second the quad has gone to the right."""
        motion = {"path": [{"time_s": 0, "position": [-0.6, 0, 0]}, {"time_s": 1, "position": [0.6, 0, 0]}]}
        for time_s, here, there in ((0, 17, 47), (1, 47, 17)):
            picture = self.draw("--time", str(time_s), model=str(QUAD), scale=0.4, motion=motion)
            self.assertEqual(picture.getpixel((here, 32)), (255, 255, 255))
            self.assertNotEqual(picture.getpixel((there, 32)), (255, 255, 255))


class Attenuated(Mirrored):
    chapter = "03_attenuation"

    def test_a_quad_below_a_mirrored_node(self):
        for method in ("every_light", "per_object", "tiled", "clustered"):
            picture = self.draw("--method", method, model=str(QUAD))
            self.assertEqual(picture.getpixel((32, 32)), (255, 255, 255), method)


class Mapped(Mirrored):
    chapter = "04_surface_maps"

    def test_a_quad_below_a_mirrored_node(self):
        for mesh in ("loaded", "displaced"):
            self.assertEqual(self.draw("--mesh", mesh, model=str(QUAD)).getpixel((32, 32)), (255, 255, 255), mesh)


del Mirrored, ChapterPictures  # no tests of their own
