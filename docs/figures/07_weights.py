"""Seven texels become three: the weights of 2x2 means, and of three taps.

python3 docs/figures/07_weights.py writes docs/images/07_weights.svg.
"""

from drawing import BLUE, GREY, INK, PALE_BLUE, PALE_GREEN, PALE_ORANGE, RED, SMALL, Drawing

FILLS = (PALE_BLUE, PALE_GREEN, PALE_ORANGE)


def row(p, y: float, shares: list[tuple[float, float]]):
    """Seven old texels, over them three new ones, each from where to where it takes."""
    for i in range(7):
        p.box((i, y), (i + 1, y + 0.62), INK, 2)
        p.text((i + 0.5, y + 0.31), str(i), GREY, SMALL, rim=False)
    for i, (first, last) in enumerate(shares):
        p.line([(first, y + 0.62), (last, y + 0.62), (7 * (i + 1) / 3, y + 1.35), (7 * i / 3, y + 1.35)], None,
               fill=FILLS[i])
        p.box((7 * i / 3, y + 1.35), (7 * (i + 1) / 3, y + 1.97), INK, 2, fill=FILLS[i])
        p.text((7 * (i + 0.5) / 3, y + 1.66), f"new {i}", INK, SMALL, rim=False)


def draw() -> Drawing:
    drawing = Drawing(900, 560, "Seven texels become three. Two by two leaves the seventh out and shifts the rest; three "
                                "taps weigh each texel by how much of it lies under the new one")
    p = drawing.panel((70, 60), 74)
    row(p, 3.75, [(0, 2), (2, 4), (4, 6)])
    p.text((7.2, 5.4), "2×2: nobody\ntakes texel 6", RED, SMALL, anchor="start")
    row(p, 0.55, [(0, 7 / 3), (7 / 3, 14 / 3), (14 / 3, 7)])
    p.text((7.2, 2.2), "three taps:\n7/3 texels each", BLUE, SMALL, anchor="start")
    for at, text in ((1, "3/7  3/7  1/7"), (3.5, "2/7  3/7  2/7"), (6, "1/7  3/7  3/7")):
        p.text((at, 0.22), text, BLUE, SMALL)
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
