"""A pyramid: halved on the way down, blurred once where it is smallest, brought up by tents.

python3 docs/figures/08_pyramid.py writes docs/images/08_pyramid.svg.
"""

from drawing import BLUE, GREEN, INK, ORANGE, PALE_BLUE, PALE_GREEN, PALE_GREY, PALE_ORANGE, SMALL, Drawing


def draw() -> Drawing:
    drawing = Drawing(900, 430, "Left, a picture is halved three times by 13 reads a texel. At the bottom the variance that is missing "
                                "is added by a small Gaussian. Right, tents of four reads bring it up again; for a sum of "
                                "Gaussians each level's own light is added on the way")
    p = drawing.panel((30, 4), 30)
    widths, tops = (8, 4, 2, 1), (10.6, 6.4, 3.6, 1.8)
    for i, (width, top) in enumerate(zip(widths, tops)):
        high = 0.36 * width + 0.3
        p.box((5 - width / 2, top), (5 + width / 2, top + high), INK, 2, fill=PALE_GREY if i == 0 else PALE_BLUE)
        p.box((22 - width / 2, top), (22 + width / 2, top + high), INK, 2, fill=PALE_ORANGE if i == 0 else PALE_GREEN)
        if i:
            above = tops[i - 1]
            p.arrow((5, above - 0.1), (5, top + high + 0.15), BLUE)
            p.arrow((22, top + high + 0.1), (22, above - 0.15), GREEN)
            if i < 3:
                p.arrow((5 + width / 2 + 0.3, top + high / 2), (22 - width / 2 - 0.3, top + high / 2), ORANGE, width=2, dash=True)
    p.text((5, 12.1), "cut out", INK, rim=False)
    p.text((22, 12.1), "spread", INK, rim=False)
    p.text((5, 9.4), "13 reads", BLUE, anchor="start", offset=(14, 8))
    p.text((22, 9.4), "4 reads", GREEN, anchor="start", offset=(14, 8))
    p.text((13.5, 7.3), "its own light, for a sum", ORANGE, SMALL, offset=(0, 18))
    p.arrow((5.9, 2.1), (21.1, 2.1), INK)
    p.text((13.5, 2.1), "a small Gaussian: what is missing", INK, offset=(0, -20))
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
