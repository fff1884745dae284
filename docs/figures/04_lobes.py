"""GGX beside Blinn and Phong's lobe of the exponent that is matched to it, and the share of white light that GGX keeps.

python3 docs/figures/04_lobes.py writes docs/images/04_lobes.svg and prints the shares.
"""

from math import cos, pi, radians, sin, sqrt

from drawing import BLUE, FAINT, GREY, INK, RED, SMALL, THIN, Drawing

ALPHA = 0.2
EXPONENT = 2 / ALPHA ** 2 - 2


def density(cosine: float, alpha: float) -> float:
    return alpha ** 2 / (pi * (cosine * cosine * (alpha * alpha - 1) + 1) ** 2)


def visibility(light: float, view: float, alpha: float) -> float:
    a2 = alpha * alpha
    return 0.5 / (view * sqrt(light * light * (1 - a2) + a2) + light * sqrt(view * view * (1 - a2) + a2))


def kept(view: float, alpha: float, steps: int = 220) -> float:
    """Share of white light that a mirror-like surface sends to the camera: the integral over half vectors, F = 1."""
    v, total = (sqrt(1 - view * view), 0.0, view), 0.0
    for i in range(steps):
        x = (i + 0.5) / steps
        c = sqrt((1 - x) / (1 + (alpha * alpha - 1) * x))
        s = sqrt(max(1 - c * c, 0.0))
        for k in range(steps):
            turn = pi * (k + 0.5) / steps  # the other half is its mirror image
            h = (s * cos(turn), s * sin(turn), c)
            along = v[0] * h[0] + v[2] * h[2]
            light = 2 * along * h[2] - v[2]
            if along > 0 and light > 0:
                total += 4 * visibility(light, view, alpha) * light * along / c
    return total / steps ** 2


def draw() -> Drawing:
    drawing = Drawing(900, 360, "The density of microfacets over the angle to the normal, relative to its peak: GGX has a narrower peak and a longer tail than Blinn and "
                                "Phong's lobe of the matching exponent")
    p = drawing.panel((110, 70), 1)
    wide, high = 720, 240
    for degrees in range(0, 61, 15):
        x = wide * degrees / 60
        p.line([(x, 0), (x, high)], FAINT, THIN)
        p.text((x, -24), f"{degrees}°", GREY, SMALL)
    for share in (0, 0.5, 1):
        p.line([(0, high * share), (wide, high * share)], FAINT, THIN)
        p.text((-14, high * share), f"{share:g}", GREY, SMALL, anchor="end")
    p.curve(lambda a: (wide * a / 60, high * density(cos(radians(a)), ALPHA) / density(1, ALPHA)), 0, 60, BLUE)
    p.curve(lambda a: (wide * a / 60, high * cos(radians(a)) ** EXPONENT), 0, 60, RED)
    p.text((260, 96), "GGX, *α* = 0.2: a long tail", BLUE, SMALL, anchor="start")
    p.text((290, 152), f"Blinn and Phong, *n* = 2/*α*² − 2 = {EXPONENT:.0f}", RED, SMALL, anchor="start")
    p.text((wide / 2, -52), "angle between *N* and *H*", INK, SMALL)
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
    for roughness in (0.2, 0.4, 0.6, 0.8, 1.0):
        print(f"roughness {roughness}: lost", ", ".join(f"{1 - kept(view, roughness ** 2):.1%} at n.v = {view}" for view in (1.0, 0.5, 0.2)))
    for degrees in (10, 20, 30):
        print(degrees, f"{density(cos(radians(degrees)), ALPHA) / density(1, ALPHA):.4f}", f"{cos(radians(degrees)) ** EXPONENT:.5f}")
