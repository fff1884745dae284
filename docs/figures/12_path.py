"""Light in skin: some is reflected by the oil, the rest goes in, is scattered, and leaves somewhere else.

python3 docs/figures/12_path.py writes docs/images/12_path.svg.
"""

from drawing import BLUE, GREEN, INK, ORANGE, PALE_GREY, PALE_ORANGE, RED, SMALL, THIN, Drawing


def draw() -> Drawing:
    drawing = Drawing(900, 400, "Light meets skin. Three percent of it is reflected by the oil on the surface. The rest goes in, is "
                                "scattered many times, and leaves at a distance r: blue and green near where they entered, red farther")
    p = drawing.panel((60, 60), 78)
    p.box((0, -0.1), (10, 1.9), INK, THIN, fill=PALE_ORANGE)
    p.line([(0, 1.9), (10, 1.9)], INK, 4)
    p.line([(0, 2.02), (10, 2.02)], BLUE, 2, dash=True)
    p.text((9.0, 2.02), "oil", BLUE, SMALL, offset=(0, 12))
    p.text((9.0, 0.4), "skin", INK)
    p.arrow((0.9, 4.0), (2.5, 1.95), INK, width=4)
    p.text((0.9, 4.0), "light", INK, offset=(-6, 14))
    p.arrow((2.5, 1.95), (4.1, 4.0), BLUE, width=2)
    p.text((4.1, 4.0), "3 % reflected: the light's own colour", BLUE, anchor="start", offset=(8, 4))
    p.line([(2.5, 1.9), (2.4, 1.4), (2.75, 1.1), (3.0, 1.5)], GREEN, 3)
    p.arrow((3.0, 1.5), (2.9, 2.6), GREEN, width=3)
    p.line([(2.5, 1.9), (2.2, 1.0), (3.0, 0.5), (3.6, 0.9), (4.5, 0.35), (5.4, 0.75), (6.0, 0.4), (6.3, 1.2)], RED, 3)
    p.arrow((6.3, 1.2), (6.6, 2.9), RED, width=3)
    p.span((2.5, 2.25), (6.45, 2.25), "r: up to 8 mm, for red", ORANGE, offset=(40, 10))
    p.box((2.42, 1.86), (2.58, 2.0), INK, THIN, fill=PALE_GREY)
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
