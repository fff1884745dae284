"""The texels that a workgroup of a line blur keeps in shared memory: its own, and an apron on each side.

python3 docs/figures/08_apron.py writes docs/images/08_apron.svg.
"""

from drawing import BLUE, GREEN, INK, ORANGE, PALE_BLUE, PALE_ORANGE, SMALL, THIN, Drawing


def draw() -> Drawing:
    drawing = Drawing(900, 290, "A line of texels. A workgroup's own texels lie in the middle, and as many as the radius on each side "
                                "are its apron. Each thread reads some of them once; after the barrier it sums a stretch around its own")
    p = drawing.panel((50, 130), 40)
    for i in range(20):
        own = 5 <= i < 15
        p.box((i, 0), (i + 1, 1), INK, THIN, fill=PALE_BLUE if own else PALE_ORANGE)
    p.span((0, 1.6), (5, 1.6), "apron: radius", ORANGE)
    p.span((5, 1.6), (15, 1.6), "256 threads' own texels", BLUE)
    p.span((15, 1.6), (20, 1.6), "apron: radius", ORANGE)
    p.text((0.5, 0), "slot 0", INK, SMALL, offset=(4, -18))
    p.dot((8.5, 0.5), GREEN)
    p.arrow((8.5, -1.3), (8.5, 0.3), GREEN, width=2)
    p.line([(3.5, -1.3), (13.5, -1.3)], GREEN, 4)
    p.text((8.5, -2.2), "thread t sums slots t to t + 2 radius", GREEN)
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
