"""Diagrams of chapter 15's lessons: python3 docs/figures/draw.py draws them."""

from math import cos, exp, log, pi, sin, sqrt

from drawing import (BLUE, FAINT, GREEN, GREY, INK, ORANGE, PALE_BLUE, PALE_GREEN, PALE_GREY, PALE_ORANGE, PURPLE, RED, SMALL,
                     THIN, Drawing, figure)


@figure("15_butterfly", 900, 430,
        "A transform of eight amplitudes in three steps. In each step four pairs become their sum and their difference, and "
        "the difference is turned")
def draw_butterfly(drawing: Drawing):
    p = drawing.panel((150, 60), 1)
    columns, row = [0, 200, 400, 600], 40
    size = 8
    for step, column in enumerate(columns):
        for i in range(size):
            p.dot((column, row * (size - 1 - i)), INK, radius_px=4.5)
    for i in range(size):
        p.text((-22, row * (size - 1 - i)), f"*h*_{{{i}}}", BLUE, SMALL, anchor="end")
        p.text((622, row * (size - 1 - i)), f"*y*_{{{i}}}", ORANGE, SMALL, anchor="start")
    # Stockham's order: values a half apart meet, and their results stand beside each other, `stride` apart.
    for step in range(3):
        stride, left, right = 1 << step, columns[step], columns[step + 1]
        for j in range(size // 2):
            q, k = j & (stride - 1), j & ~(stride - 1)
            to = q + 2 * k
            for source in (j, j + size // 2):
                for target in (to, to + stride):
                    turned = target == to + stride
                    p.line([(left, row * (size - 1 - source)), (right, row * (size - 1 - target))], ORANGE if turned else BLUE,
                           2.4 if j == 0 else 1.0)
    for step in range(3):
        p.text((columns[step] + 100, row * size - 12), f"step {step + 1}", GREY, SMALL)
    p.text((300, -34), "blue: *a* + *b*    orange: (*a* − *b*) turned", INK, SMALL)


def height(x: float) -> float:
    return 0.55 * sin(0.9 * x + 0.4) + 0.28 * sin(2.3 * x) + 0.1 * sin(6.1 * x + 1)


@figure("15_chunks", 900, 330,
        "A height field drawn with short cells near the camera and cells twice and four times as long farther away; in front "
        "of each border every second vertex moves onto its neighbour")
def draw_chunks(drawing: Drawing):
    p = drawing.panel((60, 190), 92)
    p.line([(i * 0.02, height(i * 0.02)) for i in range(421)], GREY, THIN)
    for first, last, cell, color in ((0.0, 2.0, 0.25, GREEN), (2.0, 4.0, 0.5, BLUE), (4.0, 8.0, 1.0, ORANGE)):
        places = [first + cell * i for i in range(int((last - first) / cell) + 1)]
        p.line([(x, height(x)) for x in places], color)
        for x in places:
            p.dot((x, height(x)), color)
    for border in (2.0, 4.0):
        p.line([(border, -1.25), (border, 1.25)], GREY, THIN)
    p.eye((0.2, 1.2), -20)
    p.text((1.0, -1.35), "level 0", GREEN, SMALL)
    p.text((3.0, -1.35), "level 1", BLUE, SMALL)
    p.text((6.0, -1.35), "level 2", ORANGE, SMALL)


@figure("15_frame", 1000, 470,
        "A camera above a lake: one ray meets a mountain, one is mirrored by the water and partly goes down to the bed, one "
        "passes two panes of glass")
def draw_frame(drawing: Drawing):
    p = drawing.panel((0, 90), 50)
    bed = [(0, 0.7), (2, 0.6), (4.5, -0.6), (8, -0.9), (11, -0.3), (12.6, 0.9), (13.8, 2.6), (15, 3.4), (16.2, 5.2), (17.2, 6.1), (18.2, 5.3),
           (19, 4.9), (20, 4.6), (20, -1.8), (0, -1.8)]
    p.line(bed, None, fill=PALE_GREEN)
    p.line([(2.42, 0.4), (11.93, 0.4), (11, -0.3), (8, -0.9), (4.5, -0.6)], None, fill=PALE_BLUE)
    p.line(bed[:-2], GREEN)
    p.line([(2.42, 0.4), (11.93, 0.4)], BLUE)
    eye, met = (1.5, 4.2), (9, 0.4)
    # 1: the ground.
    p.arrow(eye, (16.2, 5.2), GREEN, width=2.4)
    p.text((10.6, 5.35), "1 ground: how fine?", GREEN, SMALL)
    # 2: the water, by the law of reflection, and by Snell's law with an index of 1.333.
    p.arrow(eye, met, BLUE, width=2.4)
    p.arrow(met, (14.95, 3.41), BLUE, width=2.4)
    p.arrow(met, (9.95, -0.6), BLUE, width=2.4)
    p.line([met, (9, 1.6)], GREY, THIN, dash=True)
    p.text((10.9, 2.35), "2 reflected", BLUE, SMALL)
    p.text((6.6, -0.2), "refracted, absorbed", BLUE, SMALL)
    # 3: two panes before the water.
    for x, color, pale in ((3.0, ORANGE, PALE_ORANGE), (4.3, PURPLE, PALE_BLUE)):
        p.box((x - 0.08, 0.75), (x + 0.08, 3.75), color, 2, fill=pale)
    p.text((3.65, 6.2), "3 glass: which pane first?", ORANGE, SMALL)
    p.arrow((3.65, 5.9), (3.65, 3.9), ORANGE, width=THIN)
    p.eye(eye, -12, 44)
    p.text((1.2, 5.0), "camera", INK, SMALL)
    p.text((17, 2.2), "15a Terrain", GREEN)
    p.text((8, -1.35), "15b Water", BLUE)
    p.text((3.65, 6.85), "15c Transparency", ORANGE)


AMPLITUDE = 0.55
LENGTH = 6.4
K = 2 * pi / LENGTH


def moved(x: float, steepness: float) -> tuple[float, float]:
    return x + steepness * AMPLITUDE * cos(K * x), AMPLITUDE * sin(K * x)


@figure("15_gerstner", 1000, 380,
        "A sine wave, dashed, and a Gerstner wave of the same amplitude: water at rest on a line moves on circles, forward on "
        "the crest and back in the trough; crests become sharp and troughs broad")
def draw_gerstner(drawing: Drawing):
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


SHEETS = [(2.4, 0.5, ORANGE, PALE_ORANGE), (5.0, 0.3, GREEN, PALE_GREEN), (7.6, 0.6, BLUE, PALE_BLUE)]  # place, α


@figure("15_layers", 1000, 430,
        "A ray passes three panes; the transmittance falls at each pane from 1 to 0.5, 0.35 and 0.14; the share of each pane "
        "in the pixel is its opacity times the transmittance before it")
def draw_layers(drawing: Drawing):
    p = drawing.panel((60, 265), 80)
    p.eye((0.2, 0.7), 0, 40)
    p.line([(0.5, 0.7), (10.6, 0.7)], GREY, THIN)
    for i, (x, alpha, color, pale) in enumerate(SHEETS, 1):
        p.box((x - 0.07, 0.05), (x + 0.07, 1.35), color, 2, fill=pale)
        p.text((x, 1.62), f"*c*_{{{i}}}, α_{{{i}}} = {alpha}", color, SMALL)
    p.box((10.4, 0.05), (10.7, 1.35), INK, 2, fill="#d9d7cf")
    p.text((10.45, 1.62), "background", INK, SMALL)
    q = drawing.panel((60, 70), 80)
    q.arrow((0.5, 0), (10.9, 0), GREY, "*z*", width=2)
    q.arrow((0.5, 0), (0.5, 1.75), GREY, width=2)
    q.text((0.3, 1.5), "1", GREY, SMALL)
    left, x0, share = 1.0, 0.5, []
    for x, alpha, color, _ in SHEETS:
        q.line([(x0, 1.5 * left), (x, 1.5 * left)], INK)
        q.line([(x, 1.5 * left), (x, 1.5 * left * (1 - alpha))], color, 4)
        share.append((x, left, alpha, color))
        left *= 1 - alpha
        x0 = x
    q.line([(x0, 1.5 * left), (10.7, 1.5 * left)], INK)
    for x, before, alpha, color in share:
        q.text((x, 1.5 * before * (1 - alpha / 2)), f"{before * alpha:.2f}", color, SMALL, anchor="start", offset=(12, 4))
    q.text((9.6, 1.5 * left), f"{left:.2f}", INK, SMALL, offset=(0, 16))
    q.text((1.3, 1.72), "transmittance", GREY, SMALL)
    q.text((5.6, -0.45), "each step is that layer's share of the pixel; the shares and the rest add up to 1", GREY, SMALL)


@figure("15_mirror", 1000, 400,
        "A camera above a lake sees a tower in the water; the ray to the mirrored tower is the mirrored camera's ray to the "
        "tower itself; the bed of the lake below the surface is clipped")
def draw_mirror(drawing: Drawing):
    p = drawing.panel((80, 210), 80)
    p.line([(0, 0), (10.6, 0), (10.6, -0.9), (8.6, -1.2), (2.0, -1.3), (0, -0.9)], None, fill=PALE_BLUE)
    p.line([(0, -0.9), (2.0, -1.3), (8.6, -1.2), (10.6, -0.9), (10.6, -2.4), (0, -2.4)], None, fill=PALE_GREY)
    p.line([(0, 0), (10.6, 0)], BLUE, 4)
    p.box((8.6, 0), (9.3, 1.7), INK, 2, fill=PALE_GREEN)
    p.line([(8.6, 0), (9.3, 0), (9.3, -1.7), (8.6, -1.7)], FAINT, THIN, dash=True, closed=True)
    eye, mirrored, top = (1.0, 1.5), (1.0, -1.5), (8.6, 1.7)
    x = eye[0] + (top[0] - eye[0]) * eye[1] / (eye[1] + top[1])
    p.line([eye, (x, 0)], ORANGE)
    p.arrow((x, 0), top, ORANGE)
    p.line([mirrored, (x, 0)], ORANGE, THIN, dash=True)
    p.line([(x, 0), (8.6, -1.7)], GREY, THIN, dash=True)
    p.dot((x, 0), ORANGE)
    p.eye(eye, -20, 36)
    p.eye(mirrored, 20, 36, RED)
    p.text((1.0, 2.1), "camera", BLUE, SMALL)
    p.text((1.05, -2.1), "mirrored camera", RED, SMALL)
    p.text((6.2, 0.25), "its near plane", RED, SMALL, offset=(0, 2))
    p.text((6.2, -1.75), "bed: in front of the near plane, clipped", GREY, SMALL, rim=False)


LAYERS = [(-0.75, 0.45), (-0.6, 0.35), (-0.5, 0.3), (0.35, 0.5), (0.5, 0.4), (0.62, 0.3)]  # depth from -1 to 1, opacity
OVERESTIMATION = 0.25


def moments() -> list[float]:
    absorbed = [(z, -log(1 - alpha)) for z, alpha in LAYERS]
    return [sum(a * z ** k for z, a in absorbed) for k in range(5)]


def solve(rows: list[list[float]], right: list[float]) -> list[float]:
    """Gauss's elimination with pivots."""
    n = len(right)
    m = [row + [value] for row, value in zip(rows, right)]
    for i in range(n):
        pivot = max(range(i, n), key=lambda r: abs(m[r][i]))
        m[i], m[pivot] = m[pivot], m[i]
        for r in range(i + 1, n):
            factor = m[r][i] / m[i][i]
            m[r] = [a - factor * b for a, b in zip(m[r], m[i])]
    out = [0.0] * n
    for i in reversed(range(n)):
        out[i] = (m[i][n] - sum(m[i][j] * out[j] for j in range(i + 1, n))) / m[i][i]
    return out


def estimated(z0: float) -> float:
    """Münstermann et al. 2018: the mass in front of z0 of the distribution on z0 and two other depths with these moments."""
    b = [value / moments()[0] for value in moments()]
    b = [b[0], *[value * (1 - 5e-7) for value in b[1:]]]
    c = solve([[b[i + j] for j in range(3)] for i in range(3)], [1, z0, z0 * z0])
    root = sqrt(max(c[1] ** 2 - 4 * c[2] * c[0], 0))
    depths = [z0, *sorted(((-c[1] - root) / (2 * c[2]), (-c[1] + root) / (2 * c[2])))]
    weights = solve([[z ** k for z in depths] for k in range(3)], b[:3])
    mass = OVERESTIMATION * weights[0] + sum(w for z, w in zip(depths[1:], weights[1:]) if z < z0)
    return exp(-moments()[0] * mass)


def true(z0: float) -> float:
    left = 1.0
    for z, alpha in LAYERS:
        if z < z0:
            left *= 1 - alpha
    return left


@figure("15_moments", 1000, 360,
        "Six layers in two groups along a ray; the true transmittance falls in six steps, that of four moments in a smooth "
        "curve with two falls")
def draw_moments(drawing: Drawing):
    p = drawing.panel((500, 70), 420)
    high = 0.55
    p.arrow((-1.05, 0), (1.08, 0), GREY, "*z*", width=2)
    p.arrow((-1, 0), (-1, 0.62), GREY, width=2)
    p.text((-1, high), "1", GREY, SMALL, anchor="end", offset=(-8, 0))
    for z, alpha in LAYERS:
        p.line([(z, -0.02), (z, -0.02 - 0.12 * alpha)], INK, 4)
    p.line([(-1 + 2 * i / 1000, high * true(-1 + 2 * i / 1000)) for i in range(1001)], INK)
    p.line([(-0.999 + 1.998 * i / 300, high * min(estimated(-0.999 + 1.998 * i / 300), 1)) for i in range(301)], BLUE, 2.4, dash=True)
    p.text((-0.2, 0.34), "true: a step at each layer", INK, SMALL, anchor="start")
    p.text((-0.2, 0.42), "from four moments", BLUE, SMALL, anchor="start")
    p.text((-0.93, 0.66), "transmittance", GREY, SMALL, anchor="start")
    p.text((-0.1, -0.1), "layers", GREY, SMALL)


HEIGHTS = [0.3, 0.5, 0.4, 0.7, 0.9, 0.6, 0.5, 0.8, 1.2, 1.6, 1.9, 1.5, 1.1, 0.9, 0.8, 0.6, 0.5]


@figure("15_pyramid", 900, 330,
        "A ray comes down over a height field. Where it stays above the greatest height of four or two cells it passes them "
        "in one step; near the ground it looks at single cells")
def draw_pyramid(drawing: Drawing):
    p = drawing.panel((60, 30), 48)
    for size, color in ((4, PALE_GREY), (2, GREY)):
        for first in range(0, 16, size):
            top = max(HEIGHTS[first:first + size + 1])
            p.line([(first, 0), (first, 2 * top), (first + size, 2 * top), (first + size, 0)], color, THIN)
    p.line([(i, 2 * h) for i, h in enumerate(HEIGHTS)], GREEN)
    start, end = (0.0, 5.2), (9.55, 3.52)
    p.line([start, end], BLUE)
    for x in (0.0, 4.0, 8.0, 9.0, 9.55):
        p.dot((x, start[1] + (end[1] - start[1]) * x / end[0]), ORANGE)
    p.text((10.6, 4.9), "grey: greatest heights of 2 and 4 cells", GREY, SMALL, offset=(-40, 0))
