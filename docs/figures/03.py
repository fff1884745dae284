"""Diagrams of chapter 03's lessons: python3 docs/figures/draw.py draws them."""

from math import cos, radians, sin, tan

from drawing import (BLUE, FAINT, GREEN, GREY, INK, LIGHT, PALE_BLUE, PALE_GREY, PALE_ORANGE, RED, SMALL, THIN, Drawing, figure,
                     polar)

NEAR, FAR = 1.0, 7.4  # depth range of a tile, in units
SLOPES = (-0.07, 0.0, 0.15)  # the tiles' sides
LOW, HIGH = SLOPES[1:]  # of the tile in question
LIGHTS = [(1.45, 0.1, 0.22), (2.35, 0.3, 0.24), (3.5, 0.45, 0.28), (4.45, 0.3, 0.28), (6.9, 0.55, 0.33)]
SLICES = 5


def piece(p, near: float, far: float, fill):
    p.line([(near, LOW * near), (far, LOW * far), (far, HIGH * far), (near, HIGH * near)], BLUE, closed=True, fill=fill)


def view(p, title: str, clusters: bool):
    borders = [NEAR * (FAR / NEAR) ** (i / SLICES) for i in range(SLICES + 1)]
    for slope in SLOPES:
        p.line([(0, 0), (FAR, slope * FAR)], GREY, THIN)
    p.line([(0.9, -0.3), (1.12, -0.3), (1.12, 0.07), (0.9, 0.07)], INK, THIN, closed=True, fill=PALE_GREY)
    if clusters:
        for i, (near, far) in enumerate(zip(borders, borders[1:])):
            piece(p, near, far, PALE_BLUE if i in (0, SLICES - 1) else "#ffffff")
    else:
        piece(p, NEAR, FAR, PALE_BLUE)
    p.line([(FAR, -0.6), (FAR, 1.35)], INK, 6)
    for x, y, radius in LIGHTS:
        reached = not clusters or x < borders[1] or x > borders[-2]
        p.circle((x, y), radius, LIGHT if reached else GREY, THIN, dash=not reached, fill=PALE_ORANGE if reached else None)
        p.dot((x, y), LIGHT if reached else GREY, radius_px=4)
    p.eye((0, 0), 0, 44)
    p.text((0.0, 1.15), title, INK, anchor="start")
    p.text((1.0, -0.5), "post", GREY, SMALL)
    p.text((FAR, 1.25), "wall", GREY, SMALL, anchor="end", offset=(-12, 0))


@figure("03_cells", 900, 480,
        "A tile that sees a post near by and a wall far away, from the side. As one piece it keeps all five lights; cut into "
        "slices of depth it keeps the two that are where surfaces are")
def draw_cells(drawing: Drawing):
    view(drawing.panel((55, 315), 110), "a tile in one piece keeps five lights", False)
    view(drawing.panel((55, 75), 110), "in slices, those with surfaces keep two", True)


INNER, OUTER, POINT = 17, 36, 26  # half angles, and that of a point between them
BRIGHT = "#f7c873"


def light(angle: float, softness: float) -> float:
    inner, outer = cos(radians(INNER)), cos(radians(OUTER))
    t = min(max((cos(radians(angle)) - outer) / (inner - outer), 0), 1)
    return t ** (1 + (0.35 - 1) * softness)


@figure("03_cone", 900, 400,
        "Left: a lamp, its axis, the inner and the outer half angle, and a point at the angle gamma between them. Right: how "
        "much light passes, by the angle, with softness 0 and 1")
def draw_cone(drawing: Drawing):
    height = 1.25
    p = drawing.panel((215, 60 + 210 * height), 210)
    p.line([(0, 0), (-height * tan(radians(OUTER)), -height), (height * tan(radians(OUTER)), -height)], None, fill=PALE_ORANGE)
    p.line([(0, 0), (-height * tan(radians(INNER)), -height), (height * tan(radians(INNER)), -height)], None, fill=BRIGHT)
    p.ground(-0.97, 0.97, -height)
    p.arrow((0, 0), (0, -1.02), LIGHT, "axis", offset=(0, -12), size=SMALL, rim=False)
    p.lamp((0, 0), 12)
    at = (height * tan(radians(POINT)), -height)
    p.line([(0, 0), at], BLUE, THIN)
    p.dot(at, BLUE)
    p.arc((0, 0), 0.95, 270, 270 + POINT, color=BLUE)
    p.text(polar(0.95, 270 + 21), "γ", BLUE, offset=(-16, 14))
    p.arc((0, 0), 0.42, 270, 270 + OUTER)
    p.text(polar(0.5, 270 + OUTER), "γ_{outer}", INK, SMALL, anchor="start", offset=(8, 0))
    p.arc((0, 0), 0.7, 270 - INNER, 270)
    p.text(polar(0.82, 270 - 26.5), "γ_{inner}", INK, SMALL, rim=False)
    q = drawing.panel((520, 80), 1)
    wide, high = 6.8, 230
    q.arrow((0, 0), (330, 0), INK, "γ", offset=(8, -24))
    q.arrow((0, 0), (0, 275), INK)
    for angle, name in ((INNER, "γ_{inner}"), (OUTER, "γ_{outer}")):
        q.line([(wide * angle, 0), (wide * angle, high)], GREY, THIN, dash=True)
        q.text((wide * angle, 0), name, INK, SMALL, offset=(0, -24))
    q.text((0, high), "1", INK, SMALL, offset=(-16, 0))
    for softness, color in ((0, RED), (1, BLUE)):
        q.curve(lambda angle, softness=softness: (wide * angle, high * light(angle, softness)), 0, 50, color, steps=250)
    q.text((wide * OUTER, high * 0.8), "softness 1", BLUE, SMALL, anchor="start", offset=(8, 0))
    q.text((wide * INNER, high * 0.17), "softness 0", RED, SMALL, anchor="start", offset=(6, 0))


HALF = 24  # of the cone, in degrees; its axis points to the right


@figure("03_cone_ball", 900, 425,
        "A cone and the middles of three balls: one within the cone, distance 0; one beside it, distance l sin a to the "
        "cone's side; one more than 90 degrees from the side, distance l to the apex")
def draw_cone_ball(drawing: Drawing):
    p = drawing.panel((330, 192), 230)
    p.line([(0, 0), polar(1.86, HALF), polar(1.86, -HALF)], None, fill=PALE_ORANGE)
    for side in (HALF, -HALF):
        p.line([(0, 0), polar(1.86, side)], LIGHT)
    p.arrow((0, 0), (1.6, 0), LIGHT, "axis", at=0.85, offset=(0, -18), size=SMALL)
    p.arc((0, 0), 0.75, 0, HALF)
    p.text(polar(0.6, 10), "γ_{outer}", INK, SMALL, offset=(2, 0))
    p.dot(polar(1.35, 12), GREEN, "0", offset=(18, 0))
    beside, angle = polar(1.05, HALF + 40), 40
    p.line([(0, 0), beside], BLUE, THIN)
    p.text(polar(0.62, HALF + 40), "l", BLUE, offset=(-14, 6))
    p.arc((0, 0), 0.32, HALF, HALF + angle, "a", BLUE)
    foot = polar(1.05 * cos(radians(angle)), HALF)
    p.line([beside, foot], BLUE)
    p.right_angle(foot, HALF + 90, color=BLUE)
    p.dot(beside, BLUE)
    p.text(((beside[0] + foot[0]) / 2, (beside[1] + foot[1]) / 2), "l sin a", BLUE, anchor="start", offset=(10, 8))
    behind = polar(0.85, HALF + 130)
    p.line([(0, 0), behind], RED)
    p.dot(behind, RED)
    p.text(polar(0.45, HALF + 130), "l", RED, offset=(4, 18))
    p.arc((0, 0), 0.2, HALF, HALF + 130, color=RED)
    p.text((-0.34, 0.46), "a > 90°", RED, SMALL, anchor="end")
    p.line([(0, 0), polar(0.8, HALF + 90)], RED, THIN, dash=True)
    p.lamp((0, 0), 9)
    assert abs(1.05 * sin(radians(angle)) - ((beside[0] - foot[0]) ** 2 + (beside[1] - foot[1]) ** 2) ** 0.5) < 1e-9


def square(p, x: float, cells: int, side: float):
    """A square of cells × cells at the distance x, seen slantwise."""
    lean = 0.35
    for i in range(cells + 1):
        s = side * (i / cells - 0.5)
        p.line([(x + lean * -side / 2, s - side / 4), (x + lean * side / 2, s + side / 4)], LIGHT, THIN)
        p.line([(x + lean * s, -side / 2 + s / 2), (x + lean * s, side / 2 + s / 2)], LIGHT, THIN)


@figure("03_falloff", 900, 380,
        "Left: what crosses one square at the distance d crosses four squares at 2 d. Right: the factors that lead light to 0 "
        "at its range; the window leaves it alone near the lamp, the fade does not")
def draw_falloff(drawing: Drawing):
    p = drawing.panel((60, 210), 150)
    p.line([(0, 0), (1 - 0.105, -0.45), (1 - 0.105, 0.15), (1 + 0.105, 0.45)], None, fill=PALE_ORANGE)
    for sign in (1, -1):
        for lean in (1, -1):
            p.line([(0, 0), (2 + 0.21 * lean, sign * 0.6 + lean * 0.3)], FAINT, THIN)
    square(p, 1, 1, 0.6)
    square(p, 2, 2, 1.2)
    p.lamp((0, 0), 13)
    p.span((0, -1.08), (1, -1.08), "d", offset=(0, -32))
    p.span((1, -1.08), (2, -1.08), "d", offset=(0, -32))
    q = drawing.panel((500, 80), 250)
    q.arrow((0, 0), (1.4, 0), INK, "d / r", offset=(-8, -26))
    q.arrow((0, 0), (0, 1.12), INK)
    q.line([(0, 1), (1.0, 1)], GREY, THIN, dash=True)
    q.curve(lambda x: (x, (1 - x ** 4) ** 2), 0, 1, BLUE)
    q.curve(lambda x: (x, (1 - x) ** 2), 0, 1, RED)
    q.line([(1, 0), (1.3, 0)], INK, 5)
    q.line([(1, -0.03), (1, 0.03)], INK)
    for at, name in (((0, 0), "0"), ((1, 0), "1")):
        q.text(at, name, INK, SMALL, offset=(0, -24))
    q.text((0, 1), "1", INK, SMALL, offset=(-16, 0))
    q.text((0.72, 0.78), "window", BLUE, anchor="start", offset=(6, 0))
    q.text((0.2, 0.27), "fade", RED, offset=(-4, 0))
