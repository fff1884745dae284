"""Diagrams of chapter 07's lessons: python3 docs/figures/draw.py draws them."""

from drawing import BLUE, GREEN, GREY, INK, ORANGE, PALE_BLUE, PALE_GREEN, PALE_ORANGE, RED, SMALL, Drawing, figure


@figure("07_tiles", 900, 470,
        "Each workgroup reads a tile of 64 by 64 texels and makes six levels of it; each counts when it has finished, and the "
        "one that finds all others counted makes the last six levels")
def draw_tiles(drawing: Drawing):
    p = drawing.panel((40, 90), 40)
    for x in range(4):
        for y in range(4):
            mine = (x, y) == (1, 2)
            p.box((1.6 * x, 1.6 * y), (1.6 * (x + 1), 1.6 * (y + 1)), INK, 2, fill=PALE_BLUE if mine else None)
    p.text((3.2, 7.1), "level 0, in tiles of 64×64", INK, SMALL)
    p.arrow((3.2, 4.0), (7.4, 4.0), BLUE)
    side, x = 2.4, 7.6
    for i, (name, fill) in enumerate((("1", PALE_BLUE), ("2", PALE_BLUE), ("3", PALE_GREEN), ("4", PALE_GREEN),
                                      ("5", PALE_GREEN), ("6", PALE_GREEN))):
        size = max(side / 2**i, 0.16)
        p.box((x, 4.0 - size / 2), (x + size, 4.0 + size / 2), INK, 2, fill=fill)
        p.text((x + size / 2, 4.0 - size / 2), name, GREY, SMALL, offset=(0, -16))
        x += size + 0.42
    p.text((8.8, 6.0), "in registers", BLUE, SMALL)
    p.text((12.6, 6.0), "in shared memory", GREEN, SMALL)
    p.arrow((x, 4.0), (x + 1.3, 4.0), ORANGE)
    p.box((x + 1.5, 2.4), (x + 4.7, 5.6), ORANGE, 2, fill=PALE_ORANGE)
    p.text((x + 3.1, 4.45), "16 means\nin a buffer", ORANGE, SMALL, rim=False)
    p.text((x + 3.1, 3.0), "finished: 15", RED, SMALL, rim=False)
    p.text((13.6, 0.6), "The workgroup that finds 15 of 16 counted is the last one:\nit treats the buffer as a tile and makes "
                        "levels 7 and 8.", INK, SMALL)
    p.text((3.2, -0.8), "16 workgroups", GREY, SMALL)


FILLS = (PALE_BLUE, PALE_GREEN, PALE_ORANGE)


def row(p, y: float, shares: list[tuple[float, float]]):
    """Seven old texels, over them three new ones, each from where to where it takes."""
    for i in range(7):
        p.box((i, y), (i + 1, y + 0.62), INK, 2, label=str(i), ink=GREY)
    for i, (first, last) in enumerate(shares):
        p.line([(first, y + 0.62), (last, y + 0.62), (7 * (i + 1) / 3, y + 1.35), (7 * i / 3, y + 1.35)], None,
               fill=FILLS[i])
        p.box((7 * i / 3, y + 1.35), (7 * (i + 1) / 3, y + 1.97), INK, 2, fill=FILLS[i], label=f"new {i}")


@figure("07_weights", 900, 560,
        "Seven texels become three. Two by two leaves the seventh out and shifts the rest; three taps weigh each texel by how "
        "much of it lies under the new one")
def draw_weights(drawing: Drawing):
    p = drawing.panel((70, 60), 74)
    row(p, 3.75, [(0, 2), (2, 4), (4, 6)])
    p.text((7.2, 5.4), "2×2: nobody\ntakes texel 6", RED, SMALL, anchor="start")
    row(p, 0.55, [(0, 7 / 3), (7 / 3, 14 / 3), (14 / 3, 7)])
    p.text((7.2, 2.2), "three taps:\n7/3 texels each", BLUE, SMALL, anchor="start")
    for at, text in ((1, "3/7  3/7  1/7"), (3.5, "2/7  3/7  2/7"), (6, "1/7  3/7  3/7")):
        p.text((at, 0.22), text, BLUE, SMALL)
