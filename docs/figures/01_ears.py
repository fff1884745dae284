"""An arrowhead as a fan, which fills its dent, and cut by ears.

python3 docs/figures/01_ears.py writes docs/images/01_ears.svg.
"""

from drawing import GREEN, GREY, INK, PALE_BLUE, PALE_GREEN, PALE_RED, RED, SMALL, THICK, THIN, Drawing

ARROWHEAD = [(-2, -1), (0, 0), (2, -1), (0, 2)]


def corners(p):
    p.line(ARROWHEAD, INK, THICK, closed=True)
    for i, (point, offset) in enumerate(zip(ARROWHEAD, ((-16, -12), (0, -20), (16, -12), (0, 18)))):
        p.dot(point, label=str(i), offset=offset)


def draw() -> Drawing:
    drawing = Drawing(900, 360, "An arrowhead of four corners: a fan from corner 0 covers the dent; cut off at the ear 1 2 3, "
                                "which leaves the triangle 0 1 3, it is covered once")
    left, right = drawing.panel((225, 165), 78), drawing.panel((675, 165), 78)
    left.line([ARROWHEAD[0], ARROWHEAD[2], ARROWHEAD[3]], None, fill=PALE_BLUE)
    left.line([ARROWHEAD[0], ARROWHEAD[1], ARROWHEAD[2]], RED, THIN, closed=True, fill=PALE_RED, dash=True)
    corners(left)
    left.text((0, -0.62), "0 1 2: area −2", RED, SMALL, rim=False)
    left.text((0, 0.85), "0 2 3:\narea 6", INK, SMALL, rim=False)
    left.text((0, -1.75), "fan: the dent is filled", RED)
    right.line([ARROWHEAD[1], ARROWHEAD[2], ARROWHEAD[3]], None, fill=PALE_GREEN)
    right.line([ARROWHEAD[0], ARROWHEAD[1], ARROWHEAD[3]], None, fill=PALE_BLUE)
    right.line([ARROWHEAD[1], ARROWHEAD[3]], GREEN, THICK, dash=True)
    corners(right)
    right.text((0.62, 0.2), "ear", GREEN, SMALL, rim=False)
    right.text((-0.62, 0.2), "rest", GREY, SMALL, rim=False)
    right.text((0, -1.75), "ears: 1 2 3, then 0 1 3", GREEN)
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
