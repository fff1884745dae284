"""A slice of the camera's view in its ball, the light's box around the ball, and the box moved by whole texels.

python3 docs/figures/05_fit.py writes docs/images/05_fit.svg.
"""

from math import hypot

from drawing import BLUE, EYE, FAINT, GREEN, GREY, INK, LIGHT, PALE_BLUE, PURPLE, SMALL, THIN, Drawing, polar

NEAR, FAR, SLOPE = 1.1, 2.4, 0.55  # of the slice; half its width over the distance


def draw() -> Drawing:
    drawing = Drawing(900, 430, "Left: a slice of the camera's view from above, the ball around it, and the box of parallel rays around the ball. Right: the "
                                "box may start only on a grid of texels that is fixed in the world")
    p = drawing.panel((70, 205), 108)
    p.eye((0, 0), 0, 36)
    corners = [(NEAR, SLOPE * NEAR), (FAR, SLOPE * FAR), (FAR, -SLOPE * FAR), (NEAR, -SLOPE * NEAR)]
    for side in (-1, 1):
        p.line([(0, 0), (FAR, side * SLOPE * FAR)], EYE, THIN, dash=True)
    p.line(corners, BLUE, THIN, closed=True, fill=PALE_BLUE)
    middle = min(0.5 * (NEAR + FAR) * (1 + SLOPE ** 2), FAR)
    radius = hypot(FAR - middle, SLOPE * FAR)
    p.circle((middle, 0), radius, GREEN, THIN)
    turn = 18

    def of_light(a, b):
        return polar(b, turn + 90, polar(a, turn, (middle, 0)))

    box = [of_light(-radius, -radius), of_light(radius, -radius), of_light(radius, radius), of_light(-radius, radius)]
    p.line(box, LIGHT, closed=True)
    for share in (-0.75, -0.25, 0.25):
        p.arrow(of_light(share * radius, radius + 0.3), of_light(share * radius, radius + 0.04), LIGHT, width=THIN)
    p.text((1.75, 0), "slice", BLUE, SMALL, rim=False)
    p.text(of_light(0, -radius), "light's box, 2*r* wide", LIGHT, SMALL, offset=(0, -18))
    p.dot((middle, 0), GREEN, radius_px=4)
    # The grid of the map's texels.
    q = drawing.panel((590, 95), 34)
    for i in range(9):
        q.line([(i, 0), (i, 8)], FAINT, 1)
        q.line([(0, i), (8, i)], FAINT, 1)
    q.box((1.4, 1.3), (6.4, 6.3), GREY, THIN, dash=True)
    q.box((1, 1), (6, 6), LIGHT)
    q.arrow((3.9, 3.8), (3.5, 3.5), PURPLE, width=2)
    q.dot((3.9, 3.8), GREY, radius_px=4)
    q.text((4, 8.7), "texels, fixed in the world", INK, SMALL)
    q.text((4, -0.8), "dashed: as fitted; solid: snapped", GREY, SMALL)
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
