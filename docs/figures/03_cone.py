"""A spot light's cone: the inner and the outer half angle, and how light falls between them.

python3 docs/figures/03_cone.py writes docs/images/03_cone.svg.
"""

from math import cos, radians, tan

from drawing import BLUE, GREY, INK, LIGHT, PALE_ORANGE, RED, SMALL, THIN, Drawing, polar

INNER, OUTER, POINT = 17, 36, 26  # half angles, and that of a point between them
BRIGHT = "#f7c873"


def light(angle: float, softness: float) -> float:
    inner, outer = cos(radians(INNER)), cos(radians(OUTER))
    t = min(max((cos(radians(angle)) - outer) / (inner - outer), 0), 1)
    return t ** (1 + (0.35 - 1) * softness)


def draw() -> Drawing:
    drawing = Drawing(900, 400, "Left: a lamp, its axis, the inner and the outer half angle, and a point at the angle gamma between "
                                "them. Right: how much light passes, by the angle, with softness 0 and 1")
    height = 1.25
    p = drawing.panel((215, 60 + 210 * height), 210)
    p.line([(0, 0), (-height * tan(radians(OUTER)), -height), (height * tan(radians(OUTER)), -height)], None, fill=PALE_ORANGE)
    p.line([(0, 0), (-height * tan(radians(INNER)), -height), (height * tan(radians(INNER)), -height)], None, fill=BRIGHT)
    p.ground(-0.97, 0.97, -height)
    p.arrow((0, 0), (0, -1.02), LIGHT, "axis", offset=(0, -12), size=SMALL, rim=False)
    p.lamp((0, 0), 12)
    at = (height * tan(radians(POINT)), -height)
    p.line([(0, 0), at], BLUE, THIN)
    p.dot(at, BLUE)
    p.arc((0, 0), 0.95, 270, 270 + POINT, color=BLUE)
    p.text(polar(0.95, 270 + 21), "γ", BLUE, offset=(-16, 14))
    p.arc((0, 0), 0.42, 270, 270 + OUTER)
    p.text(polar(0.5, 270 + OUTER), "γ_{outer}", INK, SMALL, anchor="start", offset=(8, 0))
    p.arc((0, 0), 0.7, 270 - INNER, 270)
    p.text(polar(0.82, 270 - 26.5), "γ_{inner}", INK, SMALL, rim=False)
    q = drawing.panel((520, 80), 1)
    wide, high = 6.8, 230
    q.arrow((0, 0), (330, 0), INK, "γ", offset=(8, -24))
    q.arrow((0, 0), (0, 275), INK)
    for angle, name in ((INNER, "γ_{inner}"), (OUTER, "γ_{outer}")):
        q.line([(wide * angle, 0), (wide * angle, high)], GREY, THIN, dash=True)
        q.text((wide * angle, 0), name, INK, SMALL, offset=(0, -24))
    q.text((0, high), "1", INK, SMALL, offset=(-16, 0))
    for softness, color in ((0, RED), (1, BLUE)):
        q.curve(lambda angle, softness=softness: (wide * angle, high * light(angle, softness)), 0, 50, color, steps=250)
    q.text((wide * OUTER, high * 0.8), "softness 1", BLUE, SMALL, anchor="start", offset=(8, 0))
    q.text((wide * INNER, high * 0.17), "softness 0", RED, SMALL, anchor="start", offset=(6, 0))
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
