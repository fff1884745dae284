"""Each Gaussian is made from the one before it, along u and then along v.

python3 docs/figures/12_chain.py writes docs/images/12_chain.svg.
"""

from drawing import BLUE, GREEN, INK, ORANGE, PALE_BLUE, PALE_GREEN, PALE_GREY, PALE_ORANGE, SMALL, Drawing


def draw() -> Drawing:
    drawing = Drawing(900, 380, "The irradiance is blurred along u into an image between, from there along v into level 0; level 0 is "
                                "blurred on into level 1, and so on to level 5. A wait precedes each dispatch but the first. All levels are added, "
                                "each with its weights for red, green and blue")
    p = drawing.panel((40, 8), 40)
    boxes = ((0, "irradiance", PALE_GREY), (5.2, "level 0", PALE_GREEN), (10.4, "level 1", PALE_GREEN), (15.6, "level 5", PALE_GREEN))
    for x, name, fill in boxes:
        p.box((x, 4.6), (x + 3.2, 6.6), INK, 2, fill=fill)
        p.text((x + 1.6, 5.6), name, INK, rim=False)
    for x, sigma in ((0, "0.080 mm"), (5.2, "0.205 mm")):
        p.box((x + 3.0, 1.9), (x + 5.4, 3.3), INK, 2, fill=PALE_BLUE)
        p.text((x + 4.2, 2.6), "between", INK, SMALL, rim=False)
        p.arrow((x + 2.0, 4.5), (x + 3.4, 3.4), BLUE, width=3)
        p.text((x + 2.0, 3.7), "u", BLUE, offset=(-6, -6))
        p.arrow((x + 5.0, 3.4), (x + 6.2, 4.5), BLUE, width=3)
        p.text((x + 6.1, 3.7), "v", BLUE, offset=(4, -6))
        p.text((x + 4.2, 1.9), sigma, ORANGE, SMALL, offset=(0, -20))
    p.text((14.6, 5.6), "…", INK)
    for x in (5.2, 10.4, 15.6):
        p.arrow((x + 1.6, 6.7), (x + 1.6, 7.7), GREEN, width=3)
    p.box((5.2, 7.8), (18.8, 8.5), INK, 2, fill=PALE_ORANGE)
    p.text((12, 8.15), "sum: weights for red, green, blue", INK, SMALL, rim=False)
    p.text((13.2, 2.9), "a wait before each\nblue arrow but the first", ORANGE, anchor="start")
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
