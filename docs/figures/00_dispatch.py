"""A dispatch: workgroups of invocations, with shared memory and a barrier.

python3 docs/figures/00_dispatch.py writes docs/images/00_dispatch.svg.
"""

from drawing import BLUE, FAINT, GREEN, GREY, INK, ORANGE, PALE_BLUE, PALE_GREEN, PALE_ORANGE, RED, SMALL, THIN, Drawing


def draw() -> Drawing:
    drawing = Drawing(1010, 410, "A dispatch of four by three workgroups covers an image; one workgroup of eight by eight invocations, a "
                                 "subgroup of which runs in step; they write shared memory, wait at a barrier and read it")
    p = drawing.panel()
    left, bottom, cell = 30, 110, 70
    for y in range(3):
        for x in range(4):
            p.box((left + x * cell, bottom + y * cell), (left + (x + 1) * cell, bottom + (y + 1) * cell), BLUE, THIN,
                  fill=PALE_ORANGE if (x, y) == (2, 1) else PALE_BLUE)
    p.text((left + 2 * cell, 365), "dispatch", INK, bold=True)
    p.text((left + 2 * cell, 70), "4 × 3 workgroups\ncover the image", GREY, SMALL)
    x, y, cell = 385, 110, 27
    for j in range(8):
        for i in range(8):
            p.box((x + i * cell, y + j * cell), (x + (i + 1) * cell, y + (j + 1) * cell), FAINT, 1,
                  fill=PALE_GREEN if j >= 4 else PALE_ORANGE)
    p.box((x, y), (x + 8 * cell, y + 8 * cell), ORANGE, 2.2)
    p.box((x, y + 4 * cell), (x + 8 * cell, y + 8 * cell), GREEN, 2.2)
    p.text((x + 4 * cell, 365), "workgroup", INK, bold=True)
    p.text((x + 4 * cell, y + 6 * cell), "a subgroup", GREEN, SMALL)
    p.text((x + 4 * cell, 70), "8 × 8 invocations:\none for each pixel", GREY, SMALL)
    p.line([(30 + 3 * 70, 110 + 2 * 70), (x, y + 8 * cell)], GREY, THIN, dash=True)
    p.line([(30 + 3 * 70, 110 + 70), (x, y)], GREY, THIN, dash=True)
    at = 735
    for i in range(6):
        p.arrow((at + 45 * i, 330), (at + 45 * i, 268), BLUE, width=2)
        p.arrow((at + 45 * i, 180), (at + 45 * i, 122), BLUE, width=2)
        p.box((at - 22 + 45 * i, 232), (at + 23 + 45 * i, 264), ORANGE, THIN, fill=PALE_ORANGE)
        p.line([(at + 45 * i, 228), (at + 45 * i, 212)], BLUE, 2)
    p.line([(at - 30, 205), (at + 255, 205)], RED, 5)
    p.text((at + 112, 365), "shared memory", INK, bold=True)
    p.text((at + 112, 70), "read what others wrote", GREY, SMALL)
    p.text((at - 36, 205), "barrier", RED, SMALL, anchor="end")
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
