"""A tile over a depth gap keeps the lights in the gap; clusters cut it into slices.

python3 docs/figures/03_cells.py writes docs/images/03_cells.svg.
"""

from drawing import BLUE, GREY, INK, LIGHT, PALE_BLUE, PALE_GREY, PALE_ORANGE, SMALL, THIN, Drawing

NEAR, FAR = 1.0, 7.4  # depth range of a tile, in units
SLOPES = (-0.07, 0.0, 0.15)  # the tiles' sides
LOW, HIGH = SLOPES[1:]  # of the tile in question
LIGHTS = [(1.45, 0.1, 0.22), (2.35, 0.3, 0.24), (3.5, 0.45, 0.28), (4.45, 0.3, 0.28), (6.9, 0.55, 0.33)]
SLICES = 5


def piece(p, near: float, far: float, fill):
    p.line([(near, LOW * near), (far, LOW * far), (far, HIGH * far), (near, HIGH * near)], BLUE, closed=True, fill=fill)


def view(p, title: str, clusters: bool):
    borders = [NEAR * (FAR / NEAR) ** (i / SLICES) for i in range(SLICES + 1)]
    for slope in SLOPES:
        p.line([(0, 0), (FAR, slope * FAR)], GREY, THIN)
    p.line([(0.9, -0.3), (1.12, -0.3), (1.12, 0.07), (0.9, 0.07)], INK, THIN, closed=True, fill=PALE_GREY)
    if clusters:
        for i, (near, far) in enumerate(zip(borders, borders[1:])):
            piece(p, near, far, PALE_BLUE if i in (0, SLICES - 1) else "#ffffff")
    else:
        piece(p, NEAR, FAR, PALE_BLUE)
    p.line([(FAR, -0.6), (FAR, 1.35)], INK, 6)
    for x, y, radius in LIGHTS:
        reached = not clusters or x < borders[1] or x > borders[-2]
        p.circle((x, y), radius, LIGHT if reached else GREY, THIN, dash=not reached, fill=PALE_ORANGE if reached else None)
        p.dot((x, y), LIGHT if reached else GREY, radius_px=4)
    p.eye((0, 0), 0, 44)
    p.text((0.0, 1.15), title, INK, anchor="start")
    p.text((1.0, -0.5), "post", GREY, SMALL)
    p.text((FAR, 1.25), "wall", GREY, SMALL, anchor="end", offset=(-12, 0))


def draw() -> Drawing:
    drawing = Drawing(900, 480, "A tile that sees a post near by and a wall far away, from the side. As one piece it keeps all five "
                                "lights; cut into slices of depth it keeps the two that are where surfaces are")
    view(drawing.panel((55, 315), 110), "a tile in one piece keeps five lights", False)
    view(drawing.panel((55, 75), 110), "in slices, those with surfaces keep two", True)
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
