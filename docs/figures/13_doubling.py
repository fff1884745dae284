"""Line lengths by recursive doubling: each pass adds the distance stored at the end of the stretch.

python3 docs/figures/13_doubling.py writes docs/images/13_doubling.svg.
"""

from drawing import BLUE, GREEN, GREY, INK, ORANGE, PALE_BLUE, PALE_GREY, Drawing

LINE = 11  # pixels


def passes():
    """Distances known after linking neighbours and after each pass of two reads."""
    known = [1 if i + 1 < LINE else 0 for i in range(LINE)]
    yield list(known)
    for _ in range(3):
        known = [known[i] + known[i + known[i]] for i in range(LINE)]
        yield list(known)


def draw() -> Drawing:
    drawing = Drawing(900, 400, "A line of eleven pixels. First each knows one step to the right, but for the last. In each pass it adds what "
                                "the pixel at the end of its stretch knows, so that stretches double: two, four, eight, and all ten")
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
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
