"""Diagrams of chapter 05's lessons: python3 docs/figures/draw.py draws them."""

from math import hypot, radians, tan

from drawing import (BLUE, EYE, FAINT, GREEN, GREY, INK, LIGHT, ORANGE, PALE_BLUE, PALE_GREY, PURPLE, RED, SMALL, THIN, Drawing,
                     figure, polar)

BIAS_SLOPE = 35  # degrees between the surface and the map's plane: the angle between its normal and the light
TEXELS = 4


def height(x: float) -> float:
    return -tan(radians(BIAS_SLOPE)) * (x - 2)


@figure("05_bias", 900, 470,
        "A sloped surface under vertical light, cut along the diagonal of the map's texels. Each texel holds the depth at its "
        "centre: half of the surface under it is lower and appears to be in shadow, by up to half of the diagonal times the "
        "tangent")
def draw_bias(drawing: Drawing):
    p = drawing.panel((60, 258), 135)
    p.line([(0, height(0)), (TEXELS, height(TEXELS)), (TEXELS, -1.45), (0, -1.45)], None, fill=PALE_GREY)
    for i in range(TEXELS):
        middle = i + 0.5
        p.line([(i, 1.45), (i, height(i))], FAINT, THIN, dash=True)
        p.line([(middle, height(middle)), (i + 1, height(i + 1))], RED, 5)
        p.line([(i, height(i)), (middle, height(middle))], GREEN, 5)
        p.line([(i, height(middle)), (i + 1, height(middle))], INK)
        p.dot((middle, height(middle)), INK)
    p.line([(TEXELS, 1.45), (TEXELS, height(TEXELS))], FAINT, THIN, dash=True)
    for x in (1.5, 2.5, 3.5):
        p.arrow((x, 1.45), (x, height(x) + 0.12), LIGHT, width=THIN)
    p.span((2, 1.3), (3, 1.3), "diagonal √2 *t*", offset=(0, 0), size=SMALL)
    edge = TEXELS - 1
    p.span((edge + 1.12, height(edge + 0.5)), (edge + 1.12, height(edge + 1)), "", RED)
    p.text((edge + 1.2, 0.5 * (height(edge + 0.5) + height(edge + 1))), "½ √2 *t* tan θ", RED, anchor="start")
    p.line([(1.2, height(2)), (2.0, height(2))], GREY, THIN, dash=True)
    p.arc((2, height(2)), 0.62, 180 - BIAS_SLOPE, 180, "θ", GREY, size=SMALL)
    key = drawing.panel()
    for x, color, name in ((60, GREEN, "lit"), (150, RED, "below its own texel: acne"), (450, INK, "depth in the map"), (690, ORANGE, "light")):
        key.dot((x, 20), color, radius_px=7)
        key.text((x + 16, 20), name, INK, SMALL, anchor="start")


NEAR, FAR, LIGHT_SLOPE = 1.1, 2.4, 0.55  # of the slice; half its width over the distance


@figure("05_fit", 900, 430,
        "Left: a slice of the camera's view from above, the ball around it, and the box of parallel rays around the ball. "
        "Right: the box may start only on a grid of texels that is fixed in the world")
def draw_fit(drawing: Drawing):
    p = drawing.panel((70, 205), 108)
    p.eye((0, 0), 0, 36)
    corners = [(NEAR, LIGHT_SLOPE * NEAR), (FAR, LIGHT_SLOPE * FAR), (FAR, -LIGHT_SLOPE * FAR), (NEAR, -LIGHT_SLOPE * NEAR)]
    for side in (-1, 1):
        p.line([(0, 0), (FAR, side * LIGHT_SLOPE * FAR)], EYE, THIN, dash=True)
    p.line(corners, BLUE, THIN, closed=True, fill=PALE_BLUE)
    middle = min(0.5 * (NEAR + FAR) * (1 + LIGHT_SLOPE ** 2), FAR)
    radius = hypot(FAR - middle, LIGHT_SLOPE * FAR)
    p.circle((middle, 0), radius, GREEN, THIN)
    turn = 18

    def of_light(a, b):
        return polar(b, turn + 90, polar(a, turn, (middle, 0)))

    box = [of_light(-radius, -radius), of_light(radius, -radius), of_light(radius, radius), of_light(-radius, radius)]
    p.line(box, LIGHT, closed=True)
    for share in (-0.75, -0.25, 0.25):
        p.arrow(of_light(share * radius, radius + 0.3), of_light(share * radius, radius + 0.04), LIGHT, width=THIN)
    p.text((1.75, 0), "slice", BLUE, SMALL, rim=False)
    p.text(of_light(0, -radius), "light's box without its margin", LIGHT, SMALL, offset=(110, -34))
    p.dot((middle, 0), GREEN, radius_px=4)
    # The grid of the map's texels.
    q = drawing.panel((590, 95), 34)
    for i in range(9):
        q.line([(i, 0), (i, 8)], FAINT, 1)
        q.line([(0, i), (8, i)], FAINT, 1)
    q.box((1.4, 1.3), (6.4, 6.3), GREY, THIN, dash=True)
    q.box((1, 1), (6, 6), LIGHT)
    q.arrow((3.9, 3.8), (3.5, 3.5), PURPLE, width=2)
    q.dot((3.9, 3.8), GREY, radius_px=4)
    q.text((4, 8.7), "texels, fixed in the world", INK, SMALL)
    q.text((4, -0.8), "dashed: as fitted; solid: snapped", GREY, SMALL)


LAMP, EDGE = 3.0, 1.55  # heights above the ground
HALF = 0.5              # of the light's size


@figure("05_penumbra", 900, 470,
        "A light of size s, an edge at distance b from it and the ground at distance r: the penumbra is s (r - b) / b wide")
def draw_penumbra(drawing: Drawing):
    p = drawing.panel((430, 60), 125)
    p.ground(-2.6, 2.6)
    p.line([(-HALF, LAMP), (HALF, LAMP)], LIGHT, 7)
    p.text((HALF, LAMP), "light, *s*", LIGHT, offset=(16, 0), anchor="start")
    p.line([(-2.0, EDGE), (0, EDGE)], INK, 7)
    p.text((-2.0, EDGE), "blocker", INK, SMALL, offset=(0, 20), anchor="start")
    ends = []
    for x in (-HALF, HALF):
        end = -x * EDGE / (LAMP - EDGE)
        ends.append(end)
        p.line([(x, LAMP), (end, 0)], LIGHT, THIN, dash=True)
    p.line([(min(ends), 0), (max(ends), 0)], PURPLE, 7)
    p.line([(-2.6, 0), (min(ends), 0)], INK, 7)
    p.text((0, 0), "penumbra  *w* = *s* (*r* − *b*) / *b*", PURPLE, offset=(20, -38))
    p.text((-2.55, 0), "umbra", INK, SMALL, offset=(0, 18), anchor="start")
    p.text((1.4, 0), "lit", GREY, SMALL, offset=(0, 18), anchor="end")
    p.span((2.0, LAMP), (2.0, EDGE), "")
    p.text((2.0, 0.5 * (LAMP + EDGE)), "*b*", GREY, offset=(18, 0))
    p.span((2.5, LAMP), (2.5, 0.0), "")
    p.text((2.5, 0.5 * LAMP), "*r*", GREY, offset=(18, 0))
    p.line([(HALF + 1.05, LAMP), (2.6, LAMP)], FAINT, THIN, dash=True)
    p.line([(0.05, EDGE), (2.1, EDGE)], FAINT, THIN, dash=True)
    p.dot((0, EDGE), RED)
