"""A model without a scene looks right at first sight in every chapter that opens models: it is seen, and no more than a
pixel in a hundred is clipped."""
# Builds: 02_lambert_phong 03_attenuation 04_surface_maps 05_shadow_maps 06_deferred 07_mipmaps 12_skin 14_environment 18_playground
import json
import os
import shutil
import tempfile
import unittest
from pathlib import Path

from PIL import Image, ImageChops

from picture_drawing import cheap
from shots.rendering import Drawing
from tree import ROOT, chapter_program

os.environ.setdefault("GALLIVM_PERF", "nopt")

CHAPTERS = ("02_lambert_phong", "03_attenuation", "04_surface_maps", "05_shadow_maps", "06_deferred", "07_mipmaps",
            "12_skin", "14_environment", "18_playground")
CLIPPED = 0.01
# A white box under the default material; lamps ten times as bright as white, beside a mirror; an OBJ without materials.
LAMPS = {"asset": {"version": "2.0"}, "nodes": [{"mesh": 0}, {"mesh": 1, "translation": [2.5, 0, 0]}],
         "scenes": [{"nodes": [0, 1]}], "extensionsUsed": ["KHR_materials_emissive_strength"], "materials": [
             {"emissiveFactor": [1, 0.8, 0.6], "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 10}}},
             {"pbrMetallicRoughness": {"roughnessFactor": 0.1}}]}


def holes(image) -> int:
    """Pixels that are not red between red ones of their row."""
    count = 0
    for y in range(image.height):
        red = [r > 2 * max(g, b) for r, g, b in (image.getpixel((x, y)) for x in range(image.width))]
        if any(red):
            inside = red[red.index(True):len(red) - red[::-1].index(True)]
            count += len(inside) - sum(inside)
    return count


class BareModels(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        box = json.loads((ROOT / "assets/conformance/flat_normals.gltf").read_text())
        lamps = {**LAMPS, **{key: box[key] for key in ("buffers", "bufferViews", "accessors")}}
        primitive = box["meshes"][0]["primitives"][0]
        lamps["meshes"] = [{"primitives": [{**primitive, "material": i}]} for i in (0, 1)]
        (cls.folder / "lamps.gltf").write_text(json.dumps(lamps))
        # A red floor, which lies on the ground; a texture in its second coordinates has no effect.
        floor = json.loads((ROOT / "assets/conformance/base_colour.gltf").read_text())
        floor["materials"] = [{"pbrMetallicRoughness": {"baseColorFactor": [0.8, 0.02, 0.02, 1], "metallicFactor": 0},
                               "emissiveTexture": {"index": 0, "texCoord": 1}}]
        attributes = floor["meshes"][0]["primitives"][0]["attributes"]
        attributes["TEXCOORD_1"] = attributes["TEXCOORD_0"]
        floor["images"], floor["textures"] = [{"uri": "corners.png"}], [{"source": 0}]
        shutil.copy(ROOT / "assets/conformance/corners.png", cls.folder)
        floor["nodes"], floor["scenes"] = [{"mesh": 0, "rotation": [-0.5 ** 0.5, 0, 0, 0.5 ** 0.5]}], [{"nodes": [0]}]
        (cls.folder / "floor.gltf").write_text(json.dumps(floor))
        # A red metal, whose emission a black texture ends.
        Image.new("RGB", (4, 4)).save(cls.folder / "black.png")
        floor["images"], floor["nodes"] = [{"uri": "black.png"}], [{"mesh": 0}]
        floor["materials"][0]["pbrMetallicRoughness"] = {"baseColorFactor": [0.8, 0.02, 0.02, 1], "roughnessFactor": 0.5}
        floor["materials"][0].update(emissiveFactor=[1, 1, 1], emissiveTexture={"index": 0})
        (cls.folder / "metal.gltf").write_text(json.dumps(floor))
        cls.models = [cls.folder / "floor.gltf", cls.folder / "metal.gltf", ROOT / "assets/conformance/flat_normals.gltf", cls.folder / "lamps.gltf",
                      ROOT / "assets/models/bunny.obj"]

    def test_seen_and_not_clipped(self):
        for chapter in CHAPTERS:
            if not chapter_program(chapter).exists():
                continue
            with Drawing(chapter, "off") as drawing:
                for model in self.models:
                    with self.subTest(chapter=chapter, model=model.name):
                        self.check(drawing, model)

    def check(self, drawing, model):
        picture = self.folder / "picture.png"
        code, wrong, _ = drawing.draw(["--scene", model, "--size", "240x135", *cheap(drawing.chapter)], picture)
        self.assertEqual(code, 0, wrong)
        image = Image.open(picture).convert("RGB")
        pixels = list(image.getdata())
        self.assertLessEqual(sum(max(p) == 255 for p in pixels) / len(pixels), CLIPPED)
        behind = Image.new("RGB", image.size, pixels[0])
        differs = [max(p) > 8 for p in ImageChops.difference(image, behind).getdata()]
        self.assertGreater(sum(differs) / len(differs), 0.03)
        if model.stem == "floor":
            self.assertEqual(holes(image), 0)
        if model.stem == "metal":
            red = [r > 2 * max(g, b) and r > 40 for r, g, b in pixels]
            self.assertGreater(sum(red) / len(red), 0.03)
