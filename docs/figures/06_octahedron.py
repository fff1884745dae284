"""The octahedral map: the sphere, the octahedron, and the square it is folded into.

python3 docs/figures/06_octahedron.py writes docs/images/06_octahedron.svg.
"""

from drawing import BLUE, GREEN, GREY, INK, ORANGE, PALE_BLUE, PALE_ORANGE, RED, THIN, Drawing, polar


def draw() -> Drawing:
    drawing = Drawing(900, 430, "A direction is scaled onto an octahedron; its lower half is folded outwards, so that "
                                "both halves fill a square")
    p = drawing.panel((210, 225), 130)
    p.circle((0, 0), 1.0, GREY, THIN, dash=True)
    p.line([(0, 1), (1, 0), (0, -1), (-1, 0)], INK, closed=True)
    tip = polar(1.0, 62)
    share = 1 / (abs(tip[0]) + abs(tip[1]))
    p.arrow((0, 0), tip, GREEN, "*n*")
    p.dot((tip[0] * share, tip[1] * share), RED)
    p.line([(tip[0] * share, tip[1] * share), (tip[0] * share, 0)], RED, THIN, dash=True)
    p.dot((tip[0] * share, 0), RED, "*e*", offset=(0, -20))
    p.text((0, 1.18), "+z", INK)
    p.text((0, -1.22), "−z", INK)
    p.text((0.0, -1.5), "from the side", GREY, size=18)
    q = drawing.panel((640, 225), 130)
    q.box((-1, -1), (1, 1), INK, fill=PALE_ORANGE)
    q.line([(0, 1), (1, 0), (0, -1), (-1, 0)], INK, closed=True, fill=PALE_BLUE)
    q.text((0, 0), "+z", BLUE, offset=(0, -6))
    for x, y in ((-1, 1), (1, 1), (-1, -1), (1, -1)):
        q.text((0.84 * x, 0.84 * y), "−z", ORANGE, offset=(0, -6))
    q.arrow((0.28, 0.34), (0.66, 0.72), RED)
    q.text((0.2, 0.42), "fold", RED, size=18, anchor="end")
    q.text((1.12, 0), "+x", INK, anchor="start", offset=(0, -6))
    q.text((0, 1.16), "+y", INK)
    q.text((0, -1.5), "from above, unfolded", GREY, size=18)
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
