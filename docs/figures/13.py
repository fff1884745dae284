"""Diagrams of chapter 13's lessons: python3 docs/figures/draw.py draws them."""

from drawing import BLUE, GREEN, GREY, INK, ORANGE, PALE_BLUE, PALE_GREY, PALE_ORANGE, RED, SMALL, THIN, Drawing, figure

LINE = 11  # pixels


def passes():
    """Distances known after linking neighbours and after each pass of two reads."""
    known = [1 if i + 1 < LINE else 0 for i in range(LINE)]
    yield list(known)
    for _ in range(3):
        known = [known[i] + known[i + known[i]] for i in range(LINE)]
        yield list(known)


@figure("13_doubling", 900, 400,
        "A line of eleven pixels. First each knows one step to the right, but for the last. In each pass it adds what the "
        "pixel at the end of its stretch knows, so that stretches double: two, four, eight, and all ten")
def draw_doubling(drawing: Drawing):
    p = drawing.panel((210, 30), 58)
    rows = list(passes())
    heights = (4.8, 3.3, 1.8, 0.3)
    for row, (known, y) in enumerate(zip(rows, heights)):
        for i in range(LINE):
            p.box((i, y), (i + 1, y + 0.8), GREY, 1, fill=PALE_BLUE if known[i] else PALE_GREY)
            p.text((i + 0.5, y + 0.4), str(known[i]), INK, rim=False, offset=(0, -1))
        p.text((-0.3, y + 0.4), ("neighbours", "pass 1", "pass 2", "pass 3")[row], (GREEN, BLUE, BLUE, BLUE)[row], anchor="end")
    for known, y, into in zip(rows, heights, heights[1:]):  # summands of the first pixel
        for source in (0, known[0]):
            p.arrow((source + 0.5, y - 0.05), (0.5 if source == 0 else 0.75, into + 0.85), ORANGE, width=2)


@figure("13_ends", 900, 230,
        "The right end of a line of edges, four times. An edge across it above: the silhouette turns up. Below: down. Both, "
        "where the line ends: no telling. Both, and the line seems to go on: two things touch with their corners, and the "
        "silhouettes part")
def draw_ends(drawing: Drawing):
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


LENGTH = 8  # of the line in the middle, pixels


@figure("13_outline", 900, 330,
        "Pixels on both sides of a staircase. The line in the middle is eight pixels long and turns up at its left end and "
        "down at its right. The silhouette goes from half a pixel above the line at one end to half a pixel below at the other, "
        "and through the line in its middle. Triangles lie between the two")
def draw_outline(drawing: Drawing):
    p = drawing.panel((60, 110), 64)
    for x in range(-1, 12):
        for y in (-1, 0):
            below = y < (1 if x < 2 else 0 if x < 2 + LENGTH else -1)
            p.box((x, y), (x + 1, y + 1), GREY, 1, fill=PALE_BLUE if below else PALE_GREY)
    start, end = 2, 2 + LENGTH
    middle = (start + end) / 2
    p.line([(start, 0.5), (middle, 0), (start, 0)], ORANGE, THIN, closed=True, fill=PALE_ORANGE)
    p.line([(end, -0.5), (middle, 0), (end, 0)], ORANGE, THIN, closed=True, fill=PALE_ORANGE)
    p.line([(-1, 1), (start, 1), (start, 0), (end, 0), (end, -1), (12, -1)], INK, 4)
    p.line([(start, 0.5), (end, -0.5)], RED, 4)
    p.dot((start, 0.5), RED)
    p.dot((end, -0.5), RED)
    p.span((start, 1.6), (end, 1.6), "the line: *L* = 8 pixels", BLUE)
    p.text((start + 0.5, 0), "0", INK, SMALL, offset=(0, -20), rim=False)
    p.text((start + 1.5, 0), "1", INK, SMALL, offset=(0, -20), rim=False)
    p.text((start + 2.5, 0), "2", INK, SMALL, offset=(0, -20), rim=False)
    p.text((start + 3.5, 0), "*p* = 3", INK, SMALL, offset=(0, -20), rim=False)
    p.text((middle + 1.6, 0.5), "the silhouette", RED, anchor="start")
    p.text((0.4, 1.4), "it turns up here", INK, SMALL)
    p.text((end + 0.6, -1.4), "and down here", INK, SMALL)


@figure("13_clip", 900, 340,
        "Colours as points: luma to the right, a colour difference upwards. Nine points of the new frame lie in a box. The history "
        "lies outside, above and to the right; on the line from the middle of the box to it, it is moved to where that line leaves "
        "the box")
def draw_clip(drawing: Drawing):
    p = drawing.panel((140, 60), 100)
    low, high, history = (1.6, 0.6), (3.6, 1.6), (5.1, 2.15)
    middle = tuple((a + b) / 2 for a, b in zip(low, high))
    share = min((high[0] - middle[0]) / (history[0] - middle[0]), (high[1] - middle[1]) / (history[1] - middle[1]))
    clipped = tuple(m + share * (h - m) for m, h in zip(middle, history))
    p.arrow((0, 0), (6.4, 0), GREY, width=THIN)
    p.arrow((0, 0), (0, 2.4), GREY, width=THIN)
    p.text((6.4, 0), "luma", GREY, SMALL, anchor="start", offset=(12, 0))
    p.text((0, 2.4), "colour difference", GREY, SMALL, anchor="start", offset=(12, 0))
    p.box(low, high, INK, THIN, fill=PALE_BLUE)
    for at in ((1.6, 0.9), (1.8, 0.6), (2.0, 1.0), (2.25, 1.35), (2.5, 0.75), (2.7, 1.4), (3.1, 1.6), (3.3, 0.9), (3.6, 1.25)):
        p.dot(at, BLUE)
    p.line([middle, history], RED, THIN, dash=True)
    p.dot(history, RED)
    p.dot(clipped, RED)
    p.text(history, "history", RED, SMALL, anchor="start", offset=(14, 0))
    p.text(clipped, "what is kept of it", RED, SMALL, anchor="start", offset=(16, -14))
    p.text((low[0], low[1]), "box around nine colours of the new frame", BLUE, SMALL, anchor="start", offset=(0, -22))
