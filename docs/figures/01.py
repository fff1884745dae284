"""Diagrams of chapter 01's lessons: python3 docs/figures/draw.py draws them."""

from drawing import (BLUE, FAINT, GREEN, GREY, INK, ORANGE, PALE_BLUE, PALE_GREEN, PALE_ORANGE, PALE_RED, PURPLE, RED, SMALL,
                     THICK, THIN, Drawing, between, figure)

RIGHT, UP, ALONG = (0.5, -0.3), (0.0, 0.85), (0.97, 0.12)  # on paper


@figure("01_camera", 900, 420,
        "A camera at c with its axes r to the right, u up and d along the view, and its frustum, a pyramid without its tip")
def draw_camera(drawing: Drawing):
    p = drawing.panel((110, 140), 118)

    def at(x, y, s):
        return x * RIGHT[0] + y * UP[0] + s * ALONG[0], x * RIGHT[1] + y * UP[1] + s * ALONG[1]

    def rectangle(s):
        half = 0.2 * s
        return [at(x * 1.5 * half, y * half, s) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]

    near, far = rectangle(1.25), rectangle(5.2)
    p.line(far, GREY, THIN, closed=True, fill=PALE_GREEN)
    for a, b in zip(near, far):
        p.line([at(0, 0, 0), a], FAINT, THIN, dash=True)
        p.line([a, b], GREY, THIN)
    p.line(near, BLUE, THIN, closed=True, fill=PALE_BLUE)
    p.text(at(0, -0.72, 1.3), "near plane, *s* = *n*", BLUE, SMALL, offset=(70, -40))
    p.text(at(0.1, 0.1, 5.2), "far plane, *s* = *F*", GREEN, SMALL, rim=False)
    p.arrow(at(0, 0, 0), at(1, 0, 0), RED, "*r*, *x*", offset=(20, -12))
    p.arrow(at(0, 0, 0), at(0, 1.1, 0), GREEN, "*u*, *y*", offset=(0, 16))
    p.arrow(at(0, 0, 0), at(0, 0, 2.4), INK)
    p.text(at(0, 0, 2.4), "*d*, −*z*", INK, offset=(4, 40))
    p.dot(at(0, 0, 0), INK, "*c*", offset=(-20, 0))


NEAR, FAR_M = 1.0, 8.0  # metres


def small_floats() -> list[float]:
    """The numbers from 2^-8 to 1 that have three bits behind the leading one."""
    return sorted({(8 + m) / 8 * 2.0 ** -e for e in range(1, 9) for m in range(8)} | {1.0})


def distance(depth: float, reverse: bool) -> float:
    """The distance that has this depth."""
    share = depth if reverse else 1 - depth
    return 1 / (share * (1 / NEAR - 1 / FAR_M) + 1 / FAR_M)


@figure("01_depth_floats", 900, 330,
        "Depths that a float can hold, as distances from the camera: with forward depth they crowd at the near plane, with "
        "reverse depth they are spread evenly")
def draw_depth_floats(drawing: Drawing):
    p = drawing.panel((20, 0), 100)
    p.eye((0.34, 2.05), 0, 46)
    for y, reverse, color, name in ((2.5, False, RED, "0 near, 1 far"), (1.15, True, GREEN, "1 near, 0 far")):
        p.line([(NEAR, y), (FAR_M, y)], GREY, THIN)
        for depth in small_floats():
            x = distance(depth, reverse)
            p.line([(x, y - 0.18), (x, y + 0.18)], color, 2)
        p.text((NEAR, y + 0.42), name, color, anchor="start", offset=(10, 0))
    for x, name in ((NEAR, "near plane"), (FAR_M, "far plane")):
        p.line([(x, 0.7), (x, 3.0)], GREY, THIN, dash=True)
        p.text((x, 0.48), name, GREY, SMALL)
    p.text((4.5, 0.48), "distance from the camera →", GREY, SMALL)


ARROWHEAD = [(-2, -1), (0, 0), (2, -1), (0, 2)]


def corners(p):
    p.line(ARROWHEAD, INK, THICK, closed=True)
    for i, (point, offset) in enumerate(zip(ARROWHEAD, ((-16, -12), (0, -20), (16, -12), (0, 18)))):
        p.dot(point, label=str(i), offset=offset)


@figure("01_ears", 900, 360,
        "An arrowhead of four corners: a fan from corner 0 covers the dent; cut off at the ear 1 2 3, which leaves the "
        "triangle 0 1 3, it is covered once")
def draw_ears(drawing: Drawing):
    left, right = drawing.panel((225, 165), 78), drawing.panel((675, 165), 78)
    left.line([ARROWHEAD[0], ARROWHEAD[2], ARROWHEAD[3]], None, fill=PALE_BLUE)
    left.line([ARROWHEAD[0], ARROWHEAD[1], ARROWHEAD[2]], RED, THIN, closed=True, fill=PALE_RED, dash=True)
    corners(left)
    left.text((0, -0.62), "0 1 2: area −2", RED, SMALL, rim=False)
    left.text((0, 0.85), "0 2 3:\narea 6", INK, SMALL, rim=False)
    left.text((0, -1.75), "fan: the dent is filled", RED)
    right.line([ARROWHEAD[1], ARROWHEAD[2], ARROWHEAD[3]], None, fill=PALE_GREEN)
    right.line([ARROWHEAD[0], ARROWHEAD[1], ARROWHEAD[3]], None, fill=PALE_BLUE)
    right.line([ARROWHEAD[1], ARROWHEAD[3]], GREEN, THICK, dash=True)
    corners(right)
    right.text((0.62, 0.2), "ear", GREEN, SMALL, rim=False)
    right.text((-0.62, 0.2), "rest", GREY, SMALL, rim=False)
    right.text((0, -1.75), "ears: 1 2 3, then 0 1 3", GREEN)


EYE_AT, SCREEN = (0.0, 0.0), 1.0
A, B = (1.0, -1.0), (3.0, -1.0)  # a floor from the distance 1 to the distance 3


@figure("01_interpolation", 900, 330,
        "A floor from the distance 1 to 3: the middle between the two ends on the screen is a quarter of the way along the "
        "floor")
def draw_interpolation(drawing: Drawing):
    p = drawing.panel((90, 270), 205)
    p.eye((0.0, 0.0), 0, 40)
    seen = [(SCREEN, SCREEN * y / x) for x, y in (A, B)]
    p.line([(SCREEN, 0.12), (SCREEN, -1.12)], BLUE, THIN)
    p.text((SCREEN, 0.12), "screen", BLUE, SMALL, offset=(44, 0))
    p.line([A, B], INK, 5)
    for i in range(5):
        share = i / 4
        on_screen = between(seen[0], seen[1], share)
        far = -1 / on_screen[1]
        end = (far, -1.0)
        p.line([(0, 0), end], RED if i == 2 else GREY, 2 if i == 2 else 1.2, dash=i != 2)
        p.dot(on_screen, BLUE, radius_px=4.5)
        p.dot(end, RED if i == 2 else INK, radius_px=5)
        q = (far - A[0]) / (B[0] - A[0])
        label = {0: "*q* = 0, *s* = 1", 2: "*q* = ¼", 4: "*q* = 1, *s* = 3"}.get(i)
        if label:
            p.text(end, label, RED if i == 2 else INK, SMALL, offset=(-62 if i == 0 else 0, -24))
        assert i != 2 or abs(q - 0.25) < 1e-9
    p.text((2.55, -0.35), "equal steps on the screen,\nunequal steps on the floor", GREY, SMALL)


FOCAL, FAR_PLANE = 1.73, 5.2
TREE = 1.42


@figure("01_similar", 900, 390,
        "Two similar triangles with their tip at the camera: the screen stands at the distance f, from -1 to 1; a point at "
        "the height y and the distance s is seen at f y / s")
def draw_similar(drawing: Drawing):
    p = drawing.panel((90, 195), 118)
    p.line([(0, 0), (6.3, 0)], GREY, THIN)
    for side in (-1, 1):
        p.line([(0, 0), (2.15, side * 2.15 / FOCAL)], GREY, THIN, dash=True)
    p.line([(FOCAL, -1), (FOCAL, 1)], BLUE, 5)
    for y, name in ((1, "1"), (-1, "−1")):
        p.text((FOCAL, y), name, BLUE, SMALL, offset=(-16, 10 * y))
    p.text((FOCAL, -1.0), "screen", BLUE, SMALL, offset=(42, 2))
    p.line([(FAR_PLANE, 0), (FAR_PLANE, TREE)], INK, 5)
    p.text((FAR_PLANE, TREE / 2), "*y*", INK, offset=(20, 0))
    p.line([(0, 0), (FAR_PLANE, TREE)], RED, 2)
    p.line([(FOCAL, 0), (FOCAL, FOCAL * TREE / FAR_PLANE)], RED, 7)
    p.text((FOCAL, 0.27), "*f* *y* / *s*", RED, offset=(52, -4))
    p.eye((0, 0), 0, 40)
    p.span((0, -0.34), (FOCAL, -0.34), "")
    p.text((FOCAL / 2, -0.34), "*f*", GREY, offset=(0, -18))
    p.span((0, -1.35), (FAR_PLANE, -1.35), "*s* = −*z*", offset=(0, -34))
    p.arc((0, 0), 0.62, -30, 30, "", PURPLE)
    p.text((0.62, 0), "*φ*", PURPLE, offset=(18, 16))


@figure("01_two_roundings", 900, 330,
        "Floats, doubles between them and a decimal number just above the midpoint of two floats: rounded to the double at "
        "the midpoint first, it ends at the lower float instead of the upper one")
def draw_two_roundings(drawing: Drawing):
    p = drawing.panel((90, 110), 1)
    p.line([(-40, 0), (760, 0)], GREY, THIN)
    for x in range(0, 721, 45):
        p.line([(x, -9), (x, 9)], GREY, THIN)
    for x, name in ((0, "1"), (720, "1 + 2^{−23}")):
        p.line([(x, -26), (x, 26)])
        p.text((x, -46), name)
    p.line([(360, -20), (360, 20)], BLUE)
    p.text((360, -46), "the midpoint, a double", BLUE, SMALL)
    p.text((360, -86), "long marks: floats; short marks: doubles, 16 drawn of 2^{29}", GREY, SMALL)
    p.dot((374, 0), RED)
    p.arrow((450, 66), (379, 7), RED, width=THIN)
    p.text((456, 76), "decimal", RED, SMALL, anchor="start")
    p.curve(lambda t: (374 + 346 * t, 8 + 4 * 125 * t * (1 - t)), 0.02, 0.995, GREEN, arrow=True)
    p.text((547, 170), "once: the nearest float", GREEN)
    p.curve(lambda t: (358 - 356 * t, 20 + 4 * 110 * t * (1 - t)), 0.0, 0.995, RED, dash=True, arrow=True)
    p.text((180, 170), "twice: a tie, to even", RED)


# Two faces that share an edge along which the normal breaks: the second corner of each is the same triple in neither.
CORNERS = ["1/1/1", "2/2/1", "3/3/1", "3/3/1", "2/2/1", "4/4/1", "4/4/2", "2/2/2", "5/5/2"]


@figure("01_weld", 900, 380,
        "Corners of three faces, each an index triple, and the vertices they become: equal triples share a vertex, triples "
        "that differ in the normal alone do not")
def draw_weld(drawing: Drawing):
    p = drawing.panel()
    vertices = list(dict.fromkeys(CORNERS))
    where = {triple: 62 + 118 * i for i, triple in enumerate(vertices)}
    p.text((30, 350), "file: corners  v/vt/vn", anchor="start", bold=True)
    p.text((30, 26), "GPU: vertices, and indices to them", anchor="start", bold=True)
    for i, triple in enumerate(CORNERS):
        face = i // 3
        x = 95 + 84 * i + 22 * face
        color, fill = ((BLUE, PALE_BLUE), (GREEN, PALE_GREEN), (ORANGE, PALE_ORANGE))[face]
        p.arrow((x, 262), (where[triple] + 51, 142), color, width=THIN)
        p.box((x - 40, 262), (x + 40, 300), color, THIN, fill=fill, label=triple)
        if i % 3 == 1:
            p.text((x, 320), f"face {face + 1}", color, SMALL)
    for i, triple in enumerate(vertices):
        left = where[triple]
        p.box((left, 100), (left + 102, 142), width=THIN, fill="#ffffff", label=triple)
        p.text((left + 51, 72), f"vertex {i}", GREY, SMALL)
