"""The spaces that a vertex passes through on its way to a pixel.

python3 docs/figures/00_spaces.py writes docs/images/00_spaces.svg.
"""

from drawing import BLUE, FAINT, GREEN, GREY, INK, ORANGE, PALE_GREEN, RED, SMALL, THIN, Drawing

HOUSE = [(-0.4, 0), (0.4, 0), (0.4, 0.5), (0, 0.9), (-0.4, 0.5)]


def axes(p, at, x, y, size=0.7):
    p.arrow(at, (at[0] + size * x[0], at[1] + size * x[1]), RED, width=2)
    p.arrow(at, (at[0] + size * y[0], at[1] + size * y[1]), GREEN, width=2)


def house(p, place):
    p.line([place(point) for point in HOUSE], INK, 2.2, closed=True, fill=PALE_GREEN)


def draw() -> Drawing:
    drawing = Drawing(1080, 330, "A house in its own space, in the world beside a camera, in the camera's space, in clip space after the "
                                 "division, and in pixels")
    board = drawing.panel()
    lefts = [110, 320, 540, 755, 970]
    names = ["object space", "world space", "view space", "clip space", "pixels"]
    steps = ["model\nmatrix", "view\nmatrix", "projection,\ndivision", "viewport"]
    for left, name in zip(lefts, names):
        board.text((left, 295), name, INK, SMALL, bold=True)
    for left, step in zip(lefts, steps):
        board.arrow((left + 72, 72), (left + 138, 72), INK)
        board.text((left + 105, 28), step, BLUE, SMALL)
    p = drawing.panel((lefts[0], 140), 85)
    house(p, lambda q: q)
    axes(p, (0, 0), (1, 0), (0, 1))
    p = drawing.panel((lefts[1], 140), 85)
    house(p, lambda q: (0.45 + 0.6 * q[0] - 0.2 * q[1], 0.35 + 0.2 * q[0] + 0.6 * q[1]))
    axes(p, (-0.75, -0.25), (1, 0), (0, 1), 0.5)
    p.eye((-0.45, 0.95), -30, 26)
    p = drawing.panel((lefts[2], 140), 85)
    house(p, lambda q: (0.55 + 0.6 * q[0], 0.25 + 0.55 * q[1]))
    p.eye((-0.75, 0.45), 0, 26)
    p.line([(-0.75, 0.45), (1.0, 1.2)], FAINT, THIN)
    p.line([(-0.75, 0.45), (1.0, -0.3)], FAINT, THIN)
    p = drawing.panel((lefts[3], 140), 85)
    p.box((-0.75, -0.3), (0.75, 1.2), ORANGE, THIN)
    house(p, lambda q: (0.1 + 0.9 * q[0], 0.1 + 0.95 * q[1]))
    p.text((-0.72, 1.32), "−1", GREY, SMALL)
    p.text((0.72, 1.32), "1", GREY, SMALL)
    p = drawing.panel((lefts[4], 140), 85)
    for i in range(9):
        p.line([(-0.8 + 0.2 * i, -0.2), (-0.8 + 0.2 * i, 1.0)], FAINT, 1)
    for i in range(7):
        p.line([(-0.8, -0.2 + 0.2 * i), (0.8, -0.2 + 0.2 * i)], FAINT, 1)
    house(p, lambda q: (0.1 + 0.95 * q[0], 0.05 + 0.8 * q[1]))
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
