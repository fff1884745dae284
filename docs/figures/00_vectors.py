"""The dot product, the cross product, and how much of one vector lies along another.

python3 docs/figures/00_vectors.py writes docs/images/00_vectors.svg.
"""

from drawing import BLUE, GREEN, GREY, INK, ORANGE, PALE_GREY, RED, SMALL, THIN, Drawing, polar


def draw() -> Drawing:
    drawing = Drawing(1000, 330, "A vector between two points; the dot product as a length along a unit vector; the cross product of two "
                                 "edges, perpendicular to both")
    p = drawing.panel((40, 70), 100)
    p.dot((0.2, 0.3), INK, "*p*", offset=(-16, 10))
    p.dot((2.2, 1.5), INK, "*q*", offset=(16, 10))
    p.arrow((0.2, 0.3), (2.2, 1.5), BLUE, "*q* − *p*", at=0.5, offset=(-34, 22))
    p.text((1.2, -0.35), "from p to q", GREY, SMALL)
    p = drawing.panel((380, 70), 100)
    tip = polar(1.7, 40)
    p.arrow((0, 0), (2.2, 0), GREEN, "*n*")
    p.arrow((0, 0), tip, BLUE, "*a*")
    p.line([tip, (tip[0], 0)], GREY, THIN, dash=True)
    p.right_angle((tip[0], 0), 90)
    p.arc((0, 0), 0.5, 0, 40, "θ")
    p.line([(0, 0), (tip[0], 0)], ORANGE, 6)
    p.text((1.0, -0.35), "*a* · *n* = |*a*| cos θ, for |*n*| = 1", ORANGE, SMALL)
    p = drawing.panel((740, 90), 100)
    a, b = (1.7, -0.1), (0.75, 0.75)
    p.line([(0, 0), a, (a[0] + b[0] - 0.25, a[1] + b[1]), b], None, closed=True, fill=PALE_GREY)
    p.arrow((0, 0), a, BLUE, "*a*")
    p.arrow((0, 0), b, GREEN, "*b*", offset=(20, 8))
    p.arrow((0, 0), (0, 1.6), RED, "*a* × *b*", offset=(52, 4))
    p.text((0.95, -0.55), "length: the area between", GREY, SMALL)
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
