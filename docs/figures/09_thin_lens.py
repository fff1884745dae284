"""A thin lens focused at one distance, and the disc that a farther point becomes on the sensor.

python3 docs/figures/09_thin_lens.py writes docs/images/09_thin_lens.svg.
"""

from drawing import BLUE, GREEN, GREY, INK, ORANGE, RED, SMALL, THIN, Drawing

FOCAL, FOCUS, FAR, RADIUS = 1.0, 2.5, 5.0, 0.7


def image_of(distance: float) -> float:
    """Behind the lens, by 1 / F = 1 / z + 1 / v."""
    return FOCAL * distance / (distance - FOCAL)


def draw() -> Drawing:
    drawing = Drawing(900, 400, "A lens focused at f: light of a point at f meets in one point of the sensor. Light of a point at z, "
                                "farther away, meets in front of the sensor and spreads again to a disc there")
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
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
