"""Diagrams of chapter 16's lessons: python3 docs/figures/draw.py draws them."""

from math import sqrt

from drawing import BLUE, EYE, GREEN, GREY, ORANGE, PALE_GREY, SMALL, THIN, Drawing, figure

RADIUS, HEIGHT, CENTER = 1.5, 0.7, 5.4


@figure("16_ray", 900, 420,
        "A ray enters a ball, passes its centre at a distance, and leaves it; half a chord lies to either side of the nearest "
        "place. Samples stand in the middles of equal steps; a wall ends the ray")
def draw_ray(drawing: Drawing):
    p = drawing.panel((70, 250), 95)
    half = sqrt(RADIUS * RADIUS - HEIGHT * HEIGHT)
    enters, leaves = CENTER - half, CENTER + half
    p.circle((CENTER, 0), RADIUS, GREY, THIN, fill=PALE_GREY)
    p.line([(0, HEIGHT), (8.3, HEIGHT)], BLUE, THIN)
    p.line([(CENTER, 0), (CENTER, HEIGHT)], ORANGE, THIN)
    p.dot((CENTER, 0), ORANGE)
    p.dot((CENTER, HEIGHT), ORANGE)
    steps = 8
    for i in range(steps + 1):
        x = enters + (leaves - enters) * i / steps
        p.line([(x, HEIGHT - 0.09), (x, HEIGHT + 0.09)], GREY, THIN)
    for i in range(steps):
        p.dot((enters + (leaves - enters) * (i + 0.5) / steps, HEIGHT), GREEN)
    p.eye((0, HEIGHT), 0)
    p.text((0, HEIGHT), "eye", EYE, SMALL, offset=(0, -40))
    p.text((enters, HEIGHT), "enters", BLUE, SMALL, offset=(-64, 22))
    p.text((leaves, HEIGHT), "leaves", BLUE, SMALL, offset=(12, 22))
    p.text((CENTER, HEIGHT / 2), "distance from the centre", ORANGE, SMALL, offset=(0, -64))
    p.text((CENTER, HEIGHT), "half a chord to either side", GREEN, SMALL, offset=(-110, 58))
