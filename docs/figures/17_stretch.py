"""Saturn and its rings from the side, with the shadow on them; and the same stretched along the axis, where the planet is a ball.

python3 docs/figures/17_stretch.py writes docs/images/17_stretch.svg.
"""

from math import cos, pi, radians, sin, sqrt

from drawing import BLUE, GREY, INK, ORANGE, PALE_GREY, SMALL, THIN, Drawing

FLATTENING, SUN = 0.25, radians(27)  # flatter than Saturn, so that it shows


def half(p, squeeze: float, title: str) -> None:
    points = [(cos(a), squeeze * sin(a)) for a in (2 * pi * i / 96 for i in range(97))]
    p.line(points, GREY, THIN, closed=True, fill=PALE_GREY)
    p.line([(0, -squeeze - 0.25), (0, squeeze + 0.25)], INK, THIN, dash=True)
    p.line([(-2.5, 0), (-1.24, 0)], BLUE)
    p.line([(1.24, 0), (2.0, 0)], BLUE)
    down = SUN if squeeze < 1 else None
    slope = sin(SUN) / cos(SUN) * (1.0 if down else 1 / (1 - FLATTENING))
    # The ray that touches the top: tangent of the ellipse with that slope.
    reach = sqrt(squeeze * squeeze + slope * slope)
    end = -reach / slope
    start = (0.5, slope * (0.5 - end))
    p.line([start, (end, 0)], ORANGE, THIN)
    p.text(start, "from the sun", ORANGE, SMALL, offset=(40, 14))
    p.dot((end, 0), ORANGE)
    p.text((end, 0), "the shadow ends", ORANGE, SMALL, offset=(6, -30))
    p.text((0, -squeeze), title, INK, SMALL, offset=(0, -52))


def draw() -> Drawing:
    drawing = Drawing(980, 380, "A flattened planet with its rings from the side, and both stretched along the axis: the planet is a ball, the "
                                "ray is steeper, and the shadow ends at the same place of the rings")
    half(drawing.panel((290, 210), 92), 1 - FLATTENING, "as it is")
    half(drawing.panel((770, 210), 92), 1.0, "stretched by 1 / (1 − f)")
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
