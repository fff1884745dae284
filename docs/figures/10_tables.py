"""Four tables: the inputs of each, and the changes that rebuild it.

python3 docs/figures/10_tables.py writes docs/images/10_tables.svg.
"""

from drawing import BLUE, GREEN, GREY, INK, PALE_BLUE, PALE_GREEN, PALE_ORANGE, SMALL, Drawing


def draw() -> Drawing:
    drawing = Drawing(900, 420, "The table of transmittance is read by that of multiple scattering, and both by those of the sky and "
                                "of the volume before the eye, which the last pass reads")
    p = drawing.panel((0, 0), 1)

    def box(x, y, title, words, fill):
        p.box((x, y), (x + 240, y + 100), INK, fill=fill)
        p.text((x + 120, y + 68), title, INK)
        p.text((x + 120, y + 30), words, GREY, SMALL)
    box(30, 270, "transmittance", "height, slope: 256×64", PALE_GREEN)
    box(30, 60, "multiple", "height, sun: 32×32", PALE_GREEN)
    box(350, 270, "sky", "direction: 192×108", PALE_BLUE)
    box(350, 60, "volume", "pixel, distance: 32³", PALE_BLUE)
    box(640, 165, "picture", "each pixel: two reads", PALE_ORANGE)
    p.arrow((150, 270), (150, 166), INK)
    p.arrow((272, 320), (346, 320), INK)
    p.arrow((272, 110), (346, 110), INK)
    p.arrow((272, 280), (346, 150), INK)
    p.arrow((272, 150), (346, 280), INK)
    p.arrow((592, 310), (660, 268), INK)
    p.arrow((592, 120), (660, 162), INK)
    p.text((150, 395), "when the air changes", GREEN)
    p.text((470, 395), "in each frame", BLUE)
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
