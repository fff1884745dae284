"""A texel of the map is not square on the head, and not everywhere as wide.

python3 docs/figures/12_stretch.py writes docs/images/12_stretch.svg.
"""

import math

from drawing import BLUE, GREEN, INK, ORANGE, PALE_BLUE, PALE_ORANGE, SMALL, THIN, Drawing


def draw() -> Drawing:
    drawing = Drawing(900, 360, "Left the map: square texels, one of them marked, and a Gaussian that is six texels wide and two high. Right "
                                "the surface: the same texel is a third of a millimetre along u and one millimetre along v, and there the "
                                "Gaussian is round")
    p = drawing.panel((50, 60), 34)
    for i in range(9):
        p.line([(i, 0), (i, 7)], INK, THIN)
    for j in range(8):
        p.line([(0, j), (8, j)], INK, THIN)
    p.box((4, 3), (5, 4), INK, 3, fill=PALE_BLUE)
    p.curve(lambda a: (4.5 + 3.0 * math.cos(a), 3.5 + math.sin(a)), 0, 6.2832, ORANGE, 4)
    p.text((4, 7), "map", INK, offset=(0, 18))
    p.arrow((0, -0.5), (2, -0.5), BLUE, "u", offset=(14, 0))
    p.arrow((-0.5, 0), (-0.5, 2), GREEN, "v", offset=(0, 14))
    q = drawing.panel((520, 60), 34)
    for i in range(9):
        q.line([(i * 0.55 + 0.5, 0), (i * 0.55 + 0.9, 7)], INK, THIN)
    for j in range(5):
        q.line([(0.5 + j * 0.1, j * 1.75), (4.9 + j * 0.1, j * 1.75)], INK, THIN)
    q.line([(2.9, 3.5), (3.45, 3.5), (3.55, 5.25), (3.0, 5.25)], INK, 3, closed=True, fill=PALE_ORANGE)
    q.curve(lambda a: (3.2 + 1.6 * math.cos(a), 4.3 + 1.6 * math.sin(a)), 0, 6.2832, ORANGE, 4)
    q.text((2.9, 7), "surface", INK, offset=(0, 18))
    q.arrow((6.2, 3.5), (7.0, 3.5), BLUE, width=3)
    q.text((7.0, 3.5), "du, in mm", BLUE, SMALL, anchor="start", offset=(8, 0))
    q.arrow((6.2, 3.5), (6.3, 5.25), GREEN, width=3)
    q.text((6.3, 5.25), "dv, in mm", GREEN, SMALL, anchor="start", offset=(8, 4))
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
