"""The same beam on a surface that faces it and on one that leans away: the cosine.

python3 docs/figures/02_cosine.py writes docs/images/02_cosine.svg.
"""

from math import cos, radians

from drawing import INK, LIGHT, NORMAL, PALE_ORANGE, THIN, Drawing, polar

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


def draw() -> Drawing:
    drawing = Drawing(900, 340, "A beam of light across an area A: on a surface that faces it, it lights A; where the normal makes "
                                "the angle theta with it, it lights A divided by the cosine")
    left, right = drawing.panel((190, 100), 118), drawing.panel((705, 100), 118)
    beam(left, 0, "A")
    beam(right, 50, "A / cos θ")
    for p, angle in ((left, 0), (right, 50)):
        p.arrow((0, 0), (0, 1.2), NORMAL, "*N*", offset=(20, 8))
    right.arrow((0, 0), polar(1.45, 140), LIGHT, "*L*", offset=(-4, 20))
    right.arc((0, 0), 0.62, 90, 140, "θ", INK)
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
