"""Diagrams of chapter 17's lessons: python3 docs/figures/draw.py draws them."""

from math import cos, pi, radians, sin, sqrt

from drawing import BLUE, GREEN, GREY, INK, ORANGE, PALE_GREY, SMALL, THIN, Drawing, figure, polar

RADIUS, NORMAL, SUN_ANGLE, CAMERA = 1.6, 70, 125, 25


@figure("17_angles", 860, 600,
        "A place of a ball with its normal, the directions to the sun and to the camera, and the phase angle between those "
        "two; the terminator and the limb")
def draw_angles(drawing: Drawing):
    p = drawing.panel((390, 200), 100)
    p.circle((0, 0), RADIUS, GREY, THIN, fill=PALE_GREY)
    at = polar(RADIUS, NORMAL)
    for angle, color, length, label, offset in ((NORMAL, INK, 1.25, "n", (-8, 14)), (SUN_ANGLE, ORANGE, 1.5, "to the sun, l", (-30, 14)),
                                                (CAMERA, BLUE, 1.5, "to the camera, v", (70, 8))):
        tip = (at[0] + length * cos(radians(angle)), at[1] + length * sin(radians(angle)))
        p.arrow(at, tip, color)
        p.text(tip, label, color, SMALL, offset=offset)
    p.arc(at, 0.62, CAMERA, SUN_ANGLE, "", GREEN)
    p.text(polar(0.8, 0.5 * (CAMERA + NORMAL), at), "g", GREEN, SMALL)
    terminator = polar(RADIUS, SUN_ANGLE + 90)
    p.line([(0, 0), terminator], ORANGE, THIN, dash=True)
    p.line([(0, 0), polar(RADIUS, SUN_ANGLE - 90)], ORANGE, THIN, dash=True)
    p.text(terminator, "terminator: n·l = 0", ORANGE, SMALL, offset=(-90, -8))
    limb = polar(RADIUS, CAMERA - 90)
    p.line([polar(RADIUS, CAMERA + 90), limb], BLUE, THIN, dash=True)
    p.text(limb, "limb: n·v = 0", BLUE, SMALL, offset=(60, -8))


FLATTENING, SUN_SLOPE = 0.25, radians(27)  # flatter than Saturn, so that it shows


def half(p, squeeze: float, title: str) -> None:
    points = [(cos(a), squeeze * sin(a)) for a in (2 * pi * i / 96 for i in range(97))]
    p.line(points, GREY, THIN, closed=True, fill=PALE_GREY)
    p.line([(0, -squeeze - 0.25), (0, squeeze + 0.25)], INK, THIN, dash=True)
    p.line([(-2.5, 0), (-1.24, 0)], BLUE)
    p.line([(1.24, 0), (2.0, 0)], BLUE)
    down = SUN_SLOPE if squeeze < 1 else None
    slope = sin(SUN_SLOPE) / cos(SUN_SLOPE) * (1.0 if down else 1 / (1 - FLATTENING))
    # The ray that touches the top: tangent of the ellipse with that slope.
    reach = sqrt(squeeze * squeeze + slope * slope)
    end = -reach / slope
    start = (0.5, slope * (0.5 - end))
    p.line([start, (end, 0)], ORANGE, THIN)
    p.text(start, "from the sun", ORANGE, SMALL, offset=(40, 14))
    p.dot((end, 0), ORANGE)
    p.text((end, 0), "the shadow ends", ORANGE, SMALL, offset=(6, -30))
    p.text((0, -squeeze), title, INK, SMALL, offset=(0, -52))


@figure("17_stretch", 980, 380,
        "A flattened planet with its rings from the side, and both stretched along the axis: the planet is a ball, the ray is "
        "steeper, and the shadow ends at the same place of the rings")
def draw_stretch(drawing: Drawing):
    half(drawing.panel((290, 210), 92), 1 - FLATTENING, "as it is")
    half(drawing.panel((770, 210), 92), 1.0, "stretched by 1 / (1 − f)")
