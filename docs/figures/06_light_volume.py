"""A light's volume: its back faces, where they are behind the surface.

python3 docs/figures/06_light_volume.py writes docs/images/06_light_volume.svg.
"""

from drawing import EYE, GREEN, GREY, INK, LIGHT, PALE_ORANGE, RED, THIN, Drawing, polar


def draw() -> Drawing:
    drawing = Drawing(900, 400, "Rays from a camera outside and one inside a light's sphere: the back face is behind "
                                "the surface where the surface may be lit, and in front of it where it is not")
    p = drawing.panel((440, 70), 100)
    p.circle((0, 1.1), 1.5, LIGHT, dash=True, fill=PALE_ORANGE)
    p.ground(-3.9, 4.2)
    p.line([(2.5, 0), (2.5, 2.9), (3.1, 2.9), (3.1, 0)], INK)
    p.lamp((0, 1.1))
    p.eye((-3.6, 2.5), -25, 36)
    p.eye((-0.5, 2.0), 10, 36)
    p.line([(-3.6, 2.5), (0.35, 0)], EYE, THIN)
    p.dot((0.35, 0), GREEN)
    p.line([(0.35, 0), (0.9, -0.35)], GREY, THIN, dash=True)
    p.text((0.2, -0.45), "surface first, back face behind it: lit", GREEN, size=18)
    p.line([(-0.5, 2.0), (2.5, 2.2)], EYE, THIN)
    p.dot(polar(1.5, 45, (0, 1.1)), LIGHT)
    p.dot((2.5, 2.2), RED)
    p.text((2.8, 3.05), "back face first: skipped", RED, size=18)
    p.text((-3.6, 2.95), "camera outside", EYE, size=18)
    p.text((-0.45, 2.85), "camera inside", EYE, size=18)
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
