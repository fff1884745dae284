"""Diagrams of chapter 19's lessons: python3 docs/figures/draw.py draws them."""

from math import dist

from drawing import BLUE, GREY, INK, ORANGE, SMALL, THIN, Drawing, figure

KEYS = [(1.9, -1.5), (-0.35, 0.5), (0.35, 0.5), (-1.9, -1.5)]


def curve(power: float) -> list:
    knots = [0.0]
    for a, b in zip(KEYS, KEYS[1:]):
        knots.append(knots[-1] + dist(a, b) ** power)
    points = []
    for i in range(65):
        t = knots[1] + (knots[2] - knots[1]) * i / 64
        level = list(KEYS)
        for step in (1, 2, 3):
            level = [tuple(((k1 - t) * a + (t - k0) * b) / (k1 - k0) for a, b in zip(level[j], level[j + 1]))
                     for j in range(4 - step)
                     for k0, k1 in [(knots[1], knots[2]) if step == 3 else (knots[j], knots[j + step])]]
        points.append(level[0])
    return points


@figure("19_knots", 860, 380,
        "Two Catmull-Rom curves between two near keys: the uniform one swings out beyond both, the centripetal one stays near "
        "the line")
def draw_knots(drawing: Drawing):
    """Four keys, two of them close together, and the uniform and the centripetal curve through them."""
    for left, power, color, name in ((215, 0.0, ORANGE, "uniform: knots 0, 1, 2, 3"), (645, 0.5, BLUE, "centripetal: knots √distance apart")):
        p = drawing.panel((left, 215), 80)
        p.line(KEYS, GREY, THIN, dash=True)
        p.line(curve(power), color)
        for i, key in enumerate(KEYS):
            p.circle(key, 0.06, INK, THIN, fill=INK)
            p.text(key, f"p{i}", INK, SMALL, offset=(-28 if i == 1 else 28, -12) if i in (1, 2) else (0, -22))
        p.text((0, -2.3), name, color, SMALL)
