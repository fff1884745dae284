"""The passes of a frame, and the images between them.

python3 docs/figures/06_passes.py writes docs/images/06_passes.svg.
"""

from drawing import BLUE, GREEN, GREY, INK, ORANGE, PALE_BLUE, PALE_GREEN, PALE_ORANGE, PURPLE, Drawing


def draw() -> Drawing:
    drawing = Drawing(900, 330, "Surfaces are written into a G-buffer with depth; lights read it and write radiance; "
                                "emission is added; the forward path does all at once")
    p = drawing.panel((0, 0), 1)

    def box(x, y, wide, text, fill, color):
        p.box((x, y), (x + wide, y + 76), color, fill=fill)
        p.text((x + wide / 2, y + 38), text, INK, size=18, offset=(0, -6))

    box(30, 190, 150, "surfaces", PALE_BLUE, BLUE)
    box(260, 190, 170, "G-buffer + depth", PALE_GREEN, GREEN)
    box(520, 190, 150, "lights", PALE_ORANGE, ORANGE)
    box(750, 190, 120, "radiance", PALE_GREEN, GREEN)
    for a, b in ((180, 260), (430, 520), (670, 750)):
        p.arrow((a, 228), (b, 228), INK)
    p.text((220, 290), "raster, 12 bytes per pixel", GREY, size=18)
    p.text((600, 290), "compute, or volumes", GREY, size=18)
    box(520, 70, 150, "emission", PALE_BLUE, PURPLE)
    p.arrow((670, 108), (806, 186), PURPLE)
    p.text((595, 36), "added where depth is equal", GREY, size=18)
    p.arrow((105, 186), (105, 120), GREY)
    p.text((105, 92), "forward: lit at once,", GREY, size=18)
    p.text((105, 66), "layer by layer", GREY, size=18)
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
