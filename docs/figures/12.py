"""Diagrams of chapter 12's lessons: python3 docs/figures/draw.py draws them."""

import math

from drawing import (BLUE, FAINT, GREEN, INK, ORANGE, PALE_BLUE, PALE_GREEN, PALE_GREY, PALE_ORANGE, RED, SMALL, TEXT, THIN,
                     Drawing, figure)


@figure("12_chain", 900, 380,
        "The irradiance is blurred along u into an image between, from there along v into level 0; level 0 is blurred on into "
        "level 1, and so on to level 5. A wait precedes each dispatch but the first. All levels are added, each with its "
        "weights for red, green and blue")
def draw_chain(drawing: Drawing):
    p = drawing.panel((40, 8), 40)
    boxes = ((0, "irradiance", PALE_GREY), (5.2, "level 0", PALE_GREEN), (10.4, "level 1", PALE_GREEN), (15.6, "level 5", PALE_GREEN))
    for x, name, fill in boxes:
        p.box((x, 4.6), (x + 3.2, 6.6), INK, 2, fill=fill, label=name, size=TEXT)
    for x, sigma in ((0, "0.080 mm"), (5.2, "0.205 mm")):
        p.box((x + 3.0, 1.9), (x + 5.4, 3.3), INK, 2, fill=PALE_BLUE, label="between")
        p.arrow((x + 2.0, 4.5), (x + 3.4, 3.4), BLUE, width=3)
        p.text((x + 2.0, 3.7), "u", BLUE, offset=(-6, -6))
        p.arrow((x + 5.0, 3.4), (x + 6.2, 4.5), BLUE, width=3)
        p.text((x + 6.1, 3.7), "v", BLUE, offset=(4, -6))
        p.text((x + 4.2, 1.9), sigma, ORANGE, SMALL, offset=(0, -20))
    p.text((14.6, 5.6), "…", INK)
    for x in (5.2, 10.4, 15.6):
        p.arrow((x + 1.6, 6.7), (x + 1.6, 7.7), GREEN, width=3)
    p.box((5.2, 7.8), (18.8, 8.5), INK, 2, fill=PALE_ORANGE, label="sum: weights for red, green, blue")
    p.text((13.2, 2.9), "a wait before each\nblue arrow but the first", ORANGE, anchor="start")


VARIANCE = (0.0064, 0.0484, 0.187, 0.567, 1.99, 7.41)
WEIGHT = {RED: (0.233, 0.1, 0.118, 0.113, 0.358, 0.078), GREEN: (0.455, 0.336, 0.198, 0.007, 0.004, 0.0),
          BLUE: (0.649, 0.344, 0.0, 0.007, 0.0, 0.0)}


def edge(x: float, color: str) -> float:
    return sum(w * 0.5 * math.erfc(-x / math.sqrt(2 * v)) for w, v in zip(WEIGHT[color], VARIANCE))


@figure("12_edge", 900, 400,
        "Light begins at 0 mm. Blue and green rise within half a millimetre; red begins 3 mm within the shadow and is full 3 "
        "mm within the light")
def draw_edge(drawing: Drawing):
    p = drawing.panel((440, 60), 96)
    p.arrow((-4.2, 0), (4.2, 0), INK, "mm", offset=(24, 0))
    for x in range(-4, 5, 2):
        p.text((x, 0), str(x), INK, SMALL, offset=(0, -20))
    p.line([(-4, 0), (0, 0)], FAINT, 4)
    p.line([(0, 0), (0, 2.8)], FAINT, THIN, dash=True)
    for color in (BLUE, GREEN, RED):
        p.curve(lambda x, color=color: (x, 2.8 * edge(x, color)), -4, 4, color, 4, steps=300)
    p.text((-1.5, 0.62), "red: light in the shadow", RED, anchor="end")
    p.text((0.35, 1.75), "green", GREEN, anchor="start", offset=(6, -14))
    p.text((0.05, 2.66), "blue", BLUE, anchor="end", offset=(-10, -4))
    p.text((-3, 2.7), "shadow", INK)
    p.text((3, 1.2), "light", INK)


@figure("12_path", 900, 400,
        "Light meets skin. Three percent of it is reflected by the oil on the surface. The rest goes in, is scattered many "
        "times, and leaves at a distance r: blue and green near where they entered, red farther")
def draw_path(drawing: Drawing):
    p = drawing.panel((60, 60), 78)
    p.box((0, -0.1), (10, 1.9), INK, THIN, fill=PALE_ORANGE)
    p.line([(0, 1.9), (10, 1.9)], INK, 4)
    p.line([(0, 2.02), (10, 2.02)], BLUE, 2, dash=True)
    p.text((9.0, 2.02), "oil", BLUE, SMALL, offset=(0, 12))
    p.text((9.0, 0.4), "skin", INK)
    p.arrow((0.9, 4.0), (2.5, 1.95), INK, width=4)
    p.text((0.9, 4.0), "light", INK, offset=(-6, 14))
    p.arrow((2.5, 1.95), (4.1, 4.0), BLUE, width=2)
    p.text((4.1, 4.0), "3 % reflected: the light's own colour", BLUE, anchor="start", offset=(8, 4))
    p.line([(2.5, 1.9), (2.4, 1.4), (2.75, 1.1), (3.0, 1.5)], GREEN, 3)
    p.arrow((3.0, 1.5), (2.9, 2.6), GREEN, width=3)
    p.line([(2.5, 1.9), (2.2, 1.0), (3.0, 0.5), (3.6, 0.9), (4.5, 0.35), (5.4, 0.75), (6.0, 0.4), (6.3, 1.2)], RED, 3)
    p.arrow((6.3, 1.2), (6.6, 2.9), RED, width=3)
    p.span((2.5, 2.25), (6.45, 2.25), "r: up to 8 mm, for red", ORANGE, offset=(40, 10))
    p.box((2.42, 1.86), (2.58, 2.0), INK, THIN, fill=PALE_GREY)


@figure("12_stretch", 900, 360,
        "Left the map: square texels, one of them marked, and a Gaussian that is six texels wide and two high. Right the "
        "surface: the same texel is a third of a millimetre along u and one millimetre along v, and there the Gaussian is "
        "round")
def draw_stretch(drawing: Drawing):
    p = drawing.panel((50, 60), 34)
    for i in range(9):
        p.line([(i, 0), (i, 7)], INK, THIN)
    for j in range(8):
        p.line([(0, j), (8, j)], INK, THIN)
    p.box((4, 3), (5, 4), INK, 3, fill=PALE_BLUE)
    p.curve(lambda a: (4.5 + 3.0 * math.cos(a), 3.5 + math.sin(a)), 0, 6.2832, ORANGE, 4)
    p.text((4, 7), "map", INK, offset=(0, 18))
    p.arrow((0, -0.5), (2, -0.5), BLUE, "u", offset=(14, 0))
    p.arrow((-0.5, 0), (-0.5, 2), GREEN, "v", offset=(0, 14))
    q = drawing.panel((520, 60), 34)
    for i in range(9):
        q.line([(i * 0.55 + 0.5, 0), (i * 0.55 + 0.9, 7)], INK, THIN)
    for j in range(5):
        q.line([(0.5 + j * 0.1, j * 1.75), (4.9 + j * 0.1, j * 1.75)], INK, THIN)
    q.line([(2.9, 3.5), (3.45, 3.5), (3.55, 5.25), (3.0, 5.25)], INK, 3, closed=True, fill=PALE_ORANGE)
    q.curve(lambda a: (3.2 + 1.6 * math.cos(a), 4.3 + 1.6 * math.sin(a)), 0, 6.2832, ORANGE, 4)
    q.text((2.9, 7), "surface", INK, offset=(0, 18))
    q.arrow((6.2, 3.5), (7.0, 3.5), BLUE, width=3)
    q.text((7.0, 3.5), "du, in mm", BLUE, SMALL, anchor="start", offset=(8, 0))
    q.arrow((6.2, 3.5), (6.3, 5.25), GREEN, width=3)
    q.text((6.3, 5.25), "dv, in mm", GREEN, SMALL, anchor="start", offset=(8, 4))
