"""A rough reflection leans from the mirror direction towards the normal.

python3 docs/figures/14_lobe.py writes docs/images/14_lobe.svg.
"""

from math import cos, radians, sin, sqrt

from drawing import EYE, GREY, MIRROR, NORMAL, PALE_ORANGE, PURPLE, SMALL, Drawing, polar

ALPHA, VIEW = 0.45, 58.0  # the view is so many degrees from the normal


def reflected(angle: float) -> float:
    """BRDF times cosine in the plane of incidence, of light from so many degrees from the normal, away from the view."""
    l, v = radians(angle), radians(-VIEW)
    if abs(angle) >= 90:
        return 0.0
    half = 0.5 * (l + v)
    a, c = ALPHA * ALPHA, cos(half) ** 2
    density = a / (c * (a - 1) + 1) ** 2
    masking = 0.5 / (cos(v) * sqrt(cos(l) ** 2 * (1 - a) + a) + cos(l) * sqrt(cos(v) ** 2 * (1 - a) + a))
    return density * masking * cos(l)


def draw() -> Drawing:
    drawing = Drawing(900, 420, "The lobe of a rough reflection: its peak and its middle lie between the mirror direction and the normal, "
                                "along the dominant direction")
    p = drawing.panel((430, 50), 290)
    p.ground(-1.3, 1.3)
    angles = [-89 + i for i in range(179)]
    most = max(reflected(a) for a in angles)
    p.line([(0, 0)] + [polar(0.95 * reflected(a) / most, 90 - a) for a in angles], GREY, 1.6, closed=True, fill=PALE_ORANGE)
    p.arrow((0, 0), (0, 1.15), NORMAL, "*n*")
    p.arrow((0, 0), polar(1.15, 90 + VIEW), EYE, "*v*")
    p.arrow((0, 0), polar(1.15, 90 - VIEW), MIRROR, "*r*")
    share = (1 - ALPHA) * (sqrt(1 - ALPHA) + ALPHA)
    x, y = share * sin(radians(VIEW)), (1 - share) + share * cos(radians(VIEW))
    length = sqrt(x * x + y * y)
    p.arrow((0, 0), (1.15 * x / length, 1.15 * y / length), PURPLE, "*d*")
    p.text((0.9, 0.95), "α = 0.45", GREY, SMALL, offset=(60, 20))
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
