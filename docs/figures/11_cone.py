"""The pre-pass: a cone around the rays of a tile, as far as it is empty, and from there each ray by itself.

python3 docs/figures/11_cone.py writes docs/images/11_cone.svg.
"""

from math import hypot

from drawing import BLUE, EYE, FAINT, GREEN, GREY, ORANGE, PALE_GREY, PALE_ORANGE, SMALL, THIN, Drawing

BALLS = [((6.6, 0.95), 0.85), ((7.6, -0.7), 0.9)]
SPREAD = 0.1


def distance(x: float, y: float = 0.0) -> float:
    return min(hypot(x - c[0], y - c[1]) - r for c, r in BALLS)


def draw() -> Drawing:
    drawing = Drawing(900, 400, "A cone from the eye around the rays of a tile of pixels. Spheres along its axis are empty; the pre-pass "
                                "stops where they no longer hold the cone, and each pixel's ray begins there")
    p = drawing.panel((80, 200), 95)
    t = 0.9
    spheres = []
    for _ in range(30):
        radius = distance(t)
        advance = (radius - SPREAD * t) / (1 + SPREAD)
        spheres.append((t, radius))
        if advance < 0.25 * SPREAD * t:
            break
        t += advance
    p.line([(0, 0), (t, SPREAD * t), (t, -SPREAD * t)], ORANGE, THIN, closed=True, fill=PALE_ORANGE)
    for center, radius in BALLS:
        p.circle(center, radius, GREY, THIN, fill=PALE_GREY)
    for at, radius in spheres:
        p.circle((at, 0), radius, FAINT, THIN)
        p.dot((at, 0), BLUE)
    p.line([(0, 0), (t, 0)], BLUE, THIN)
    for i in range(-3, 4):
        slope = SPREAD * i / 3.5
        p.arrow((t, slope * t), (8.4, slope * 8.4), GREEN, width=2)
    p.eye((0, 0), 0)
    p.text((2.6, 0), "one cone for 64 pixels", ORANGE, SMALL, offset=(0, -64))
    p.text((t, 0), "from here on\neach by itself", GREEN, SMALL, offset=(-30, -110))
    p.text((0, 0), "eye", EYE, SMALL, offset=(0, -40))
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
