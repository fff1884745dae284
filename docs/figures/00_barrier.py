"""A barrier between drawing and copying: the work before it, the caches, the layout, and the work behind it.

python3 docs/figures/00_barrier.py writes docs/images/00_barrier.svg.
"""

from drawing import BLUE, GREY, INK, ORANGE, PALE_BLUE, PALE_ORANGE, PALE_RED, RED, SMALL, THIN, Drawing


def draw() -> Drawing:
    drawing = Drawing(900, 330, "Without a barrier the copy overlaps the drawing; with one it waits for the drawing's stage, whose cache is written "
                                "back, and the image changes its layout in between")
    p = drawing.panel((150, 50), 1)
    for y, waits in ((190, False), (60, True)):
        p.box((0, y), (300, y + 44), BLUE, THIN, fill=PALE_BLUE)
        p.text((150, y + 22), "draw writes *picture*", BLUE, SMALL, rim=False)
        left = 470 if waits else 160
        p.box((left, y - (0 if waits else 56) ), (left + 250, y - (0 if waits else 56) + 44), ORANGE, THIN, fill=PALE_ORANGE)
        p.text((left + 125, y - (0 if waits else 56) + 22), "copy reads *picture*", ORANGE, SMALL, rim=False)
    p.text((-14, 212), "without", RED, SMALL, anchor="end")
    p.text((-14, 82), "barrier", INK, SMALL, anchor="end")
    p.box((160, 178), (300, 190), None, fill=PALE_RED)
    p.text((330, 212), "both at once: the copy may read old pixels", RED, SMALL, anchor="start")
    p.box((318, 52), (452, 112), RED, THIN, fill=PALE_RED)
    p.text((385, 82), "flush caches,\nnew layout", RED, 16, rim=False)
    p.text((150, 26), "stage: color output\naccess: write", BLUE, 16)
    p.text((595, 26), "stage: copy\naccess: read", ORANGE, 16)
    p.arrow((0, -28), (730, -28), GREY, width=THIN)
    p.text((730, -28), "time on the GPU", GREY, SMALL, offset=(-60, 18))
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
