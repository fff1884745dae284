"""Perspective from similar triangles: a height y at the distance s is seen at the height f y / s, on a screen at the distance f.

python3 docs/figures/01_similar.py writes docs/images/01_similar.svg.
"""

from drawing import BLUE, GREY, INK, PURPLE, RED, SMALL, THIN, Drawing

FOCAL, FAR = 1.73, 5.2
TREE = 1.42


def draw() -> Drawing:
    drawing = Drawing(900, 390, "Two similar triangles with their tip at the camera: the screen stands at the distance f, from -1 to 1; a point at the "
                                "height y and the distance s is seen at f y / s")
    p = drawing.panel((90, 195), 118)
    p.line([(0, 0), (6.3, 0)], GREY, THIN)
    for side in (-1, 1):
        p.line([(0, 0), (2.15, side * 2.15 / FOCAL)], GREY, THIN, dash=True)
    p.line([(FOCAL, -1), (FOCAL, 1)], BLUE, 5)
    for y, name in ((1, "1"), (-1, "−1")):
        p.text((FOCAL, y), name, BLUE, SMALL, offset=(-16, 10 * y))
    p.text((FOCAL, -1.0), "screen", BLUE, SMALL, offset=(42, 2))
    p.line([(FAR, 0), (FAR, TREE)], INK, 5)
    p.text((FAR, TREE / 2), "*y*", INK, offset=(20, 0))
    p.line([(0, 0), (FAR, TREE)], RED, 2)
    p.line([(FOCAL, 0), (FOCAL, FOCAL * TREE / FAR)], RED, 7)
    p.text((FOCAL, 0.27), "*f* *y* / *s*", RED, offset=(52, -4))
    p.eye((0, 0), 0, 40)
    p.span((0, -0.34), (FOCAL, -0.34), "")
    p.text((FOCAL / 2, -0.34), "*f*", GREY, offset=(0, -18))
    p.span((0, -1.35), (FAR, -1.35), "*s* = −*z*", offset=(0, -34))
    p.arc((0, 0), 0.62, -30, 30, "", PURPLE)
    p.text((0.62, 0), "*φ*", PURPLE, offset=(18, 16))
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
