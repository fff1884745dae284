"""Diagrams of chapter 11's lessons: python3 docs/figures/draw.py draws them."""

from math import cos, hypot, sin

from drawing import (BLUE, EYE, FAINT, GREEN, GREY, INK, ORANGE, PALE_GREY, PALE_ORANGE, PALE_RED, RED, SMALL, THIN, Drawing,
                     figure)

CONED = [((6.6, 0.95), 0.85), ((7.6, -0.7), 0.9)]
SPREAD = 0.1


def distance(balls: list, x: float) -> float:
    """From a point of the ray to the nearest ball."""
    return min(hypot(x - c[0], c[1]) - r for c, r in balls)


@figure("11_cone", 900, 400,
        "A cone from the eye around the rays of a tile of pixels. Spheres along its axis are empty; the pre-pass stops where "
        "they no longer hold the cone, and each pixel's ray begins there")
def draw_cone(drawing: Drawing):
    p = drawing.panel((80, 200), 95)
    t = 0.9
    spheres = []
    for _ in range(30):
        radius = distance(CONED, t)
        advance = (radius - SPREAD * t) / (1 + SPREAD)
        spheres.append((t, radius))
        if advance < 0.25 * SPREAD * t:
            break
        t += advance
    p.line([(0, 0), (t, SPREAD * t), (t, -SPREAD * t)], ORANGE, THIN, closed=True, fill=PALE_ORANGE)
    for center, radius in CONED:
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


def heights(x: float, erosion: float, octaves: int = 7) -> float:
    """Waves instead of noise: only the weight's effect is shown."""
    total, slope, amplitude, frequency = 0.0, 0.0, 1.0, 1.0
    for k in range(octaves):
        phase = frequency * x + 1.3 * k
        slope += cos(phase)
        total += amplitude * sin(phase) / (1 + erosion * slope * slope)
        amplitude *= 0.46
        frequency *= 2.236
    return total


@figure("11_erosion", 900, 380,
        "Two mountain lines over each other: a plain sum of octaves is rough everywhere, the eroded one is rough on its "
        "heights and in its valleys and smooth on its slopes")
def draw_erosion(drawing: Drawing):
    for row, (erosion, color, name) in enumerate(((0.0, RED, "fBm: rough everywhere"), (1.0, BLUE, "eroded: steep places are smooth"))):
        p = drawing.panel((40, 270 - 185 * row), 56)
        p.line([(0, -1.1), (14.6, -1.1)], FAINT, THIN)
        p.curve(lambda x, e=erosion: (x, heights(x, e)), 0, 14.6, color, 2.4, steps=700)
        p.text((14.6, 1.5), name, color if color else INK, SMALL, anchor="end", offset=(0, 12))


MARCHED = [((2.6, 1.25), 0.75), ((7.0, -0.35), 0.75)]


@figure("11_march", 900, 640,
        "Above, a ray is marched by steps as long as the distance to the nearest ball: the spheres around its points touch. "
        "Below, each step is 1.4 times as long; where two spheres leave a gap between them the ray goes back")
def draw_march(drawing: Drawing):
    for row, relaxation in enumerate((1.0, 1.4)):
        p = drawing.panel((60, 490 - 330 * row), 100)
        for center, radius in MARCHED:
            p.circle(center if row == 0 else (center[0], center[1]), radius, GREY, THIN, fill=PALE_GREY)
        p.arrow((0, 0), (8.1, 0), FAINT, width=2)
        t, before, step, said = 0.0, 0.0, 0.0, False
        for _ in range(14):
            here = distance(MARCHED, t)
            gap = before + here < step - 1e-9
            color = RED if gap else BLUE
            p.circle((t, 0), here, color, THIN, dash=gap)
            p.dot((t, 0), color)
            if gap:
                if not said:
                    p.text((t, 0), "a gap: go back", RED, SMALL, offset=(0, -60))
                said = True
                t += before - step
                step = before
                continue
            if here < 0.03:
                break
            before, step = here, relaxation * here
            t += step
        p.text((0, 0), "distance" if row == 0 else "relaxed, 1.4", INK, anchor="start", offset=(-30, 112))


@figure("11_rings", 900, 450,
        "Left: a grid of square rings, each of cells twice as large as the one within. Right: where two rings meet the inner "
        "one has a vertex more, which opens a crack; moved onto its neighbour it closes it")
def draw_rings(drawing: Drawing):
    p = drawing.panel((220, 250), 22)
    for ring, cell in ((2, 4), (1, 2), (0, 1)):
        half = 2 * cell
        color = (BLUE, GREY, FAINT)[ring]
        for i in range(-2, 3):
            p.line([(-half, i * cell), (half, i * cell)], color, THIN)
            p.line([(i * cell, -half), (i * cell, half)], color, THIN)
    p.dot((0, 0), EYE)
    p.text((0, 0), "the grid stays below the eye, the noise moves", INK, SMALL, offset=(0, -206))
    heights = [0.2, 1.35, 0.7]
    for column, stitched in enumerate((False, True)):
        q = drawing.panel((470 + 220 * column, 130), 90)
        a, m, b = (0.0, heights[0]), (1.0, heights[1]), (2.0, heights[2])
        if not stitched:
            q.line([a, m, b], RED, THIN, closed=True, fill=PALE_RED)
        middle = a if stitched else m
        for left, right in ((a, middle), (middle, b)):
            if left != right:
                q.line([left, right], BLUE)
        q.line([a, b], GREY, dash=not stitched)
        for point in (a, b):
            q.dot(point, BLUE)
        q.dot(middle, GREEN if stitched else RED)
        q.text((1, 0), "stitched" if stitched else "a crack", GREEN if stitched else RED, offset=(0, -40))
