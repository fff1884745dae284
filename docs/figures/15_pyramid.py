"""A ray over a pyramid of greatest heights: blocks that it passes above are skipped whole.

python3 docs/figures/15_pyramid.py writes docs/images/15_pyramid.svg.
"""

from drawing import BLUE, GREEN, GREY, ORANGE, PALE_GREY, SMALL, THIN, Drawing

HEIGHTS = [0.3, 0.5, 0.4, 0.7, 0.9, 0.6, 0.5, 0.8, 1.2, 1.6, 1.9, 1.5, 1.1, 0.9, 0.8, 0.6, 0.5]


def draw() -> Drawing:
    drawing = Drawing(900, 330, "A ray comes down over a height field. Where it stays above the greatest height of four or two cells it "
                                "passes them in one step; near the ground it looks at single cells")
    p = drawing.panel((60, 30), 48)
    for size, color in ((4, PALE_GREY), (2, GREY)):
        for first in range(0, 16, size):
            top = max(HEIGHTS[first:first + size + 1])
            p.line([(first, 0), (first, 2 * top), (first + size, 2 * top), (first + size, 0)], color, THIN)
    p.line([(i, 2 * h) for i, h in enumerate(HEIGHTS)], GREEN)
    start, end = (0.0, 5.2), (9.55, 3.52)
    p.line([start, end], BLUE)
    for x in (0.0, 4.0, 8.0, 9.0, 9.55):
        p.dot((x, start[1] + (end[1] - start[1]) * x / end[0]), ORANGE)
    p.text((10.6, 4.9), "grey: greatest heights of 2 and 4 cells", GREY, SMALL, offset=(-40, 0))
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
