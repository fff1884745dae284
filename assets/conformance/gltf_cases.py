"""Cases of glTF."""

import base64
import math
import struct

from parts import BLUE, GREEN, RED, YELLOW, Gltf, case, corners, png

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
down = {"index": 0, "extensions": {"KHR_texture_transform": {"scale": [1, 2]}}}
seen("wrap along v", Gltf(unlit(baseColorTexture=down)).texture({"uri": "corners.png"}, {"wrapS": 10497, "wrapT": 33071}),
     "clamped along v alone", [[0.25, 0.125, RED], [0.25, 0.4, BLUE], [0.25, 0.6, BLUE]])
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
seen("alpha opaque factor", Gltf(unlit(baseColorFactor=[1, 0, 0, 0])), "nor does alpha 0 of the factor", [[0.5, 0.5, RED]])
for cutoff, left in ((0.25, "a quarter"), (0.75, "three quarters")):
    seen(f"alpha cutoff {cutoff}", Gltf({**unlit(**TEXTURED), "alphaMode": "MASK", "alphaCutoff": cutoff}).texture(
        {"uri": "alpha.png"}), f"{left} of the square is cut away",
        [[cutoff + 0.1, 0.5, RED]], holes=[[cutoff - 0.1, 0.5]])
mixed = Gltf({**unlit(baseColorFactor=[1, 0, 0, 0.5]), "alphaMode": "BLEND"})
seen("alpha blend", mixed, "half of what lies behind shows through", [], mixed_with=[0.5, 0.5, [255, 0, 0], 0.5])
glass = {"pbrMetallicRoughness": {"baseColorFactor": [0.5, 1, 0.25, 1], "metallicFactor": 0},
         "extensions": {"KHR_materials_transmission": {"transmissionFactor": 1}}}
seen("transmission", Gltf(glass).uses("KHR_materials_transmission"), "the base colour filters what lies behind", [],
     filtered=[0.5, 0.5, [0.5, 1, 0.25]])
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


def animated(kind, values):
    """A red square of a quarter's width that starts at the left."""
    gltf = Gltf(unlit(baseColorFactor=[1, 0, 0, 1]))
    gltf.json["nodes"][0]["scale"] = [0.25, 1, 1]
    gltf.json["animations"] = [{"channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}], "samplers": [
        {"input": gltf.floats([[0], [1], [2]]), "output": gltf.floats(values), "interpolation": kind}]}]
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
bound = skinned()
bound.json["skins"][0]["inverseBindMatrices"] = bound.floats(
    [[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, 0, 0, 1] for x in (0, -2)])
seen("skin with inverse bind matrices", bound, "both joints are where they were bound",
     [[0.05, 0.05, RED], [0.95, 0.05, RED], [0.05, 0.95, RED]])
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
Gltf({"extensions": {"KHR_materials_sheen": {"sheenRoughnessFactor": 1}}}, camera=False).uses(
    "KHR_materials_sheen").write("sheen.gltf")
case("sheen", "sheen.gltf", "named as left out", [], warned="KHR_materials_sheen (1 material)")
Gltf({}, camera=False).uses("VENDOR_of_tomorrow", required=True).write("required_unknown.gltf")
case("required extension", "required_unknown.gltf", "glTF 2.0, 3.12: must fail", [], refused="VENDOR_of_tomorrow")
next_version = Gltf({}, camera=False)
next_version.json["asset"] = {"version": "2.1", "minVersion": "2.1"}
next_version.write("next_version.gltf")
case("minVersion", "next_version.gltf", "glTF 2.0, 3.2: must fail", [], refused="2.1")
