"""Diagrams of chapter 10's lessons: python3 docs/figures/draw.py draws them."""

from math import cos, exp, pi, radians, sin, sqrt

from drawing import (BLUE, FAINT, GREEN, GREY, INK, LIGHT, PALE_BLUE, PALE_GREEN, PALE_GREY, PALE_ORANGE, PURPLE, RED, SMALL,
                     THIN, Drawing, between, figure)


@figure("10_fog", 900, 380,
        "The density of fog falls by a factor of e with each scale height. A path that climbs leaves it, a level one stays, "
        "and one that sinks gets into ever more")
def draw_fog(drawing: Drawing):
    p = drawing.panel((60, 50), 130)
    p.arrow((0, 0), (0, 2.3), INK, "height", offset=(40, -4))
    p.arrow((0, 0), (2.2, 0), INK)
    p.text((1.0, 0), "density", INK, SMALL, offset=(90, -20))
    p.curve(lambda y: (2 * exp(-y / 0.7), y), 0, 2.2, PURPLE)
    p.line([(0, 0.7), (2 / 2.71828, 0.7)], GREY, THIN, dash=True)
    p.text((0.75, 0.7), "1 / falloff: 37%", GREY, SMALL, anchor="start", offset=(8, 0))
    q = drawing.panel((420, 50), 130)
    for i in range(24):
        low, high = i * 0.09, (i + 1) * 0.09
        shade = round(251 - 110 * exp(-low / 0.7))
        q.line([(0, low), (3.5, low), (3.5, high), (0, high)], None, fill=f"#{shade:02x}{shade:02x}{min(shade + 6, 255):02x}")
    q.line([(0, 0), (3.5, 0)], INK)
    eye = (0.3, 0.9)
    q.arrow(eye, (2.6, 1.95), BLUE, "x > 0", offset=(30, 0))
    q.arrow(eye, (2.83, 0.9), INK, "x = 0", offset=(36, 0))
    q.arrow(eye, (2.7, 0.1), RED, "x < 0", offset=(36, 8))
    q.dot(eye, INK, "eye", offset=(0, 20))


GROUND, TOP = 4.0, 4.75  # radii


def on(radius, angle):
    return radius * sin(radians(angle)), radius * cos(radians(angle))


def arc(radius, first, last, steps=60):
    return [on(radius, first + (last - first) * i / steps) for i in range(steps + 1)]


@figure("10_path", 900, 430,
        "An eye looks along a path through the air of a planet; at places on it sunlight, having come through the air, is "
        "scattered towards the eye")
def draw_path(drawing: Drawing):
    p = drawing.panel((450, -1010), 300)
    p.line(arc(TOP, -20, 20) + arc(GROUND, 20, -20), None, fill=PALE_BLUE, closed=True)
    p.line(arc(GROUND, -20, 20) + [on(3.7, 20), on(3.7, -20)], None, fill=PALE_GREY, closed=True)
    p.line(arc(GROUND, -20, 20), INK)
    p.line(arc(TOP, -20, 20), FAINT, THIN, dash=True)
    eye, end = on(GROUND + 0.05, -13), on(TOP, 12)
    p.line([eye, end], BLUE)
    p.dot(eye, BLUE, "eye", offset=(-6, 20))
    for share, name in ((0.2, ""), (0.5, "P"), (0.8, "")):
        place = between(eye, end, share)
        p.arrow((place[0] - 0.32 * 0.55, place[1] + 0.95 * 0.55), place, LIGHT, width=THIN if not name else 3.0)
        p.dot(place, RED, name, offset=(16, -14))
    middle = between(eye, end, 0.5)
    p.arrow(middle, between(middle, eye, 0.35), RED)
    p.text(between(middle, eye, 0.3), "scattered towards the eye", RED, SMALL, offset=(96, -26))
    p.text((middle[0] - 0.32 * 0.55, middle[1] + 0.95 * 0.55), "sunlight, less what the air\nhas taken on its way", LIGHT, SMALL,
           offset=(-190, -60))
    p.text(on(TOP, 16.5), "top of the air", GREY, SMALL, offset=(-40, 20))
    p.text(on(GROUND, 13), "ground", INK, SMALL, offset=(0, -22))


MEAN = 0.6


def rayleigh(c):
    return 3 / (16 * pi) * (1 + c * c)


def henyey_greenstein(c, g):
    return (1 - g * g) / (4 * pi) / (1 + g * g - 2 * g * c) ** 1.5


def cornette_shanks(c, g):
    return 3 / (8 * pi) * (1 - g * g) / (2 + g * g) * (1 + c * c) / (1 + g * g - 2 * g * c) ** 1.5


def g_of(mean):
    low, high = 0.0, 1.0
    for _ in range(50):
        g = 0.5 * (low + high)
        low, high = (g, high) if 3 * g * (4 + g * g) / (5 * (2 + g * g)) < mean else (low, g)
    return low


@figure("10_phase", 900, 400,
        "Polar diagrams of phase functions: Rayleigh's, forward and back alike; Henyey and Greenstein's and Cornette and "
        "Shanks' with a mean cosine of 0.6, mostly forward. Drawn is the root of each")
def draw_phase(drawing: Drawing):
    g = g_of(MEAN)
    for origin, lobes, words in (((200, 175), ((rayleigh, BLUE),), "molecules: Rayleigh"),
                                 ((560, 175), ((lambda c: henyey_greenstein(c, MEAN), RED),
                                               (lambda c: cornette_shanks(c, g), GREEN)), "dust, both with a mean cosine of 0.6")):
        p = drawing.panel(origin, 290)
        p.arrow((-0.62, 0), (-0.05, 0), INK, width=THIN)
        p.line([(0, 0), (0.95, 0)], FAINT, THIN, dash=True)
        for lobe, color in lobes:
            p.curve(lambda t, lobe=lobe: (sqrt(lobe(cos(radians(t)))) * cos(radians(t)),
                                          sqrt(lobe(cos(radians(t)))) * sin(radians(t))), 0, 360, color)
        p.text((0.1, -0.5), words, GREY)
        p.text((-0.42, 0), "light", INK, SMALL, offset=(0, -18))
    p.text((0.45, 0.38), "Henyey–Greenstein", RED, SMALL)
    p.text((0.62, -0.34), "Cornette–Shanks", GREEN, SMALL)


@figure("10_tables", 900, 420,
        "The table of transmittance is read by that of multiple scattering, and both by those of the sky and of the volume "
        "before the eye, which the last pass reads")
def draw_tables(drawing: Drawing):
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
    p.text((470, 395), "when height or sun changes", BLUE)
    p.text((470, 35), "in each frame", BLUE)
