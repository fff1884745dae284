"""Chunks of the ground in one dimension: triangles of three levels under a camera, and the vertices that move.

python3 docs/figures/15_chunks.py writes docs/images/15_chunks.svg.
"""

from math import sin

from drawing import BLUE, GREEN, GREY, ORANGE, SMALL, THIN, Drawing


def height(x: float) -> float:
    return 0.55 * sin(0.9 * x + 0.4) + 0.28 * sin(2.3 * x) + 0.1 * sin(6.1 * x + 1)


def draw() -> Drawing:
    drawing = Drawing(900, 330, "A height field drawn with short cells near the camera and cells twice and four times as long farther away; "
                                "in front of each border every second vertex moves onto its neighbour")
    p = drawing.panel((60, 190), 92)
    p.line([(i * 0.02, height(i * 0.02)) for i in range(421)], GREY, THIN)
    for first, last, cell, color in ((0.0, 2.0, 0.25, GREEN), (2.0, 4.0, 0.5, BLUE), (4.0, 8.0, 1.0, ORANGE)):
        places = [first + cell * i for i in range(int((last - first) / cell) + 1)]
        p.line([(x, height(x)) for x in places], color)
        for x in places:
            p.dot((x, height(x)), color)
    for border in (2.0, 4.0):
        p.line([(border, -1.25), (border, 1.25)], GREY, THIN)
    p.eye((0.2, 1.2), -20)
    p.text((1.0, -1.35), "level 0", GREEN, SMALL)
    p.text((3.0, -1.35), "level 1", BLUE, SMALL)
    p.text((6.0, -1.35), "level 2", ORANGE, SMALL)
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
