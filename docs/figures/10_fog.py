"""Fog that thins with height: three paths of one length through it.

python3 docs/figures/10_fog.py writes docs/images/10_fog.svg.
"""

from math import exp

from drawing import BLUE, GREY, INK, PURPLE, RED, SMALL, THIN, Drawing


def draw() -> Drawing:
    drawing = Drawing(900, 380, "The density of fog falls by a factor of e with each scale height. A path that climbs leaves it, a "
                                "level one stays, and one that sinks gets into ever more")
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
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
