"""Texture coordinates, the sampler between texels, and mip levels.

python3 docs/figures/00_texture.py writes docs/images/00_texture.svg.
"""

from drawing import BLUE, FAINT, GREY, INK, ORANGE, SMALL, THIN, Drawing

SIDE = 8  # texels


def shade(x: int, y: int) -> int:
    """Light stripes that lean, on dark."""
    return 235 if (x + y) % 4 < 2 else 70


def mean(size: int) -> list[list[float]]:
    step = SIDE // size
    return [[sum(shade(step * x + i, step * y + j) for i in range(step) for j in range(step)) / step ** 2 for x in range(size)]
            for y in range(size)]


def level(p, at, size: int, side: float):
    texel = side / size
    for y, row in enumerate(mean(size)):
        for x, value in enumerate(row):
            color = f"#{round(value):02x}{round(value * 0.93):02x}{round(value * 0.8):02x}"
            p.box((at[0] + x * texel, at[1] + y * texel), (at[0] + (x + 1) * texel, at[1] + (y + 1) * texel), FAINT, 1, fill=color)


def draw() -> Drawing:
    drawing = Drawing(1000, 380, "A texture of 8 by 8 texels with coordinates u and v from 0 to 1; a sample between four texel centres; the "
                                 "same texture in levels of half the size each")
    p = drawing.panel()
    left, bottom, side = 50, 70, 240
    level(p, (left, bottom), SIDE, side)
    p.arrow((left, bottom - 14), (left + side + 22, bottom - 14), INK, "*u*", width=2)
    p.arrow((left - 14, bottom), (left - 14, bottom + side + 22), INK, "*v*", width=2)
    p.text((left, bottom - 40), "0", GREY, SMALL)
    p.text((left + side, bottom - 40), "1", GREY, SMALL)
    p.text((left + side / 2 + 20, bottom + side + 40), "texture", INK, bold=True)
    # The sample.
    x, y, wide = 400, 120, 85
    for i in (0, 1):
        for j in (0, 1):
            value = shade(3 + i, 2 + j)
            color = f"#{value:02x}{round(value * 0.93):02x}{round(value * 0.8):02x}"
            p.box((x + i * wide, y + j * wide), (x + (i + 1) * wide, y + (j + 1) * wide), FAINT, 1, fill=color)
            p.dot((x + (i + 0.5) * wide, y + (j + 0.5) * wide), BLUE)
    at = (x + 0.9 * wide, y + 1.2 * wide)
    for i in (0, 1):
        for j in (0, 1):
            p.line([at, (x + (i + 0.5) * wide, y + (j + 0.5) * wide)], ORANGE, THIN)
    p.dot(at, ORANGE, radius_px=8)
    p.text((x + wide, bottom + side + 40), "sampler", INK, bold=True)
    p.text((x + wide, 70), "a weighted mean of\nthe four nearest texels", GREY, SMALL)
    low, high = [(left + i * side / SIDE, bottom + j * side / SIDE) for i, j in ((3, 2), (5, 4))]
    p.box(low, high, ORANGE, 2.2)
    p.line([(high[0], low[1]), (x, y)], GREY, THIN, dash=True)
    p.line([high, (x, y + 2 * wide)], GREY, THIN, dash=True)
    # The levels.
    at = 640
    for i, size in enumerate((8, 4, 2, 1)):
        side_px = 150 / 2 ** i
        level(p, (at, 130), size, side_px)
        p.text((at + side_px / 2, 100), f"{i}", GREY, SMALL)
        at += side_px + 22
    p.text((800, bottom + side + 40), "mip levels", INK, bold=True)
    p.text((800, 60), "each texel: the mean of four\nof the level before", GREY, SMALL)
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
