"""Which way light goes that is scattered: Rayleigh's function, and two for dust with the same mean cosine.

python3 docs/figures/10_phase.py writes docs/images/10_phase.svg.
"""

from math import cos, pi, radians, sin, sqrt

from drawing import BLUE, FAINT, GREEN, GREY, INK, RED, SMALL, THIN, Drawing

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


def draw() -> Drawing:
    drawing = Drawing(900, 400, "Polar diagrams of phase functions: Rayleigh's, forward and back alike; Henyey and Greenstein's and "
                                "Cornette and Shanks' with a mean cosine of 0.6, mostly forward. Drawn is the root of each")
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
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
