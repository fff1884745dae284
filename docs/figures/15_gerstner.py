"""A Gerstner wave: water moves in circles, and gathers below the crests.

python3 docs/figures/15_gerstner.py writes docs/images/15_gerstner.svg.
"""

from math import cos, pi, sin

from drawing import BLUE, FAINT, GREY, ORANGE, PALE_BLUE, RED, SMALL, THIN, Drawing

AMPLITUDE = 0.55
LENGTH = 6.4
K = 2 * pi / LENGTH


def moved(x: float, steepness: float) -> tuple[float, float]:
    return x + steepness * AMPLITUDE * cos(K * x), AMPLITUDE * sin(K * x)


def draw() -> Drawing:
    drawing = Drawing(1000, 380, "A sine wave, dashed, and a Gerstner wave of the same amplitude: water at rest on a line moves on circles, "
                                 "forward on the crest and back in the trough; crests become sharp and troughs broad")
    p = drawing.panel((60, 175), 80)
    first, last = 0.0, 11.0
    p.line([moved(first + 0.05 * i, 1.0) for i in range(int((last - first) / 0.05) + 1)] + [(last, -1.3), (first, -1.3)], None,
           fill=PALE_BLUE)
    p.line([(first, 0), (last, 0)], FAINT, THIN)
    p.curve(lambda x: moved(x, 0.0), first, last, GREY, THIN, dash=True)
    p.curve(lambda x: moved(x, 1.0), first, last, BLUE)
    for i in range(8):
        x = 0.8 + 1.3 * i
        p.circle((x, 0), AMPLITUDE, FAINT, 1)
        p.dot((x, 0), GREY, radius_px=3)
        p.line([(x, 0), moved(x, 1.0)], ORANGE, 2)
        p.dot(moved(x, 1.0), ORANGE, radius_px=5)
    p.arrow((8.6, 1.35), (10.2, 1.35), RED, "*k*")
    p.span((LENGTH / 4, 1.35), (LENGTH * 1.25, 1.35), "2π / |*k*|", GREY, size=SMALL)
    p.text((0.0, 1.0), "sine", GREY, SMALL, anchor="start", offset=(0, 8))
    p.text((4.8, -1.05), "trough: back", BLUE, SMALL)
    p.text((8.0, -0.95), "crest: forward", BLUE, SMALL, offset=(0, -8))
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
