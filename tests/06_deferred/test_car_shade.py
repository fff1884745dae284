"""The shade below the tunnel's car (models/car_shade.glb) against rays through the car's own triangles: how much of the light
from all around, weighted by its cosine, the car keeps from the ground."""
# Builds: nothing
import io
import json
import struct
import unittest
from pathlib import Path

import numpy
from PIL import Image

MODELS = Path(__file__).resolve().parents[2] / "assets" / "models"
RAYS = 48


def car_triangles() -> numpy.ndarray:
    """Corners, metres; glass lets light through."""
    corners, triangles, material = [], [], ""
    for line in (MODELS / "car.obj").read_text().splitlines():
        words = line.split()
        if line.startswith("v "):
            corners.append([float(word) for word in words[1:4]])
        elif line.startswith("usemtl"):
            material = words[1]
        elif line.startswith("f ") and material != "glass":
            face = [int(word.split("/")[0]) - 1 for word in words[1:]]
            triangles += [(face[0], face[k], face[k + 1]) for k in range(1, len(face) - 1)]
    return numpy.array(corners)[numpy.array(triangles)]


def shade() -> tuple[numpy.ndarray, float, float]:
    """The opacity by rows of z and columns of x, and to where it reaches."""
    data = (MODELS / "car_shade.glb").read_bytes()
    length = struct.unpack("<I", data[12:16])[0]
    parts, blob = json.loads(data[20:20 + length]), data[28 + length:]
    view = parts["bufferViews"][parts["images"][0]["bufferView"]]
    picture = Image.open(io.BytesIO(blob[view["byteOffset"]:][:view["byteLength"]]))
    most = parts["accessors"][parts["meshes"][0]["primitives"][0]["attributes"]["POSITION"]]["max"]
    return numpy.asarray(picture)[..., 3] / 255, most[0], most[2]


def hidden(triangles: numpy.ndarray, point: tuple[float, float], numbers: numpy.random.Generator) -> float:
    """The share of rays from a point of the ground that meet a triangle (T. Moeller and B. Trumbore, 1997)."""
    origin = numpy.array([point[0], 0.001, point[1]])
    first, along, beside = triangles[:, 0], triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]
    away = origin - first
    crossed = numpy.cross(away, along)
    far = (beside * crossed).sum(1)
    count = 0
    for i in range(RAYS):
        radius, angle = ((i + numbers.random()) / RAYS) ** 0.5, 2 * numpy.pi * ((0.618034 * i + 0.1 * numbers.random()) % 1)
        ray = numpy.array([radius * numpy.cos(angle), (1 - radius * radius) ** 0.5, radius * numpy.sin(angle)])
        normal = numpy.cross(ray, beside)
        with numpy.errstate(divide="ignore", invalid="ignore"):
            scale = 1 / (along * normal).sum(1)
            u, v, t = (away * normal).sum(1) * scale, (crossed @ ray) * scale, far * scale
        count += bool(((u >= 0) & (v >= 0) & (u + v <= 1) & (t > 0)).any())
    return count / RAYS


class CarShade(unittest.TestCase):
    def test_it_hides_what_the_car_hides(self):
        triangles, numbers = car_triangles(), numpy.random.default_rng(3)
        opacity, reach_x, reach_z = shade()
        rows, columns = opacity.shape
        errors = []
        for x, z in [(0, 0), (-0.6, 1.2), (0.9, 0), (0.4, -2.0), (1.3, -0.4), (0, 2.4)]:
            found = opacity[int((z / reach_z + 1) / 2 * rows), int((x / reach_x + 1) / 2 * columns)]
            right = hidden(triangles, (x, z), numbers)
            errors.append(abs(found - right))
            print(f"at {x}, {z} m: {found:.2f} of the light is kept away, by rays {right:.2f}")
        self.assertLess(sum(errors) / len(errors), 0.05)
        self.assertLess(max(errors), 0.12)

    def test_it_ends_without_an_edge(self):
        opacity, _, _ = shade()
        border = numpy.concatenate([opacity[0], opacity[-1], opacity[:, 0], opacity[:, -1]])
        self.assertLess(border.max(), 0.01)


if __name__ == "__main__":
    unittest.main()
