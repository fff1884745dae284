"""Crossing edges at the end of a line, and the side to which the outline then turns.

python3 docs/figures/13_ends.py writes docs/images/13_ends.svg.
"""

from drawing import BLUE, GREY, INK, PALE_BLUE, PALE_GREY, PALE_ORANGE, RED, SMALL, Drawing


def draw() -> Drawing:
    drawing = Drawing(900, 230, "The right end of a line of edges, four times. An edge across it above: the outline turns up. Below: down. Both, "
                                "where the line ends: no telling. Both, and the line seems to go on: two things touch with their corners, "
                                "and the outlines part")
    fills = {"0": PALE_GREY, "1": PALE_BLUE, "2": PALE_ORANGE}
    # Colours of above left, above right, below left, below right.
    squares = (("above: turns up", "0", "1", "1", "1", 1), ("below: turns down", "0", "0", "1", "0", -1),
               ("both: does not turn", "0", "2", "1", "2", 0), ("corners touch: parts", "0", "1", "1", "0", 2))
    for i, (name, al, ar, bl, br, turn) in enumerate(squares):
        p = drawing.panel((40 + 220 * i, 120), 40)
        for x in range(4):
            right = x >= 2.5
            p.box((x, 0), (x + 1, 1), GREY, 1, fill=fills[ar if right else al])
            p.box((x, -1), (x + 1, 0), GREY, 1, fill=fills[br if right else bl])
        p.line([(0, 0), (3, 0)], INK, 4)
        if turn in (1, 0, 2):
            p.line([(3, 0), (3, 1)], INK, 4)
        if turn in (-1, 0, 2):
            p.line([(3, 0), (3, -1)], INK, 4)
        if turn == 2:
            p.line([(3, 0), (4, 0)], INK, 4)
        if turn in (1, -1):
            p.line([(1, 0), (3, 0.5 * turn)], RED, 4)
            p.dot((3, 0.5 * turn), RED)
        elif turn == 2:
            p.line([(1, 0), (3, -0.5)], RED, 4)
            p.dot((3, -0.5), RED)
            p.line([(0, 1), (0, 0)], INK, 4)
            p.text((0, 1), "it came from above", BLUE, SMALL, offset=(75, 20))
        p.text((2, -1), name, INK, SMALL, offset=(0, -26))
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
