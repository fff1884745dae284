"""A decimal number rounded once, and twice: the second rounding has forgotten on which side of the middle it was.

python3 docs/figures/01_two_roundings.py writes docs/images/01_two_roundings.svg.
"""

from drawing import BLUE, GREEN, GREY, RED, SMALL, THIN, Drawing


def draw() -> Drawing:
    drawing = Drawing(900, 330, "Floats, doubles between them and a decimal number just above the midpoint of two floats: rounded "
                                "to the double at the midpoint first, it ends at the lower float instead of the upper one")
    p = drawing.panel((90, 110), 1)
    p.line([(-40, 0), (760, 0)], GREY, THIN)
    for x in range(0, 721, 45):
        p.line([(x, -9), (x, 9)], GREY, THIN)
    for x, name in ((0, "1"), (720, "1 + 2^{−23}")):
        p.line([(x, -26), (x, 26)])
        p.text((x, -46), name)
    p.line([(360, -20), (360, 20)], BLUE)
    p.text((360, -46), "the midpoint, a double", BLUE, SMALL)
    p.text((360, -86), "long marks: floats; short marks: doubles, 16 drawn of 2^{29}", GREY, SMALL)
    p.dot((374, 0), RED)
    p.arrow((450, 66), (379, 7), RED, width=THIN)
    p.text((456, 76), "decimal", RED, SMALL, anchor="start")
    p.curve(lambda t: (374 + 346 * t, 8 + 4 * 125 * t * (1 - t)), 0.02, 0.995, GREEN, arrow=True)
    p.text((547, 170), "once: the nearest float", GREEN)
    p.curve(lambda t: (358 - 356 * t, 20 + 4 * 110 * t * (1 - t)), 0.0, 0.995, RED, dash=True, arrow=True)
    p.text((180, 170), "twice: a tie, to even", RED)
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
