"""Where Kawase's filter and the dual filter read, and with which weights.

python3 docs/figures/08_kernels.py writes docs/images/08_kernels.svg.
"""

from drawing import BLUE, FAINT, GREEN, GREY, INK, ORANGE, PALE_BLUE, RED, SMALL, THIN, Drawing


def grid(p, size: int):
    """Texels of the image that is read, in a square around the origin."""
    half = size / 2
    for i in range(size + 1):
        p.line([(-half, i - half), (half, i - half)], FAINT, THIN)
        p.line([(i - half, -half), (i - half, half)], FAINT, THIN)


def reads(p, points, color, label: str = "", offset=(0, 0)):
    for x, y in points:
        p.dot((x, y), color)
    if label:
        p.text(points[-1], label, color, SMALL, offset=offset)


def around(d: float) -> list[tuple[float, float]]:
    return [(-d, -d), (d, -d), (-d, d), (d, d)]


def draw() -> Drawing:
    drawing = Drawing(900, 380, "Left, three passes of Kawase's filter: each reads four points, one texel farther out in each pass. "
                                "Middle, the dual filter on the way down: the middle and four corners of the new texel. Right, on the "
                                "way up: eight points on a diamond around the new texel")
    p = drawing.panel((160, 215), 34)
    grid(p, 7)
    p.box((-0.5, -0.5), (0.5, 0.5), INK, THIN, fill=PALE_BLUE)
    reads(p, around(0.5), ORANGE, "0", (12, 12))
    reads(p, around(1.5), GREEN, "1", (12, 12))
    reads(p, around(2.5), RED, "2", (12, 12))
    p.text((0, -3.5), "Kawase: passes 0, 1, 2\neach read 1/4", INK, SMALL, offset=(0, -34))

    p = drawing.panel((455, 215), 60)
    grid(p, 4)
    p.box((-1, -1), (1, 1), INK, THIN, fill=PALE_BLUE)
    grid(p, 2)
    reads(p, [(0, 0)], ORANGE, "1/2", (24, 14))
    reads(p, around(1), GREEN, "1/8", (24, 14))
    p.text((0, -2), "dual filter, down\nfive reads", INK, SMALL, offset=(0, -34))

    p = drawing.panel((750, 215), 60)
    grid(p, 4)
    p.box((0, 0), (0.5, 0.5), INK, THIN, fill=PALE_BLUE)
    middle = (0.25, 0.25)
    reads(p, [(middle[0] + x, middle[1] + y) for x, y in ((-1, 0), (0, -1), (0, 1), (1, 0))], ORANGE, "1/12", (28, 14))
    reads(p, [(middle[0] + x, middle[1] + y) for x, y in around(0.5)], GREEN, "1/6", (22, 14))
    p.text((0, -2), "dual filter, up\neight reads", INK, SMALL, offset=(0, -34))
    p.text((0, 2), "texels: the image that is read", GREY, SMALL, offset=(-345, 24), rim=False)
    p.text((0, 2), "blue: the texel that is written", BLUE, SMALL, offset=(-60, 24), rim=False)
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
