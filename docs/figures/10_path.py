"""Where a pixel's light comes from: the ground's, dimmed, and at each place on the path some of the sun's, turned.

python3 docs/figures/10_path.py writes docs/images/10_path.svg.
"""

from math import cos, radians, sin

from drawing import BLUE, FAINT, GREY, INK, LIGHT, PALE_BLUE, PALE_GREY, RED, SMALL, THIN, Drawing, between

GROUND, TOP = 4.0, 4.75  # radii


def on(radius, angle):
    return radius * sin(radians(angle)), radius * cos(radians(angle))


def arc(radius, first, last, steps=60):
    return [on(radius, first + (last - first) * i / steps) for i in range(steps + 1)]


def draw() -> Drawing:
    drawing = Drawing(900, 430, "An eye looks along a path through the air of a planet; at places on it sunlight, having come "
                                "through the air, is scattered towards the eye")
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
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
