"""The order of the effects, and which of them share a pass.

python3 docs/figures/09_stack.py writes docs/images/09_stack.svg.
"""

from drawing import BLUE, GREEN, INK, ORANGE, PALE_BLUE, PALE_GREEN, PALE_ORANGE, PALE_RED, RED, SMALL, THIN, Drawing

GATHERS = ("radial blur", "aberration", "sharpen")
LIGHT = ("exposure", "white\nbalance")
SCREEN = ("contrast", "brightness", "saturation", "greyscale", "invert", "vignette", "scan lines", "fade", "gamma")
CODES = ("grain", "dither")


def draw() -> Drawing:
    drawing = Drawing(900, 430, "Effects in their order: three that look at other pixels, a pass each; then, all in one pass, exposure and "
                                "white balance on light, the tone curve, nine on what a screen shows, grain and dither on codes")
    p = drawing.panel((20, 40), 86)

    def box(x, y, words, fill, wide=1.36, high=0.62):
        p.box((x, y), (x + wide, y + high), INK, THIN, fill=fill)
        lines = words.split("\n")
        for i, line in enumerate(lines):
            p.text((x + wide / 2, y + high / 2), line, INK, SMALL, offset=(0, (len(lines) - 1) * 11 - i * 22))

    for i, words in enumerate(GATHERS):
        box(0.1 + 1.75 * i, 3.5, words, PALE_RED)
        p.arrow((1.46 + 1.75 * i, 3.81), (1.85 + 1.75 * i, 3.81), INK, width=2)
    p.text((5.5, 3.81), "a pass each: they need the\nwhole picture of the one before", RED, SMALL, anchor="start")
    p.box((0.0, -0.15), (10.1, 3.0), BLUE, 3)
    p.text((10.0, 2.72), "one pass", BLUE, anchor="end")
    for i, words in enumerate(LIGHT):
        box(0.15 + 1.5 * i, 2.15, words, PALE_ORANGE)
    box(3.15, 2.15, "tone curve", PALE_GREEN)
    for i, words in enumerate(SCREEN):
        box(0.15 + 1.5 * (i % 6), 1.2 - 0.95 * (i // 6), words, PALE_BLUE)
    for i, words in enumerate(CODES):
        box(6.15 + 1.5 * i, 0.25, words, PALE_ORANGE)
    p.text((4.65, 2.46), "light  →  screen", GREEN, SMALL, anchor="start")
    p.text((6.05, 0.56), "on codes", ORANGE, SMALL, anchor="end")
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
