"""Parts of the conformance set: cases, PNG and glTF files."""

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
