"""A lamp with a size and the lobe of a rough surface, before and after the linear map that makes the lobe a cosine.

python3 docs/figures/04_lamps.py writes docs/images/04_lamps.svg.
"""

from math import cos, pi, radians, sin, sqrt
from pathlib import Path
from struct import unpack

from drawing import EYE, GREY, INK, LIGHT, MIRROR, NORMAL, SMALL, THIN, Drawing, polar

ROUGHNESS, VIEW = 0.55, 50  # of the surface; of the camera, in degrees from the normal
LAMP = ((0.62, 0.95), (1.28, 0.48))


def table_at(column: float, row: float) -> list[float]:
    """Of assets/tables/ggx.pfm: the six numbers of the nearest texel."""
    data = (Path(__file__).parents[2] / "assets/tables/ggx.pfm").read_bytes().split(b"\n", 3)[3]

    def texel(x: int, y: int):
        return unpack("<3f", data[12 * (64 * (127 - y) + x):][:12])

    x, y = round(63 * column), round(63 * row)
    return [*texel(x, y), *texel(x, 64 + y)]


def draw() -> Drawing:
    drawing = Drawing(900, 340, "Left: the lobe of a rough surface points towards the mirrored direction, and a lamp covers part "
                                "of it. Right: a linear map turns the lobe into the cosine lobe, and the lamp into another lamp")
    n_dot_v = cos(radians(VIEW))
    m11, m13, m31, m33, a, b = table_at(1 - sqrt(1 - n_dot_v), ROUGHNESS)
    alpha = ROUGHNESS * ROUGHNESS

    def ggx(angle: float) -> float:
        """Times n·l, in the plane of the normal and the camera, which is on the left."""
        lx, lz, vx, vz = cos(radians(angle)), sin(radians(angle)), -sin(radians(VIEW)), n_dot_v
        hz = (lz + vz) / sqrt((lx + vx) ** 2 + (lz + vz) ** 2)
        d = hz * hz * (alpha * alpha - 1) + 1
        seen = 0.5 / (vz * sqrt(lz * lz * (1 - alpha ** 2) + alpha ** 2) + lz * sqrt(vz * vz * (1 - alpha ** 2) + alpha ** 2))
        return lz * seen * alpha ** 2 / (pi * d * d)

    def mapped(point):
        x, z = -point[0], point[1]  # the table has the camera on the side of +x
        return -(m11 * x + m13 * z), m31 * x + m33 * z

    most = max(ggx(angle) for angle in range(1, 180))
    p, q = drawing.panel((230, 75), 190), drawing.panel((670, 75), 190)
    for panel, says in ((p, "the surface's lobe, GGX times *N*·*L*"), (q, "after the map: the cosine lobe")):
        panel.ground(-0.95, 0.95)
        panel.arrow((0, 0), (0, 1.08), NORMAL, "*N*")
        panel.text((0, -0.24), says, INK, SMALL)
    p.arrow((0, 0), polar(0.95, 90 + VIEW), EYE, "*V*")
    p.curve(lambda angle: polar(ggx(angle) / most, angle), 0.5, 179.5, MIRROR)
    q.curve(lambda angle: polar(sin(radians(angle)), angle), 0, 180, MIRROR)
    shrink = 1.02 / max(sqrt(x * x + y * y) for x, y in map(mapped, LAMP))
    for panel, ends in ((p, LAMP), (q, [(shrink * x, shrink * y) for x, y in map(mapped, LAMP)])):
        for end in ends:
            panel.line([(0, 0), end], GREY, THIN, dash=True)
        panel.line(ends, LIGHT, 5)
    p.text((1.02, 0.86), "lamp", LIGHT, anchor="start")
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
