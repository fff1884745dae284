"""Self-shadowing: a texel holds one depth for its whole area, and the surface falls away under it. Cut along a diagonal.

python3 docs/figures/05_bias.py writes docs/images/05_bias.svg.
"""

from math import radians, tan

from drawing import FAINT, GREEN, GREY, INK, LIGHT, ORANGE, PALE_GREY, RED, SMALL, THIN, Drawing

SLOPE = 35  # degrees between the surface and the map's plane: the angle between its normal and the light
TEXELS = 4


def height(x: float) -> float:
    return -tan(radians(SLOPE)) * (x - 2)


def draw() -> Drawing:
    drawing = Drawing(900, 470, "A sloped surface under vertical light, cut along the diagonal of the map's texels. Each texel holds the "
                                "depth at its centre: half of the surface under it is lower and appears to be in shadow, by up to half of "
                                "the diagonal times the tangent")
    p = drawing.panel((60, 258), 135)
    p.line([(0, height(0)), (TEXELS, height(TEXELS)), (TEXELS, -1.45), (0, -1.45)], None, fill=PALE_GREY)
    for i in range(TEXELS):
        middle = i + 0.5
        p.line([(i, 1.45), (i, height(i))], FAINT, THIN, dash=True)
        p.line([(middle, height(middle)), (i + 1, height(i + 1))], RED, 5)
        p.line([(i, height(i)), (middle, height(middle))], GREEN, 5)
        p.line([(i, height(middle)), (i + 1, height(middle))], INK)
        p.dot((middle, height(middle)), INK)
    p.line([(TEXELS, 1.45), (TEXELS, height(TEXELS))], FAINT, THIN, dash=True)
    for x in (1.5, 2.5, 3.5):
        p.arrow((x, 1.45), (x, height(x) + 0.12), LIGHT, width=THIN)
    p.span((2, 1.3), (3, 1.3), "diagonal √2 *t*", offset=(0, 0), size=SMALL)
    edge = TEXELS - 1
    p.span((edge + 1.12, height(edge + 0.5)), (edge + 1.12, height(edge + 1)), "", RED)
    p.text((edge + 1.2, 0.5 * (height(edge + 0.5) + height(edge + 1))), "½ √2 *t* tan θ", RED, anchor="start")
    p.line([(1.2, height(2)), (2.0, height(2))], GREY, THIN, dash=True)
    p.arc((2, height(2)), 0.62, 180 - SLOPE, 180, "θ", GREY, size=SMALL)
    key = drawing.panel()
    for x, color, name in ((60, GREEN, "lit"), (150, RED, "below its own texel: acne"), (450, INK, "depth in the map"), (690, ORANGE, "light")):
        key.dot((x, 20), color, radius_px=7)
        key.text((x + 16, 20), name, INK, SMALL, anchor="start")
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
