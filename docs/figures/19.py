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
    for left, power, color, name in ((215, 0.0, ORANGE, "uniform: knots 0, 1, 2, 3"), (645, 0.5, BLUE, "centripetal: knots √distance apart")):
        p = drawing.panel((left, 215), 80)
        p.line(KEYS, GREY, THIN, dash=True)
        p.line(curve(power), color)
        for i, key in enumerate(KEYS):
            p.circle(key, 0.06, INK, THIN, fill=INK)
            p.text(key, f"p{i}", INK, SMALL, offset=(-28 if i == 1 else 28, -12) if i in (1, 2) else (0, -22))
        p.text((0, -2.3), name, color, SMALL)


TIMES, KNOTS = (0, 1, 2, 3, 4), (0, 1.67, 2.14, 2.56, 4.37)


def knot_at(time: float, smooth: bool) -> tuple[float, float]:
    """Knot and its slope at a time."""
    mean = [(b - a) for a, b in zip(KNOTS, KNOTS[1:])]  # a second for each pair
    slopes = [mean[0], *(min(2 * a, 2 * b, (a + b) / 2) for a, b in zip(mean, mean[1:])), mean[-1]]
    i = min(int(time), len(mean) - 1)
    u, d, m0, m1 = time - i, mean[i], slopes[i], slopes[i + 1]
    if not smooth:
        return KNOTS[i] + u * d, d
    a, b = 3 * d - 2 * m0 - m1, m0 + m1 - 2 * d
    return KNOTS[i] + u * (m0 + u * (a + u * b)), m0 + u * (2 * a + 3 * u * b)


@figure("19_timing", 860, 300,
        "Two plots over time: the knot with a corner at each key and without; its slope, a staircase and a line without a jump")
def draw_timing(drawing: Drawing):
    for left, which, scale, name in ((40, 0, 0.55, "knot t"), (480, 1, 1.1, "its slope, which scales the speed")):
        p = drawing.panel((left, 50), 82)
        p.arrow((0, 0), (4.25, 0), GREY)
        p.arrow((0, 0), (0, 2.75), GREY)
        p.text((4.2, -0.3), "time", GREY, SMALL, anchor="end")
        p.text((0.1, 2.7), name, INK, SMALL, anchor="start")
        for i in range(4):
            p.line([(i + u / 16, scale * knot_at(i + min(u / 16, 0.999), False)[which]) for u in range(17)], ORANGE, dash=True)
        p.line([(u / 32, scale * knot_at(u / 32, True)[which]) for u in range(129)], BLUE)
        for time, knot in zip(TIMES, KNOTS):
            p.circle((time, scale * knot if which == 0 else 0), 0.05, INK, THIN, fill=INK)
