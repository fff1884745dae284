"""Diagrams of chapter 09's lessons: python3 docs/figures/draw.py draws them."""

from math import log2

from drawing import (BLUE, FAINT, GREEN, GREY, INK, ORANGE, PALE_BLUE, PALE_GREEN, PALE_ORANGE, PALE_RED, PURPLE, RED, SMALL,
                     THIN, Drawing, figure)

# Gain for each curve that maps 0.18 to the reference's brightness: build/tests/test_09_post_effects "[figures]".
GAINS = {"clamp": 0.578, "reinhard": 0.645, "hill": 0.990, "neutral": 0.800, "agx": 0.450}


def hill(x: float) -> float:
    # For grey the matrices are 1 but for rounding.
    return (x * (x + 0.0245786) - 0.000090537) / (x * (0.983729 * x + 0.4329510) + 0.238081)


def neutral(x: float) -> float:
    x -= x - 6.25 * x * x if x < 0.08 else 0.04
    return x if x < 0.76 else 1 - 0.24 * 0.24 / (x + 0.24 - 0.76)


def agx(x: float) -> float:
    t = (min(max(log2(max(x, 1e-10)), -12.47393), 4.026069) + 12.47393) / 16.499999
    y = 0
    for c in (15.5, -40.14, 31.96, -6.868, 0.4298, 0.1191, -0.00232):
        y = y * t + c
    return min(max(y, 0), 1) ** 2.2


CURVES = {"clamp": (lambda x: min(x, 1), GREY), "reinhard": (lambda x: x / (1 + x), ORANGE), "hill": (hill, RED),
          "neutral": (neutral, GREEN), "agx": (agx, BLUE)}


def code(light: float) -> float:
    light = min(max(light, 0), 1)
    return 12.92 * light if light <= 0.0031308 else 1.055 * light ** (1 / 2.4) - 0.055


@figure("09_curves", 900, 440,
        "What is shown of grey light from 6 stops below middle grey to 8 above: clamp ends at 3.3 stops with a corner, "
        "neutral bends just before, Hill's curve is S-shaped, AgX and Reinhard bend long before")
def draw_curves(drawing: Drawing):
    p = drawing.panel((430, 70), 52)
    tall = 6.2
    p.arrow((-7, 0), (8.4, 0), INK)
    p.arrow((-7, 0), (-7, tall + 0.5), INK)
    p.line([(-7, tall), (8, tall)], FAINT, THIN, dash=True)
    p.text((-7, tall), "255", INK, SMALL, offset=(-24, 0))
    p.text((8.2, 0), "stops from middle grey", INK, anchor="end", offset=(0, -44))
    for stop in (-6, -3, 0, 3, 6):
        p.text((stop, 0), str(stop), INK, SMALL, offset=(0, -18))
    for name, (curve, color) in CURVES.items():
        p.curve(lambda s, curve=curve, name=name: (s, tall * code(curve(GAINS[name] * 0.18 * 2 ** s))), -7, 8, color, 3)
    p.text((-6.6, 5.9), "clamp", GREY, anchor="start", offset=(0, -6))
    p.text((-6.6, 5.2), "Hill", RED, anchor="start", offset=(0, -6))
    p.text((-6.6, 4.5), "neutral", GREEN, anchor="start", offset=(0, -6))
    p.text((-6.6, 3.8), "Reinhard", ORANGE, anchor="start", offset=(0, -6))
    p.text((-6.6, 3.1), "AgX", BLUE, anchor="start", offset=(0, -6))
    p.dot((0, tall * code(0.104)), PURPLE)
    p.text((0, tall * code(0.104)), "0.18: all alike", PURPLE, SMALL, anchor="start", offset=(12, -16))


GATHERS = ("radial blur", "aberration", "sharpen")
LIGHT = ("exposure", "white\nbalance")
SCREEN = ("contrast", "brightness", "saturation", "greyscale", "invert", "vignette", "scan lines", "fade", "gamma")
CODES = ("grain", "dither")


@figure("09_stack", 900, 430,
        "Effects in their order: three that look at other pixels, a pass each; then, all in one pass, exposure and white "
        "balance on light, the tone curve, nine on what a screen shows, grain and dither on codes")
def draw_stack(drawing: Drawing):
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


FOCAL, FOCUS, FAR, RADIUS = 1.0, 2.5, 5.0, 0.7


def image_of(distance: float) -> float:
    """Behind the lens, by 1 / F = 1 / z + 1 / v."""
    return FOCAL * distance / (distance - FOCAL)


@figure("09_thin_lens", 900, 400,
        "A lens focused at f: light of a point at f meets in one point of the sensor. Light of a point at z, farther away, "
        "meets in front of the sensor and spreads again to a disc there")
def draw_thin_lens(drawing: Drawing):
    p = drawing.panel((560, 200), 105)
    sensor, near = image_of(FOCUS), image_of(FAR)
    p.line([(-5.2, 0), (2.4, 0)], GREY, THIN, dash=True)
    p.curve(lambda t: (0.10 * (1 - t * t), RADIUS * t), -1, 1, INK, 3)
    p.curve(lambda t: (-0.10 * (1 - t * t), RADIUS * t), -1, 1, INK, 3)
    p.line([(sensor, -1.1), (sensor, 1.1)], INK, 5)
    for side in (-1, 1):
        p.line([(-FOCUS, 0), (0, side * RADIUS), (sensor, 0)], BLUE, 2)
        end = side * RADIUS * (1 - sensor / near)
        p.line([(-FAR, 0), (0, side * RADIUS), (near, 0), (sensor, end)], RED, 2)
    p.dot((-FOCUS, 0), BLUE)
    p.dot((-FAR, 0), RED)
    disc = RADIUS * (sensor / near - 1)
    p.line([(sensor, -disc), (sensor, disc)], ORANGE, 9)
    p.text((sensor, disc), "disc *c*", ORANGE, anchor="start", offset=(12, 0))
    p.text((sensor, 1.1), "sensor", INK, offset=(0, 20))
    p.text((0, RADIUS), "lens, *F* / *N* wide", INK, offset=(0, 26))
    p.span((-FAR, -1.15), (0, -1.15), "z", RED)
    p.span((-FOCUS, -0.8), (0, -0.8), "f", BLUE)
    p.text((-FOCUS, 0), "in focus", BLUE, SMALL, offset=(0, 24))
    p.text((-FAR, 0), "farther", RED, SMALL, offset=(14, 24))
    p.text((-1.2, 1.45), "1/z + 1/v = 1/F", GREEN)


@figure("09_gather", 900, 400,
        "Which neighbours light a pixel. Left, behind the plane of focus: of two whose discs reach the pixel, the one within "
        "the pixel's own disc counts, the one outside does not. Right, in front of it: each whose disc reaches the pixel counts, "
        "and the search goes as far as the widest near disc")
def draw_gather(drawing: Drawing):
    p = drawing.panel((0, 0), 50)
    p.text((4.3, 7.55), "behind the plane of focus", INK)
    p.text((13.4, 7.55), "in front of it", INK)
    p.line([(9, 0.3), (9, 7.7)], FAINT, THIN)
    for center, radius, color, fill in (((3.3, 4.5), 1.7, BLUE, PALE_BLUE), ((6.0, 3.8), 2.3, RED, None)):
        p.circle(center, radius, color, 2, fill=fill)
    pixel = (4.0, 3.9)
    p.circle(pixel, 1.4, INK, 2, dash=True)
    p.line([(6.0, 3.8), pixel], RED, THIN)
    p.line([(3.3, 4.5), pixel], BLUE, 2)
    p.dot(pixel, INK)
    p.dot((3.3, 4.5), BLUE)
    p.dot((6.0, 3.8), RED)
    p.text((3.3, 4.5), "counts", BLUE, SMALL, offset=(-6, 22))
    p.text((6.0, 3.8), "too far away", RED, SMALL, offset=(12, -26))
    p.text((3.4, 2.05), "the pixel's own disc", INK, SMALL)
    pixel, near = (12.4, 3.7), (14.2, 4.2)
    p.circle(near, 2.5, ORANGE, 2, fill=PALE_ORANGE)
    p.circle(pixel, 2.5, INK, 2, dash=True)
    p.line([near, pixel], ORANGE, 2)
    p.dot(pixel, INK)
    p.dot(near, ORANGE)
    p.text(near, "counts", ORANGE, SMALL, offset=(16, 22))
    p.text(pixel, "in focus", INK, SMALL, offset=(-6, -26))
    p.text((13.3, 0.6), "search: as wide as the widest near disc", INK, SMALL)
