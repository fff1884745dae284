"""Rings of a grid around the eye, and the seam where two of them meet.

python3 docs/figures/11_rings.py writes docs/images/11_rings.svg.
"""

from drawing import BLUE, EYE, FAINT, GREEN, GREY, INK, PALE_RED, RED, SMALL, THIN, Drawing


def draw() -> Drawing:
    drawing = Drawing(900, 450, "Left: a grid of square rings, each of cells twice as large as the one within. Right: where two rings "
                                "meet the inner one has a vertex more, which opens a crack; moved onto its neighbour it closes it")
    p = drawing.panel((220, 250), 22)
    for ring, cell in ((2, 4), (1, 2), (0, 1)):
        half = 2 * cell
        color = (BLUE, GREY, FAINT)[ring]
        for i in range(-2, 3):
            p.line([(-half, i * cell), (half, i * cell)], color, THIN)
            p.line([(i * cell, -half), (i * cell, half)], color, THIN)
    p.dot((0, 0), EYE)
    p.text((0, 0), "the grid stays below the eye, the noise moves", INK, SMALL, offset=(0, -206))
    heights = [0.2, 1.35, 0.7]
    for column, stitched in enumerate((False, True)):
        q = drawing.panel((470 + 220 * column, 130), 90)
        a, m, b = (0.0, heights[0]), (1.0, heights[1]), (2.0, heights[2])
        if not stitched:
            q.line([a, m, b], RED, THIN, closed=True, fill=PALE_RED)
        middle = a if stitched else m
        for left, right in ((a, middle), (middle, b)):
            if left != right:
                q.line([left, right], BLUE)
        q.line([a, b], GREY, dash=not stitched)
        for point in (a, b):
            q.dot(point, BLUE)
        q.dot(middle, GREEN if stitched else RED)
        q.text((1, 0), "stitched" if stitched else "a crack", GREEN if stitched else RED, offset=(0, -40))
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
