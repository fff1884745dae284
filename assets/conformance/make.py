#!/usr/bin/env python3
"""Writes the conformance set: one small model file for each property that a format can state, and conformance.json,
which says what is right. Whoever changes it runs it here; its files are in the tree.

Most of the glTF files are an unlit square that fills the picture of the file's own camera: a point of the picture has
then a colour that follows from glTF 2.0 alone. `points`: [x, y, [r, g, b]] with x and y from 0 to 1, from the upper left,
and sRGB from 0 to 255.
"""

import base64
import json
import math
import struct
import zlib
from pathlib import Path

HERE = Path(__file__).resolve().parent
cases = []
RED, GREEN, BLUE, YELLOW = [255, 0, 0], [0, 255, 0], [0, 0, 255], [255, 255, 0]


def case(name, file, says, options=None, **right):
    cases.append({"name": name, "file": file, "says": says, "options": options or [], **right})


def png(name, width, height, texels, channels=3):
    """`texels`: rows from the top, of tuples."""
    rows = b"".join(b"\0" + bytes(sum((list(t) for t in row), [])) for row in texels)
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    kind = {1: 0, 3: 2, 4: 6}[channels]
    data = (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, kind, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))
    (HERE / name).write_bytes(data)
    return data


def corners(left_top=RED, right_top=GREEN, left_bottom=BLUE, right_bottom=YELLOW, size=8):
    half = size // 2
    return [[left_top if x < half else right_top for x in range(size)] if y < half else
            [left_bottom if x < half else right_bottom for x in range(size)] for y in range(size)]


class Gltf:
    """A square from -1 to 1 that faces +z, and a camera that sees just it."""

    def __init__(self, material=None, camera=True, square=True):
        self.data = b""
        self.json = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
                     "meshes": [], "buffers": [], "bufferViews": [], "accessors": []}
        if material is not None:
            self.json["materials"] = [material]
        if square:
            self.mesh({"POSITION": self.floats([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]),
                       "NORMAL": self.floats([[0, 0, 1]] * 4),
                       "TEXCOORD_0": self.floats([[0, 1], [1, 1], [1, 0], [0, 0]])}, self.shorts([0, 1, 2, 0, 2, 3]))
        if camera:
            self.json["cameras"] = [{"type": "perspective", "perspective": {
                "yfov": 2 * math.atan(0.5), "aspectRatio": 1, "znear": 0.1, "zfar": 10}}]
            self.json["nodes"].append({"camera": 0, "translation": [0, 0, 2]})
            self.json["scenes"][0]["nodes"].append(len(self.json["nodes"]) - 1)

    def mesh(self, attributes, indices=None, **more):
        primitive = {"attributes": attributes, **more}
        if indices is not None:
            primitive["indices"] = indices
        if "materials" in self.json:
            primitive["material"] = 0
        self.json["meshes"].append({"primitives": [primitive]})

    def primitive(self):
        return self.json["meshes"][0]["primitives"][0]

    def view(self, data, **more):
        self.data += b"\0" * (-len(self.data) % 4)
        self.json["bufferViews"].append({"buffer": 0, "byteOffset": len(self.data), "byteLength": len(data), **more})
        self.data += data
        return len(self.json["bufferViews"]) - 1

    def accessor(self, data, code, kind, count, **more):
        view = more.pop("view", None)
        self.json["accessors"].append({"bufferView": self.view(data) if view is None else view, "componentType": code,
                                       "type": kind, "count": count, **more})
        return len(self.json["accessors"]) - 1

    def floats(self, rows, **more):
        kind = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4", 16: "MAT4"}[len(rows[0])]
        flat = [x for row in rows for x in row]
        bounds = {"min": [min(c) for c in zip(*rows)], "max": [max(c) for c in zip(*rows)]}
        return self.accessor(struct.pack(f"<{len(flat)}f", *flat), 5126, kind, len(rows), **bounds, **more)

    def shorts(self, numbers, **more):
        return self.accessor(struct.pack(f"<{len(numbers)}H", *numbers), 5123, "SCALAR", len(numbers), **more)

    def texture(self, image, sampler=None):
        self.json["images"] = [image]
        self.json["textures"] = [{"source": 0}]
        if sampler is not None:
            self.json["samplers"], self.json["textures"][0]["sampler"] = [sampler], 0
        return self

    def uses(self, *extensions, required=False):
        self.json["extensionsUsed"] = list(extensions)
        if required:
            self.json["extensionsRequired"] = list(extensions)
        return self

    def write(self, name, uri=None):
        self.json["buffers"] = [{"byteLength": len(self.data)}]
        if name.endswith(".glb"):
            text = json.dumps(self.json, separators=(",", ":")).encode()
            text += b" " * (-len(text) % 4)
            data = self.data + b"\0" * (-len(self.data) % 4)
            whole = struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(data))
            whole += struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(data), b"BIN\0") + data
            (HERE / name).write_bytes(whole)
            return
        if uri:
            (HERE / uri[0]).write_bytes(self.data)
            self.json["buffers"][0]["uri"] = uri[1]
        else:
            self.json["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64.b64encode(self.data).decode()
        (HERE / name).write_text(json.dumps(self.json, indent=1) + "\n")


UNLIT = {"KHR_materials_unlit": {}}
CAMERA = ["--camera-of-file", "1"]


def unlit(**pbr):
    return {"extensions": UNLIT, "pbrMetallicRoughness": pbr}


def seen(name, gltf, says, points, options=(), file=None, **more):
    file = file or name.replace(" ", "_") + ".gltf"
    if gltf is not None:
        gltf.write(file)
    case(name, file, says, CAMERA + list(options), points=points, **more)


four = [[0.25, 0.25, RED], [0.75, 0.25, GREEN], [0.25, 0.75, BLUE], [0.75, 0.75, YELLOW]]
image = png("corners.png", 8, 8, corners())
png("alpha.png", 8, 8, [[[255, 0, 0, 32 * x + 16] for x in range(8)] for _ in range(8)], 4)
TEXTURED = {"baseColorTexture": {"index": 0}}

# Colours and textures.
seen("base colour", Gltf(unlit(baseColorFactor=[0.5, 0.25, 0, 1])).uses("KHR_materials_unlit"),
     "linear 0.5 and 0.25 are 188 and 137 in sRGB", [[0.5, 0.5, [188, 137, 0]]])
seen("texture", Gltf(unlit(**TEXTURED)).texture({"uri": "corners.png"}), "four colours, the first at the upper left", four)
seen("texture in a data URI", Gltf(unlit(**TEXTURED)).texture(
    {"uri": "data:image/png;base64," + base64.b64encode(image).decode()}), "as the texture in a file", four)
inside = Gltf(unlit(**TEXTURED))
inside.texture({"bufferView": inside.view(image), "mimeType": "image/png"})
inside.write("texture_inside.glb")
seen("texture inside a GLB", None, "as the texture in a file", four, file="texture_inside.glb")
escaped = Gltf(unlit(**TEXTURED)).texture({"uri": "corners.png"})
escaped.write("escaped_name.gltf", ("a square.bin", "a%20square.bin"))
seen("escaped file name", None, "%20 in a URI is a space", four, file="escaped_name.gltf")
moved = {"index": 0, "extensions": {"KHR_texture_transform": {"offset": [0.5, 0], "scale": [0.5, 1]}}}
seen("texture transform", Gltf(unlit(baseColorTexture=moved)).texture({"uri": "corners.png"}).uses(
    "KHR_texture_transform", required=True), "the right half of the texture alone",
    [[0.25, 0.25, GREEN], [0.75, 0.25, GREEN], [0.25, 0.75, YELLOW], [0.75, 0.75, YELLOW]])
dark = [0, 0, 0]
png("quadrant.png", 16, 16, [[dark] * 16 for _ in range(8)] + [row + [dark] * 8 for row in corners()])
turned = {"index": 0, "extensions": {"KHR_texture_transform": {"offset": [0, 1], "rotation": math.pi / 2, "scale": [0.5, 0.5]}}}
seen("texture rotation", Gltf(unlit(baseColorTexture=turned)).texture({"uri": "quadrant.png"}).uses("KHR_texture_transform"),
     "the extension's example: the lower left quadrant of the image, rotated clockwise by 90 degrees",
     [[0.25, 0.25, BLUE], [0.75, 0.25, RED], [0.75, 0.75, GREEN], [0.25, 0.75, YELLOW]])
second = Gltf(unlit(baseColorTexture={"index": 0, "texCoord": 1})).texture({"uri": "corners.png"})
second.primitive()["attributes"]["TEXCOORD_1"] = second.floats([[1, 1], [0, 1], [0, 0], [1, 0]])
seen("second texture coordinates", second, "mirrored, as the second coordinates run from right to left",
     [[0.25, 0.25, GREEN], [0.75, 0.25, RED], [0.25, 0.75, YELLOW], [0.75, 0.75, BLUE]])
for wrap, code, colour in (("clamped", 33071, GREEN), ("mirrored", 33648, GREEN), ("repeated", 10497, RED)):
    twice = {"index": 0, "extensions": {"KHR_texture_transform": {"scale": [2, 1]}}}
    seen(f"wrap {wrap}", Gltf(unlit(baseColorTexture=twice)).texture(
        {"uri": "corners.png"}, {"wrapS": code, "wrapT": 33071}), "what lies right of the texture's edge",
        [[0.125, 0.25, RED], [0.375, 0.25, GREEN], [0.6, 0.25, colour]])
seen("nearest filter", Gltf(unlit(**TEXTURED)).texture({"uri": "corners.png"}, {"magFilter": 9728, "minFilter": 9728}),
     "an edge without mixed colours", [[0.485, 0.25, RED], [0.515, 0.25, GREEN]])
coloured = Gltf(unlit())
coloured.primitive()["attributes"]["COLOR_0"] = coloured.accessor(
    bytes([255, 0, 0, 255, 0, 255, 0, 255, 0, 255, 0, 255, 255, 0, 0, 255]), 5121, "VEC4", 4, normalized=True)
seen("vertex colours", coloured, "red at the left, green at the right; halfway both linear 0.5",
     [[0.02, 0.5, [253, 39, 0]], [0.5, 0.5, [188, 188, 0]], [0.98, 0.5, [39, 253, 0]]])

# Alpha and sides.
seen("alpha opaque", Gltf(unlit(**TEXTURED)).texture({"uri": "alpha.png"}), "alpha of the texture means nothing",
     [[0.1, 0.5, RED], [0.9, 0.5, RED]])
for cutoff, left in ((0.25, "a quarter"), (0.75, "three quarters")):
    seen(f"alpha cutoff {cutoff}", Gltf({**unlit(**TEXTURED), "alphaMode": "MASK", "alphaCutoff": cutoff}).texture(
        {"uri": "alpha.png"}), f"{left} of the square is cut away",
        [[cutoff + 0.1, 0.5, RED]], holes=[[cutoff - 0.1, 0.5]])
mixed = Gltf({**unlit(baseColorFactor=[1, 0, 0, 0.5]), "alphaMode": "BLEND"})
seen("alpha blend", mixed, "half of what lies behind shows through", [], mixed_with=[0.5, 0.5, [255, 0, 0], 0.5])
back = Gltf({**unlit(baseColorFactor=[1, 0, 0, 1]), "doubleSided": True})
back.json["nodes"][0]["rotation"] = [0, 1, 0, 0]
seen("double sided", back, "seen from behind", [[0.5, 0.5, RED]])
one_side = Gltf(unlit(baseColorFactor=[1, 0, 0, 1]))
one_side.json["nodes"][0]["rotation"] = [0, 1, 0, 0]
seen("single sided", one_side, "not seen from behind, and the program says why", [], holes=[[0.5, 0.5]], warned="face away")

# Surfaces: emission of a black one, in a light that is off.
def glowing(factor, **extensions):
    glow = Gltf({"emissiveFactor": factor, "extensions": extensions,
                 "pbrMetallicRoughness": {"baseColorFactor": [0, 0, 0, 1], "metallicFactor": 0}})
    glow.json["extensions"] = {"KHR_lights_punctual": {"lights": [{"type": "directional", "intensity": 0}]}}
    glow.json["nodes"][0]["extensions"] = {"KHR_lights_punctual": {"light": 0}}
    return glow


seen("emissive strength", glowing([0.1, 0.05, 0], KHR_materials_emissive_strength={"emissiveStrength": 5}),
     "0.1 times 5 and 0.05 times 5", [[0.5, 0.5, [188, 137, 0]]], steps=12)
for name, pbr, extra in (("metallic roughness texture", {"metallicRoughnessTexture": {"index": 0}}, {}),
                         ("occlusion texture", {"metallicFactor": 0}, {"occlusionTexture": {"index": 0}}),
                         ("normal texture", {"metallicFactor": 0}, {"normalTexture": {"index": 0}}),
                         ("emissive texture", {"metallicFactor": 0},
                          {"emissiveTexture": {"index": 0}, "emissiveFactor": [0.3, 0.3, 0.3]})):
    file = name.replace(" ", "_") + ".gltf"
    Gltf({"pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.4, 0.3, 1], **pbr}, **extra}).texture(
        {"uri": "halves.png"}).write(file)
    case(name, file, "left and right halves differ", CAMERA, differ=[[0.25, 0.5], [0.75, 0.5]])
png("halves.png", 8, 8, [[[128, 64, 255] if x < 4 else [255, 255, 0 if x > 5 else 40] for x in range(8)] for _ in range(8)])
glossy = Gltf({"extensions": {"KHR_materials_pbrSpecularGlossiness": {
    "diffuseFactor": [0, 0, 0, 1], "specularFactor": [0.9, 0.1, 0.1], "glossinessFactor": 0.5}}})
glossy.uses("KHR_materials_pbrSpecularGlossiness").write("specular_glossiness.gltf")
case("specular glossiness", "specular_glossiness.gltf", "a red reflection", CAMERA, reddish=[0.5, 0.5])

# Shape.
quantised = Gltf(unlit(**TEXTURED)).texture({"uri": "corners.png"}).uses("KHR_mesh_quantization", required=True)
quantised.primitive()["attributes"]["POSITION"] = quantised.accessor(
    struct.pack("<16h", -100, -100, 0, 0, 100, -100, 0, 0, 100, 100, 0, 0, -100, 100, 0, 0), 5122, "VEC3", 4,
    view=quantised.view(struct.pack("<16h", -100, -100, 0, 0, 100, -100, 0, 0, 100, 100, 0, 0, -100, 100, 0, 0),
                        byteStride=8), min=[-100, -100, 0], max=[100, 100, 0])
quantised.json["nodes"][0]["scale"] = [0.01, 0.01, 0.01]
seen("quantised positions", quantised, "whole numbers, scaled by their node", four)
strip = Gltf(unlit(**TEXTURED)).texture({"uri": "corners.png"})
strip.primitive().update(mode=5, indices=strip.shorts([0, 1, 3, 2]))
seen("triangle strip", strip, "the same square", four)
sparse = Gltf(unlit(**TEXTURED)).texture({"uri": "corners.png"})
wrong = sparse.floats([[-1, -1, 0], [1, -1, 0], [0, 0, 0], [-1, 1, 0]])
sparse.json["accessors"][wrong]["sparse"] = {
    "count": 1, "indices": {"bufferView": sparse.view(struct.pack("<H", 2)), "componentType": 5123},
    "values": {"bufferView": sparse.view(struct.pack("<3f", 1, 1, 0))}}
sparse.primitive()["attributes"]["POSITION"] = wrong
seen("sparse accessor", sparse, "the third corner stands in the sparse values", four)


def animated(kind, values, times=(0, 1, 2)):
    """A red square of a quarter's width that starts at the left."""
    gltf = Gltf(unlit(baseColorFactor=[1, 0, 0, 1]))
    gltf.json["nodes"][0]["scale"] = [0.25, 1, 1]
    gltf.json["animations"] = [{"channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}], "samplers": [
        {"input": gltf.floats([[t] for t in times]), "output": gltf.floats(values), "interpolation": kind}]}]
    return gltf


LEFT, RIGHT = [-0.75, 0, 0], [0.75, 0, 0]
where = {"left": 0.125, "middle": 0.5, "right": 0.875}
for kind, values, at in (("STEP", [LEFT, RIGHT, LEFT], {0.9: "left", 1.1: "right"}),
                         ("LINEAR", [LEFT, RIGHT, LEFT], {0.5: "middle", 1: "right"}),
                         ("CUBICSPLINE", [[0, 0, 0], LEFT, [0, 0, 0], [0, 0, 0], RIGHT, [0, 0, 0], [0, 0, 0], LEFT,
                                          [0, 0, 0]], {0.5: "middle", 1: "right"})):
    file = f"animation_{kind.lower()}.gltf"
    animated(kind, values).write(file)
    for time, place in at.items():
        case(f"animation {kind} at {time} s", file, f"the square is at the {place}", CAMERA + ["--time", str(time)],
             points=[[where[place], 0.5, RED]], holes=[[where[p], 0.5] for p in where if p != place])
twins = Gltf(unlit(baseColorFactor=[1, 0, 0, 1]))
twins.json["nodes"][0].update(name="twin", scale=[0.25, 1, 1], translation=LEFT)
twins.json["nodes"].append({"name": "twin", "mesh": 0, "scale": [0.25, 1, 1], "translation": [0, 0, 5]})
twins.json["scenes"][0]["nodes"].append(2)
twins.json["animations"] = [{"channels": [{"sampler": 0, "target": {"node": 2, "path": "translation"}}], "samplers": [
    {"input": twins.floats([[0], [1]]), "output": twins.floats([[0, 0, 5], RIGHT])}]}]
seen("two nodes of one name", twins, "the second one moves", [[0.125, 0.5, RED], [0.875, 0.5, RED]], ["--time", "0.99"])

morph = Gltf(unlit(baseColorFactor=[1, 0, 0, 1]))
morph.primitive()["targets"] = [{"POSITION": morph.floats([[2, 0, 0]] * 4)}]
morph.json["meshes"][0]["weights"] = [0.5]
seen("morph weights", morph, "moved to the right by half of 2 m", [[0.75, 0.5, RED]], holes=[[0.25, 0.5]])
moving = Gltf(unlit(baseColorFactor=[1, 0, 0, 1]))
moving.primitive()["targets"] = [{"POSITION": moving.floats([[2, 0, 0]] * 4)}]
moving.json["animations"] = [{"channels": [{"sampler": 0, "target": {"node": 0, "path": "weights"}}], "samplers": [
    {"input": moving.floats([[0], [1]]), "output": moving.floats([[0], [1]])}]}]
seen("moving morph weights", moving, "at 0.5 s moved to the right by half of 2 m", [[0.75, 0.5, RED]], ["--time", "0.5"],
     holes=[[0.25, 0.5]])


def skinned():
    """The joint of the upper corners is 2 m to the right of where it was bound."""
    gltf = Gltf(unlit(baseColorFactor=[1, 0, 0, 1]))
    attributes = gltf.primitive()["attributes"]
    attributes["JOINTS_0"] = gltf.accessor(bytes([0, 0, 0, 0] * 2 + [1, 0, 0, 0] * 2), 5121, "VEC4", 4)
    attributes["WEIGHTS_0"] = gltf.floats([[1, 0, 0, 0]] * 4)
    gltf.json["nodes"] += [{"children": [3]}, {"translation": [2, 0, 0]}]
    gltf.json["scenes"][0]["nodes"].append(2)
    gltf.json["nodes"][0].update(skin=0, translation=[0, 7, 0])  # which a skin takes no notice of
    gltf.json["skins"] = [{"joints": [2, 3]}]
    return gltf


seen("skin", skinned(), "the upper edge is 2 m to the right of the lower one",
     [[0.3, 0.95, RED], [0.95, 0.3, RED]], holes=[[0.1, 0.1], [0.3, 0.3]])
walking = skinned()
walking.json["animations"] = [{"channels": [{"sampler": 0, "target": {"node": 3, "path": "translation"}}], "samplers": [
    {"input": walking.floats([[0], [1]]), "output": walking.floats([[2, 0, 0], [-2, 0, 0]])}]}]
seen("moving skin", walking, "at 0.99 s the upper edge is 2 m to the left", [[0.7, 0.95, RED], [0.05, 0.3, RED]],
     ["--time", "0.99"], holes=[[0.9, 0.1], [0.7, 0.3]])
instances = Gltf(unlit(baseColorFactor=[1, 0, 0, 1])).uses("EXT_mesh_gpu_instancing", required=True)
instances.json["nodes"][0]["extensions"] = {"EXT_mesh_gpu_instancing": {"attributes": {
    "TRANSLATION": instances.floats([LEFT, RIGHT]), "SCALE": instances.floats([[0.25, 1, 1]] * 2)}}}
seen("instances", instances, "two squares", [[0.125, 0.5, RED], [0.875, 0.5, RED]], holes=[[0.5, 0.5]])

# Cameras and lights: a white square under a red light of pi lux shows 1.
lit = Gltf({"pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 1}})
lit.json["extensions"] = {"KHR_lights_punctual": {"lights": [{"type": "directional", "color": [1, 0, 0], "intensity": 1.5}]}}
lit.json["nodes"][1]["extensions"] = {"KHR_lights_punctual": {"light": 0}}
lit.uses("KHR_lights_punctual").write("own_light.gltf")
case("camera and light of the file", "own_light.gltf", "red light of 1.5 lux", CAMERA, reddish=[0.5, 0.5])
case("camera and light not asked for", "own_light.gltf", "said in one line", [], warned="--camera-of-file")

# Named, or refused.
Gltf({"extensions": {"KHR_materials_transmission": {"transmissionFactor": 1}}}, camera=False).uses(
    "KHR_materials_transmission").write("transmission.gltf")
case("transmission", "transmission.gltf", "named as left out", [], warned="KHR_materials_transmission (1 material)")
Gltf({}, camera=False).uses("VENDOR_of_tomorrow", required=True).write("required_unknown.gltf")
case("required extension", "required_unknown.gltf", "glTF 2.0, 3.12: must fail", [], refused="VENDOR_of_tomorrow")
next_version = Gltf({}, camera=False)
next_version.json["asset"] = {"version": "2.1", "minVersion": "2.1"}
next_version.write("next_version.gltf")
case("minVersion", "next_version.gltf", "glTF 2.0, 3.2: must fail", [], refused="2.1")

# Other formats: a square in the bare view.
SQUARE = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
FACE = "usemtl m\nf 1/1 2/2 3/3 4/4\n"
CUBE = "".join(f"v {x} {y} {z}\n" for z in (-1, 1) for y in (-1, 1) for x in (-1, 1))
CUBE_FACES = "f 5 6 8 7\nf 2 1 3 4\nf 6 2 4 8\nf 1 5 7 3\nf 7 8 4 3\nf 1 2 6 5\n"


def obj(name, mtl, file=None, geometry=SQUARE, faces=FACE):
    file = file or name.replace(" ", "_")
    (HERE / f"{file}.mtl").write_text("newmtl m\n" + mtl)
    (HERE / f"{file}.obj").write_text(f"mtllib {file}.mtl\n{geometry}{faces}")
    return f"{file}.obj"


png("disc_alpha.png", 16, 16, [[[255, 255, 255, 255 if (x - 7.5) ** 2 + (y - 7.5) ** 2 < 36 else 0] for x in range(16)]
                               for y in range(16)], 4)
png("disc_grey.png", 16, 16, [[[255 if (x - 7.5) ** 2 + (y - 7.5) ** 2 < 36 else 0] for x in range(16)]
                              for y in range(16)], 1)
png("bumps.png", 16, 16, [[[int(127.5 + 127.5 * math.sin(x * math.pi / 4) * math.sin(y * math.pi / 4))] for x in range(16)]
                          for y in range(16)], 1)
plain = obj("mtl plain", "Kd 1 1 1\nmap_Kd corners.png\n")
case("MTL -s", obj("mtl scale", "Kd 1 1 1\nmap_Kd -s 2 2 1 corners.png\n"), "2 x 2 pictures", unlike=plain)
case("MTL -o", obj("mtl offset", "Kd 1 1 1\nmap_Kd -o 0.5 0 0 corners.png\n"), "moved by half", unlike=plain)
case("MTL -mm", obj("mtl gain", "Kd 1 1 1\nmap_Kd -mm 0.5 0.2 corners.png\n"), "paler", unlike=plain)
case("MTL -clamp", obj("mtl clamp", "Kd 1 1 1\nmap_Kd -clamp on -s 2 2 1 corners.png\n"), "one picture, its edges drawn out",
     unlike="mtl_scale.obj")
case("MTL map_d with alpha", obj("mtl alpha", "Kd .2 .7 .2\nmap_d disc_alpha.png\n"), "the alpha counts, not the red",
     like=obj("mtl grey", "Kd .2 .7 .2\nmap_d disc_grey.png\n"))
case("MTL -imfchan", obj("mtl channel", "Kd .2 .7 .2\nmap_d -imfchan m disc_alpha.png\n"), "the alpha", like="mtl_grey.obj")
case("MTL bump", obj("mtl bump", "Kd .6 .6 .6\nbump -bm 1 bumps.png\n"), "bumps", textured=True)
case("MTL map_Pr", obj("mtl rough", "Kd .9 .6 .2\nmap_Pr halves.png\nmap_Pm halves.png\n"), "roughness and metalness of maps",
     unlike=obj("mtl smooth", "Kd .9 .6 .2\nPr 1\nPm 0\n"))
case("MTL Tr 1", obj("mtl tr", "Kd .8 .2 .2\nTr 1\n"), "drawn opaque, and said", warned="would make it vanish", drawn=True)
case("MTL Kd 255", obj("mtl 255", "Kd 255 51 51\n"), "taken as 0 to 255, and said", warned="expected at most 1",
     like=obj("mtl one", "Kd 1 0.2 0.2\n"))
case("MTL illum 0", obj("mtl constant", "Kd .2 .7 .2\nillum 0\n", geometry=CUBE, faces="usemtl m\n" + CUBE_FACES),
     "one colour, whatever the light", one_colour=True)
case("MTL refl", obj("mtl mirror", "Kd .2 .7 .2\nrefl -type sphere sky.png\n"), "named as left out", warned="refl")
for name, lines in (("smooth", "s 1\n"), ("flat", "s off\n")):
    (HERE / f"obj_{name}.obj").write_text(CUBE + lines + CUBE_FACES)
case("OBJ s off", "obj_flat.obj", "flat faces", unlike="obj_smooth.obj")
for name, text in (("NUL at the end", SQUARE + "f 1 2 3 4\n\0\0\0"), ("v//", SQUARE + "f 1// 2// 3// 4//\n"),
                   ("v/vt/", SQUARE + "f 1/1/ 2/2/ 3/3/ 4/4/\n"), ("curv2", SQUARE + "curv2 1 2\nf 1 2 3 4\n"),
                   ("nan colours", "v 0 0 0 nan nan nan\nv 1 0 0 nan nan nan\nv 0 1 0 nan nan nan\nf 1 2 3\n")):
    file = "obj_" + {"NUL at the end": "nul", "v//": "slashes", "v/vt/": "slash"}.get(name, name.replace(" ", "_")) + ".obj"
    (HERE / file).write_text(text)
    case(f"OBJ {name}", file, "drawn", drawn=True, **({"warned": "free-form curves"} if name == "curv2" else {}))
(HERE / "obj_colors.obj").write_text("v -1 -1 0 1 0 0\nv 1 -1 0 0 1 0\nv 1 1 0 0 1 0\nv -1 1 0 1 0 0\nf 1 2 3 4\n")
case("OBJ vertex colours", "obj_colors.obj", "red at the left, green at the right", halves=True)
(HERE / "colors.ply").write_text(
    "ply\nformat ascii 1.0\nelement vertex 4\n" + "".join(f"property float {c}\n" for c in "xyz") +
    "".join(f"property uchar {c}\n" for c in ("red", "green", "blue")) +
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "-1 -1 0 255 0 0\n1 -1 0 0 255 0\n1 1 0 0 255 0\n-1 1 0 255 0 0\n4 0 1 2 3\n")
case("PLY vertex colours", "colors.ply", "red at the left, green at the right", halves=True)
(HERE / "faint.ply").write_text((HERE / "colors.ply").read_text().replace(
    "property uchar blue\n", "property uchar blue\nproperty uchar alpha\n").replace(" 0 0\n", " 0 0 0\n").replace(" 255 0\n", " 255 0 0\n"))
case("PLY opacity 0 everywhere", "faint.ply", "drawn opaque", like="colors.ply")
(HERE / "points.ply").write_text("ply\nformat ascii 1.0\nelement vertex 2\n" + "".join(
    f"property float {c}\n" for c in "xyz") + "end_header\n0 0 0\n1 1 1\n")
case("PLY point cloud", "points.ply", "refused in words that help", refused="point cloud")
facets = [((5, 6, 8), (0, 0, 1)), ((5, 8, 7), (0, 0, 1)), ((2, 1, 3), (0, 0, -1)), ((2, 3, 4), (0, 0, -1)),
          ((6, 2, 4), (1, 0, 0)), ((6, 4, 8), (1, 0, 0)), ((1, 5, 7), (-1, 0, 0)), ((1, 7, 3), (-1, 0, 0)),
          ((7, 8, 4), (0, 1, 0)), ((7, 4, 3), (0, 1, 0)), ((1, 2, 6), (0, -1, 0)), ((1, 6, 5), (0, -1, 0))]
vertex = [None] + [line[2:] for line in CUBE.splitlines()]
(HERE / "cube.stl").write_text("solid cube\n" + "".join(
    f"facet normal {n[0]} {n[1]} {n[2]}\nouter loop\n" + "".join(f"vertex {vertex[i]}\n" for i in t) + "endloop\nendfacet\n"
    for t, n in facets) + "endsolid cube\n")
case("STL", "cube.stl", "flat faces", unlike="obj_smooth.obj")
cube = Gltf({}, camera=False, square=False)
cube.mesh({"POSITION": cube.floats([[float(x) for x in vertex[i].split()] for i in range(1, 9)])},
          cube.shorts([i - 1 for t, _ in facets for i in t]))
cube.write("no_normals.gltf")
own = Gltf({}, camera=False, square=False)
own.mesh({"POSITION": own.floats([[float(x) for x in vertex[i].split()] for t, _ in facets for i in t]),
          "NORMAL": own.floats([list(n) for t, n in facets for _ in t])})
own.write("flat_normals.gltf")
case("glTF without normals", "no_normals.gltf", "glTF 2.0, 3.7.2.1: flat normals", like="flat_normals.gltf")

(HERE / "conformance.json").write_text(json.dumps({"cases": cases}, indent=1) + "\n")
print(len(cases), "cases")
