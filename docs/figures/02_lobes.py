"""Phong's and Blinn's lobes: alike in the plane of the normal and the light, unlike across it.

python3 docs/figures/02_lobes.py writes docs/images/02_lobes.svg.
"""

from math import cos, radians, sin, sqrt

from drawing import GREY, HALF, INK, LIGHT, MIRROR, NORMAL, SMALL, THIN, Drawing, polar

EXPONENT = 80  # Blinn's; Phong's is a quarter
THETA = 40  # of the light, from the normal
LOW = 12  # of light and mirror direction above the horizon, in the right picture


def direction(azimuth: float, elevation: float):
    return (cos(radians(elevation)) * cos(radians(azimuth)), cos(radians(elevation)) * sin(radians(azimuth)),
            sin(radians(elevation)))


def dot(a, b) -> float:
    return sum(x * y for x, y in zip(a, b))


def phong(eye, light) -> float:
    mirror = (-light[0], -light[1], light[2])
    return max(dot(mirror, eye), 0) ** (EXPONENT / 4)


def blinn(eye, light) -> float:
    half = [a + b for a, b in zip(eye, light)]
    return max(half[2] / sqrt(dot(half, half)), 0) ** EXPONENT


def half_contour(lobe, light):
    """Where the lobe is half as bright as at its peak, in degrees from the mirror direction."""
    points = []
    for turn in range(0, 360, 3):
        inside, outside = 0.0, 40.0
        for _ in range(40):
            middle = (inside + outside) / 2
            x, y = polar(middle, turn)
            inside, outside = (middle, outside) if lobe(direction(x, LOW + y), light) > 0.5 else (inside, middle)
        points.append(polar(inside, turn))
    return [(x, max(y, -LOW)) for x, y in points]


def draw() -> Drawing:
    drawing = Drawing(900, 400, "Left: the two lobes in the plane of normal and light nearly coincide. Right: the directions in "
                                "which they are at least half as bright, low above a floor: Phong's are a disc, Blinn's a narrow "
                                "upright shape")
    p = drawing.panel((190, 90), 225)
    p.ground(-0.75, 1.05)
    light = direction(180, 90 - THETA)
    p.arrow((0, 0), (0, 1.02), NORMAL, "*N*")
    p.arrow((0, 0), polar(0.95, 90 + THETA), LIGHT, "*L*")
    for lobe, color, dash in ((phong, MIRROR, False), (blinn, HALF, True)):
        def at(angle, lobe=lobe):
            return polar(lobe(direction(0, angle), light), angle)
        p.curve(at, 0, 100, color, dash=dash)
    p.arrow((0, 0), polar(1.12, 90 - THETA), MIRROR, "*R*", width=THIN)
    p.text((0.15, -0.25), "in the plane of *N* and *L*", INK, SMALL)
    q = drawing.panel((670, 205), 5.6)
    q.line([(-36, -LOW), (36, -LOW)], GREY)
    q.text((-36, -LOW - 4.5), "horizon", GREY, SMALL, anchor="start")
    low_light = direction(180, LOW)
    q.line(half_contour(phong, low_light), MIRROR, closed=True)
    q.line(half_contour(blinn, low_light), HALF, closed=True, dash=True)
    q.dot((0, 0), MIRROR, "*R*", offset=(44, 0))
    q.text((17, 9), "Phong", MIRROR, anchor="start")
    q.text((0, 19.5), "Blinn", HALF)
    q.text((0, -31), "directions to the camera, low above a floor", INK, SMALL)
    q.span((10, -20), (30, -20), "20°", offset=(0, -34), size=SMALL)
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
