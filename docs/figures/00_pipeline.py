"""A triangle on its way through the GPU: the stages of the graphics pipeline.

python3 docs/figures/00_pipeline.py writes docs/images/00_pipeline.svg.
"""

from drawing import (BLUE, FAINT, GREEN, GREY, INK, ORANGE, PALE_BLUE, PALE_ORANGE, SMALL, THIN,
                     Drawing)

CORNERS = [(0.6, 0.7), (5.4, 1.6), (2.4, 5.3)]  # of the triangle, in pixels of a small screen
SIDE = 6  # pixels of the screen


def inside(x: float, y: float) -> bool:
    (ax, ay), (bx, by), (cx, cy) = CORNERS
    edges = [((ax, ay), (bx, by)), ((bx, by), (cx, cy)), ((cx, cy), (ax, ay))]
    return all((q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0]) >= 0 for p, q in edges)


def screen(drawing, left: float, bottom: float, fill, triangle: bool, hidden=()):
    p = drawing.panel((left, bottom), 25)
    for y in range(SIDE):
        for x in range(SIDE):
            covered = inside(x + 0.5, y + 0.5) and (x, y) not in hidden
            p.box((x, y), (x + 1, y + 1), FAINT, THIN, fill=fill(x, y) if covered else None)
    if triangle:
        p.line(CORNERS, BLUE, 2.2, closed=True)
    return p


def draw() -> Drawing:
    drawing = Drawing(1110, 330, "Vertices go through the vertex shader, the rasteriser, the depth test and the fragment shader into "
                                 "the pixels of an image")
    board = drawing.panel()
    lefts = [20, 245, 470, 695, 915]
    first = drawing.panel((lefts[0], 100), 25)
    for (x, y), name in zip(CORNERS, ("0", "1", "2")):
        first.dot((x * 0.9, y * 0.9 + 0.3), BLUE, name, offset=(14, 14), size=SMALL)
    second = screen(drawing, lefts[1], 100, None, False, {(x, y) for x in range(SIDE) for y in range(SIDE)})
    for corner in CORNERS:
        second.dot(corner, BLUE)
    second.line(CORNERS, BLUE, THIN, dash=True, closed=True)
    third = screen(drawing, lefts[2], 100, lambda x, y: PALE_BLUE, True)
    for y in range(SIDE):
        for x in range(SIDE):
            third.dot((x + 0.5, y + 0.5), BLUE if inside(x + 0.5, y + 0.5) else FAINT, radius_px=2.5)
    hidden = {(x, y) for x in (3, 4, 5) for y in (2, 3, 4, 5)}
    fourth = screen(drawing, lefts[3], 100, lambda x, y: PALE_BLUE, False, hidden)
    fourth.box((3, 2), (6, 5), ORANGE, 2.2, fill=PALE_ORANGE)
    fourth.text((4.5, 3.5), "nearer", ORANGE, SMALL, rim=False)
    last = screen(drawing, lefts[4], 100, lambda x, y: f"#{40 + 34 * x:02x}{120 + 22 * y:02x}60", False, hidden)
    last.box((3, 2), (6, 5), None, fill=PALE_ORANGE)
    for x in (3, 4, 5):
        for y in (2, 3, 4):
            last.box((x, y), (x + 1, y + 1), FAINT, THIN)
    titles = [("vertices", INK), ("vertex shader", GREEN), ("rasteriser", GREY), ("depth test", GREY), ("fragment shader", GREEN)]
    below = ["points with\nattributes", "where on\nthe screen?", "which pixels?\nfragments", "is something\nnearer there?", "which\ncolour?"]
    for left, (title, color), text in zip(lefts, titles, below):
        board.text((left + 75, 290), title, color, bold=True)
        board.text((left + 75, 52), text, GREY, SMALL)
    for left in lefts[1:]:
        board.arrow((left - 58, 175), (left - 14, 175), INK)
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
