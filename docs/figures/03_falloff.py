"""Why light falls with the square of the distance, and the two factors that end it.

python3 docs/figures/03_falloff.py writes docs/images/03_falloff.svg.
"""

from drawing import BLUE, FAINT, GREY, INK, LIGHT, PALE_ORANGE, RED, SMALL, THIN, Drawing


def square(p, x: float, cells: int, side: float):
    """A square of cells × cells at the distance x, seen slantwise."""
    lean = 0.35
    for i in range(cells + 1):
        s = side * (i / cells - 0.5)
        p.line([(x + lean * -side / 2, s - side / 4), (x + lean * side / 2, s + side / 4)], LIGHT, THIN)
        p.line([(x + lean * s, -side / 2 + s / 2), (x + lean * s, side / 2 + s / 2)], LIGHT, THIN)


def draw() -> Drawing:
    drawing = Drawing(900, 380, "Left: what crosses one square at the distance d crosses four squares at 2 d. Right: the factors "
                                "that lead light to 0 at its range; the window leaves it alone near the lamp, the fade does not")
    p = drawing.panel((60, 210), 150)
    p.line([(0, 0), (1 - 0.105, -0.45), (1 - 0.105, 0.15), (1 + 0.105, 0.45)], None, fill=PALE_ORANGE)
    for sign in (1, -1):
        for lean in (1, -1):
            p.line([(0, 0), (2 + 0.21 * lean, sign * 0.6 + lean * 0.3)], FAINT, THIN)
    square(p, 1, 1, 0.6)
    square(p, 2, 2, 1.2)
    p.lamp((0, 0), 13)
    p.span((0, -1.08), (1, -1.08), "d", offset=(0, -32))
    p.span((1, -1.08), (2, -1.08), "d", offset=(0, -32))
    q = drawing.panel((500, 80), 250)
    q.arrow((0, 0), (1.4, 0), INK, "d / r", offset=(-8, -26))
    q.arrow((0, 0), (0, 1.12), INK)
    q.line([(0, 1), (1.0, 1)], GREY, THIN, dash=True)
    q.curve(lambda x: (x, (1 - x ** 4) ** 2), 0, 1, BLUE)
    q.curve(lambda x: (x, (1 - x) ** 2), 0, 1, RED)
    q.line([(1, 0), (1.3, 0)], INK, 5)
    q.line([(1, -0.03), (1, 0.03)], INK)
    for at, name in (((0, 0), "0"), ((1, 0), "1")):
        q.text(at, name, INK, SMALL, offset=(0, -24))
    q.text((0, 1), "1", INK, SMALL, offset=(-16, 0))
    q.text((0.72, 0.78), "window", BLUE, anchor="start", offset=(6, 0))
    q.text((0.2, 0.27), "fade", RED, offset=(-4, 0))
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
