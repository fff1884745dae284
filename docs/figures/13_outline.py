"""An edge on whole pixels, the outline that it stands for, and the area between the two.

python3 docs/figures/13_outline.py writes docs/images/13_outline.svg.
"""

from drawing import BLUE, GREY, INK, ORANGE, PALE_BLUE, PALE_GREY, PALE_ORANGE, RED, SMALL, THIN, Drawing

LENGTH = 8  # of the line in the middle, pixels


def draw() -> Drawing:
    drawing = Drawing(900, 330, "Pixels on both sides of a staircase. The line in the middle is eight pixels long and turns up at its left "
                                "end and down at its right. The outline goes from half a pixel above the line at one end to half a "
                                "pixel below at the other, and through the line in its middle. Triangles lie between the two")
    p = drawing.panel((60, 110), 64)
    for x in range(-1, 12):
        for y in (-1, 0):
            below = y < (1 if x < 2 else 0 if x < 2 + LENGTH else -1)
            p.box((x, y), (x + 1, y + 1), GREY, 1, fill=PALE_BLUE if below else PALE_GREY)
    start, end = 2, 2 + LENGTH
    middle = (start + end) / 2
    p.line([(start, 0.5), (middle, 0), (start, 0)], ORANGE, THIN, closed=True, fill=PALE_ORANGE)
    p.line([(end, -0.5), (middle, 0), (end, 0)], ORANGE, THIN, closed=True, fill=PALE_ORANGE)
    p.line([(-1, 1), (start, 1), (start, 0), (end, 0), (end, -1), (12, -1)], INK, 4)
    p.line([(start, 0.5), (end, -0.5)], RED, 4)
    p.dot((start, 0.5), RED)
    p.dot((end, -0.5), RED)
    p.span((start, 1.6), (end, 1.6), "the line: *L* = 8 pixels", BLUE)
    p.text((start + 0.5, 0), "0", INK, SMALL, offset=(0, -20), rim=False)
    p.text((start + 1.5, 0), "1", INK, SMALL, offset=(0, -20), rim=False)
    p.text((start + 2.5, 0), "2", INK, SMALL, offset=(0, -20), rim=False)
    p.text((start + 3.5, 0), "*p* = 3", INK, SMALL, offset=(0, -20), rim=False)
    p.text((middle + 1.6, 0.5), "the outline", RED, anchor="start")
    p.text((0.4, 1.4), "it turns up here", INK, SMALL)
    p.text((end + 0.6, -1.4), "and down here", INK, SMALL)
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
