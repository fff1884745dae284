"""Diagrams of chapter 02's lessons: python3 docs/figures/draw.py draws them."""

from math import cos, radians, sin, sqrt

from drawing import EYE, GREY, HALF, INK, LIGHT, MIRROR, NORMAL, PALE_ORANGE, SMALL, THIN, Drawing, figure, polar

WIDTH = 1.3


def beam(p, angle: float, area: str):
    """A beam at `angle` degrees to the normal, and its footprint on the ground."""
    half = WIDTH / 2 / cos(radians(angle))
    reach = 1.55 / cos(radians(angle))
    top = [polar(reach, 90 + angle, (x, 0)) for x in (half, -half)]
    p.line([(-half, 0), (half, 0), *top], None, fill=PALE_ORANGE)
    for i in range(5):
        foot = -half + 2 * half * (i + 0.5) / 5
        p.arrow(polar(reach, 90 + angle, (foot, 0)), (foot, 0.02), LIGHT, width=THIN)
    p.ground(-1.4, 1.4)
    p.span((-half, -0.3), (half, -0.3), area, INK, offset=(0, -34))


@figure("02_cosine", 900, 340,
        "A beam of light across an area A: on a surface that faces it, it lights A; where the normal makes the angle theta "
        "with it, it lights A divided by the cosine")
def draw_cosine(drawing: Drawing):
    left, right = drawing.panel((190, 100), 118), drawing.panel((705, 100), 118)
    beam(left, 0, "A")
    beam(right, 50, "A / cos θ")
    for p, angle in ((left, 0), (right, 50)):
        p.arrow((0, 0), (0, 1.2), NORMAL, "*N*", offset=(20, 8))
    right.arrow((0, 0), polar(1.45, 140), LIGHT, "*L*", offset=(-4, 20))
    right.arc((0, 0), 0.62, 90, 140, "θ", INK)


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


@figure("02_lobes", 900, 400,
        "Left: the two lobes in the plane of normal and light nearly coincide. Right: the directions in which they are at "
        "least half as bright, low above a floor: Phong's are a disc, Blinn's a narrow upright shape")
def draw_lobes(drawing: Drawing):
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


@figure("02_vectors", 900, 430,
        "The normal N, the directions L to the light and V to the camera, the mirror direction R and the half vector H at a "
        "point of a surface")
def draw_vectors(drawing: Drawing):
    p = drawing.panel((430, 60), 300)
    p.ground(-1.35, 1.45)
    p.lamp(polar(1.32, 140))
    p.eye(polar(1.24, 20), 200, 46)
    for angle, color, name in ((90, NORMAL, "*N*"), (140, LIGHT, "*L*"), (20, EYE, "*V*"), (40, MIRROR, "*R*"),
                               (80, HALF, "*H*")):
        p.arrow((0, 0), polar(1.0, angle), color, name)
    p.arc((0, 0), 0.5, 90, 140, "θ", INK)
    p.arc((0, 0), 0.42, 40, 90, "θ", INK, offset=(10, 0))
    p.arc((0, 0), 0.72, 20, 40, "α", INK)
    p.arc((0, 0), 0.82, 80, 90, "α/2", INK, offset=(0, 4), size=18)
    p.text((-1.35, 0.98), "light", LIGHT, anchor="start")
    p.text((1.32, 0.56), "eye", EYE)
