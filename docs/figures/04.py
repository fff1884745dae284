"""Diagrams of chapter 04's lessons: python3 docs/figures/draw.py draws them."""

from math import atan2, cos, hypot, pi, radians, sin, sqrt, tan
from pathlib import Path
from struct import unpack

from drawing import (BLUE, EYE, FAINT, GREEN, GREY, HALF, INK, LIGHT, MIRROR, NORMAL, ORANGE, PALE_BLUE, PALE_GREY, PURPLE, RED,
                     SMALL, SURFACE, THIN, Drawing, between, figure, polar)

ELLIPSOID_ALPHA, SLANT = 0.45, 58  # of the ball's height; of the camera, in degrees from the normal


@figure("04_ellipsoid", 900, 290,
        "Left: a half ball and the same with its heights multiplied by alpha; a normal of the flattened one leans less. "
        "Right: the part of the flattened ball that a slanted camera sees")
def draw_ellipsoid(drawing: Drawing):
    p, q = drawing.panel((230, 40), 175), drawing.panel((670, 40), 175)
    p.curve(lambda a: polar(1, a), 0, 180, FAINT)
    for panel in (p, q):
        panel.ground(-1.15, 1.15)
        panel.curve(lambda a: (cos(radians(a)), ELLIPSOID_ALPHA * sin(radians(a))), 0, 180, INK)
    angle = 50
    ball, flat = polar(1, angle), (cos(radians(angle)), ELLIPSOID_ALPHA * sin(radians(angle)))
    p.line([ball, flat], GREY, THIN, dash=True)
    p.arrow(ball, polar(1.32, angle), GREY)
    steep = sqrt((ELLIPSOID_ALPHA * cos(radians(angle))) ** 2 + sin(radians(angle)) ** 2)
    p.arrow(flat, (flat[0] + 0.42 * ELLIPSOID_ALPHA * cos(radians(angle)) / steep, flat[1] + 0.42 * sin(radians(angle)) / steep), NORMAL)
    p.text((-0.62, 1.06), "half ball: *α* = 1", GREY, SMALL)
    p.text((-0.05, 0.18), "heights times *α*", INK, SMALL)
    # The grazing ray of the camera.
    along = (sin(radians(SLANT)), cos(radians(SLANT)))
    graze = sqrt(cos(radians(SLANT)) ** 2 + (ELLIPSOID_ALPHA * sin(radians(SLANT))) ** 2)
    touch = (-cos(radians(SLANT)) / graze, ELLIPSOID_ALPHA * ELLIPSOID_ALPHA * sin(radians(SLANT)) / graze)
    q.line([touch, (touch[0] + 0.95 * along[0], touch[1] + 0.95 * along[1])], EYE, THIN, dash=True)
    q.curve(lambda t: (cos(t), ELLIPSOID_ALPHA * sin(t)), 0.0, atan2(touch[1] / ELLIPSOID_ALPHA, touch[0]), PURPLE, 6)
    q.arrow((0.2, 0.42), (0.2 + 0.75 * along[0], 0.42 + 0.75 * along[1]), EYE, "*V*")
    q.text((-0.45, 0.78), "seen by the camera", PURPLE, SMALL)


ROUGHNESS, VIEW = 0.55, 50  # of the surface; of the camera, in degrees from the normal
LAMP = ((0.62, 0.95), (1.28, 0.48))


def table_at(column: float, row: float) -> list[float]:
    """Of assets/tables/ggx.pfm: the six numbers of the nearest texel."""
    data = (Path(__file__).parents[2] / "assets/tables/ggx.pfm").read_bytes().split(b"\n", 3)[3]

    def texel(x: int, y: int):
        return unpack("<3f", data[12 * (64 * (127 - y) + x):][:12])

    x, y = round(63 * column), round(63 * row)
    return [*texel(x, y), *texel(x, 64 + y)]


@figure("04_lamps", 900, 340,
        "Left: the lobe of a rough surface points towards the mirrored direction, and a lamp covers part of it. Right: a "
        "linear map turns the lobe into the cosine lobe, and the lamp into another lamp")
def draw_lamps(drawing: Drawing):
    n_dot_v = cos(radians(VIEW))
    m11, m13, m31, m33, a, b = table_at(1 - sqrt(1 - n_dot_v), ROUGHNESS)
    alpha = ROUGHNESS * ROUGHNESS

    def ggx(angle: float) -> float:
        """Times n·l, in the plane of the normal and the camera, which is on the left."""
        lx, lz, vx, vz = cos(radians(angle)), sin(radians(angle)), -sin(radians(VIEW)), n_dot_v
        hz = (lz + vz) / sqrt((lx + vx) ** 2 + (lz + vz) ** 2)
        d = hz * hz * (alpha * alpha - 1) + 1
        seen = 0.5 / (vz * sqrt(lz * lz * (1 - alpha ** 2) + alpha ** 2) + lz * sqrt(vz * vz * (1 - alpha ** 2) + alpha ** 2))
        return lz * seen * alpha ** 2 / (pi * d * d)

    def mapped(point):
        x, z = -point[0], point[1]  # the table has the camera on the side of +x
        return -(m11 * x + m13 * z), m31 * x + m33 * z

    most = max(ggx(angle) for angle in range(1, 180))
    p, q = drawing.panel((230, 75), 190), drawing.panel((670, 75), 190)
    for panel, says in ((p, "the surface's lobe, GGX times *N*·*L*"), (q, "after the map: the cosine lobe")):
        panel.ground(-0.95, 0.95)
        panel.arrow((0, 0), (0, 1.08), NORMAL, "*N*")
        panel.text((0, -0.24), says, INK, SMALL)
    p.arrow((0, 0), polar(0.95, 90 + VIEW), EYE, "*V*")
    p.curve(lambda angle: polar(ggx(angle) / most, angle), 0.5, 179.5, MIRROR)
    q.curve(lambda angle: polar(sin(radians(angle)), angle), 0, 180, MIRROR)
    shrink = 1.02 / max(sqrt(x * x + y * y) for x, y in map(mapped, LAMP))
    for panel, ends in ((p, LAMP), (q, [(shrink * x, shrink * y) for x, y in map(mapped, LAMP)])):
        for end in ends:
            panel.line([(0, 0), end], GREY, THIN, dash=True)
        panel.line(ends, LIGHT, 5)
    p.text((1.02, 0.86), "lamp", LIGHT, anchor="start")


ALPHA = 0.2
EXPONENT = 2 / ALPHA ** 2 - 2


def density(cosine: float, alpha: float) -> float:
    return alpha ** 2 / (pi * (cosine * cosine * (alpha * alpha - 1) + 1) ** 2)


def visibility(light: float, view: float, alpha: float) -> float:
    a2 = alpha * alpha
    return 0.5 / (view * sqrt(light * light * (1 - a2) + a2) + light * sqrt(view * view * (1 - a2) + a2))


def kept(view: float, alpha: float, steps: int = 220) -> float:
    """Share of white light that a mirror-like surface sends to the camera: the integral over half vectors, F = 1."""
    v, total = (sqrt(1 - view * view), 0.0, view), 0.0
    for i in range(steps):
        x = (i + 0.5) / steps
        c = sqrt((1 - x) / (1 + (alpha * alpha - 1) * x))
        s = sqrt(max(1 - c * c, 0.0))
        for k in range(steps):
            turn = pi * (k + 0.5) / steps  # the other half is its mirror image
            h = (s * cos(turn), s * sin(turn), c)
            along = v[0] * h[0] + v[2] * h[2]
            light = 2 * along * h[2] - v[2]
            if along > 0 and light > 0:
                total += 4 * visibility(light, view, alpha) * light * along / c
    return total / steps ** 2


@figure("04_lobes", 900, 360,
        "The density of microfacets over the angle to the normal, relative to its peak: GGX has a narrower peak and a longer "
        "tail than Blinn and Phong's lobe of the matching exponent")
def draw_lobes(drawing: Drawing):
    p = drawing.panel((110, 70), 1)
    wide, high = 720, 240
    for degrees in range(0, 61, 15):
        x = wide * degrees / 60
        p.line([(x, 0), (x, high)], FAINT, THIN)
        p.text((x, -24), f"{degrees}°", GREY, SMALL)
    for share in (0, 0.5, 1):
        p.line([(0, high * share), (wide, high * share)], FAINT, THIN)
        p.text((-14, high * share), f"{share:g}", GREY, SMALL, anchor="end")
    p.curve(lambda a: (wide * a / 60, high * density(cos(radians(a)), ALPHA) / density(1, ALPHA)), 0, 60, BLUE)
    p.curve(lambda a: (wide * a / 60, high * cos(radians(a)) ** EXPONENT), 0, 60, RED)
    p.text((260, 96), "GGX, *α* = 0.2: a long tail", BLUE, SMALL, anchor="start")
    p.text((290, 152), f"Blinn and Phong, *n* = 2/*α*² − 2 = {EXPONENT:.0f}", RED, SMALL, anchor="start")
    p.text((wide / 2, -52), "angle between *N* and *H*", INK, SMALL)


PROFILE = [(-2.7, 0.25), (-2.35, 0.1), (-1.95, 0.3), (-1.5, 0.03), (-1.05, 0.66), (-0.6, 0.02), (-0.25, 0.22), (0.25, 0.32), (0.6, 0.02),
           (1.05, 0.66), (1.5, 0.03), (1.95, 0.3), (2.35, 0.1), (2.7, 0.25)]
TO_LIGHT, TO_EYE = 128, 52
FACET = (0.0, 0.27)


@figure("04_microfacets", 900, 400,
        "Microfacets: the mirror whose normal is the half vector sends the light to the camera; neighbours hide other mirrors "
        "from the light or from the camera")
def draw_microfacets(drawing: Drawing):
    p = drawing.panel((450, 60), 155)
    p.line([*PROFILE, (2.7, -0.25), (-2.7, -0.25)], None, fill=SURFACE)
    p.line(PROFILE, INK)
    p.line(PROFILE[6:8], HALF, 7)
    p.arrow(FACET, (0, 1.75), NORMAL, "*N*")
    p.arrow(polar(1.75, TO_LIGHT, FACET), FACET, LIGHT)
    p.text(polar(1.75, TO_LIGHT, FACET), "light, *L*", LIGHT, SMALL, offset=(-48, 4))
    p.arrow(FACET, polar(1.75, TO_EYE, FACET), EYE)
    p.text(polar(1.75, TO_EYE, FACET), "camera, *V*", EYE, SMALL, offset=(62, 4))
    p.arrow(FACET, polar(1.15, 101, FACET), HALF, "*H*", offset=(-14, 6))
    # The light is on the left, so the right side of a steep peak is dark; the camera is on the right.
    for side, color, name in ((1, LIGHT, "hidden from the light:\n*shadowing*"), (-1, EYE, "hidden from the camera:\n*masking*")):
        p.line([(side * 1.05, 0.66), (side * 1.5, 0.03)], PALE_BLUE, 8)
        p.line([(side * 1.05, 0.66), (side * 1.5, 0.03)], GREY, THIN)
        p.line([(side * 1.28, 0.4), (side * 1.28 - side * 0.62, 0.4 + 0.79)], color, THIN, dash=True)
        p.text((side * 1.75, 0.98), name, GREY, SMALL)


CASES = (("smooth", (90, 86, 94, 90)), ("rough", (128, 60, 118, 50)))  # directions of the texels' normals, in degrees


def mean(angles):
    return (sum(cos(radians(a)) for a in angles) / len(angles), sum(sin(radians(a)) for a in angles) / len(angles))


@figure("04_mip_normals", 900, 400,
        "Four texels with nearly equal normals have a mean of length 1; four texels whose normals scatter have a mean that is "
        "clearly shorter than the unit circle")
def draw_mip_normals(drawing: Drawing):
    for i, (name, angles) in enumerate(CASES):
        p = drawing.panel((450 * i, 0), 1)
        p.text((225, 372), name)
        profile = [(60.0, 225.0)]
        for angle in angles:  # a texel's piece of surface leans as its normal says
            x, y = profile[-1]
            profile.append((x + 82.5, y - 82.5 / tan(radians(angle))))
        for (a, b), angle in zip(zip(profile, profile[1:]), angles):
            p.arrow(between(a, b), polar(70, angle, between(a, b)), NORMAL)
        p.line(profile, INK)
        for point in profile:
            p.dot(point, INK, radius_px=4)
        center = (225.0, 55.0)
        p.arrow((225, 198), (225, 176), GREY, width=THIN)
        p.text((240, 189), "mean", GREY, SMALL, anchor="start")
        p.curve(lambda angle, c=center: polar(108, angle, c), 15, 165, GREY, THIN, dash=True)
        p.text(polar(108, 15, center), "length 1", GREY, SMALL, anchor="start", offset=(8, 4))
        x, y = mean(angles)
        tip = (center[0] + 108 * x, center[1] + 108 * y)
        p.arrow(center, tip, BLUE)
        p.text(between(center, tip, 0.3), f"ℓ = {hypot(x, y):.2f}", BLUE, anchor="start", offset=(10, 0))
        p.line([(150, 55), (300, 55)], INK)


ENTRY, SHIFT, LAYERS = 3.02, 2.55, 5  # of the ray: where it enters, how far it goes down to depth 1; of the search
DEEP = 1.45  # depth is drawn so much larger


def depth_at(x: float) -> float:
    return 0.5 + 0.3 * cos(2.25 * x + 0.9) + 0.13 * cos(5.1 * x + 2.4)


def ray(t: float):
    return ENTRY - t * SHIFT, -DEEP * t


def surface(x: float):
    return x, -DEEP * depth_at(x)


def exact() -> float:
    return next(i / 100000 for i in range(100001) if i / 100000 >= depth_at(ENTRY - i / 100000 * SHIFT))


def first_layer_below() -> float:
    return next(i / LAYERS for i in range(LAYERS + 1) if i == LAYERS or i / LAYERS >= depth_at(ray(i / LAYERS)[0]))


def field(drawing, origin, title: str):
    p = drawing.panel(origin, 118)
    p.line([(0, -1.1 * DEEP)] + [surface(0.02 * i) for i in range(171)] + [(3.4, -1.1 * DEEP)], None, fill=PALE_GREY)
    p.curve(surface, 0, 3.4, INK)
    p.line([(0, 0), (3.4, 0)], GREY, THIN, dash=True)
    p.line([ray(-0.13), ray(1)], EYE, THIN)
    p.arrow(ray(-0.13), ray(-0.02), EYE, width=THIN)
    p.text((0, 0.2), title, INK, anchor="start")
    return p


def hits(p, found: float):
    p.dot(ray(exact()), GREEN, radius_px=7)
    p.dot(ray(found), RED, radius_px=7)


@figure("04_ray", 900, 550,
        "A ray enters a height field. Offset uses the depth at the entry; steep takes the first of five layers that is below; "
        "occlusion intersects that step with a straight line; relief halves it")
def draw_ray(drawing: Drawing):
    p = field(drawing, (30, 475), "offset: one read")
    d = depth_at(ENTRY)
    p.line([(ENTRY, 0), surface(ENTRY)], RED, THIN, dash=True)
    p.line([surface(ENTRY), ray(d)], RED, THIN, dash=True)
    hits(p, d)
    below, above = first_layer_below(), first_layer_below() - 1 / LAYERS
    p = field(drawing, (470, 475), "steep: layers")
    for i in range(LAYERS + 1):
        p.line([(0, -DEEP * i / LAYERS), (3.4, -DEEP * i / LAYERS)], FAINT, THIN)
        if i / LAYERS <= below:
            p.dot(ray(i / LAYERS), ORANGE, radius_px=4.5)
    hits(p, below)
    p = field(drawing, (30, 225), "occlusion: a straight line")
    x0, x1 = ray(above)[0], ray(below)[0]
    gap, overlap = depth_at(x0) - above, depth_at(x1) - below
    found = above + (below - above) * gap / (gap - overlap)
    p.line([surface(x0), surface(x1)], RED)
    for t in (above, below):
        p.line([ray(t), surface(ray(t)[0])], ORANGE, THIN, dash=True)
        p.dot(ray(t), ORANGE, radius_px=4.5)
    hits(p, found)
    p = field(drawing, (470, 225), "relief: halvings")
    low, high = above, below
    for t in (above, below):
        p.dot(ray(t), ORANGE, radius_px=4.5)
    for _ in range(4):
        middle = (low + high) / 2
        p.dot(ray(middle), ORANGE, radius_px=4.5)
        low, high = (low, middle) if middle >= depth_at(ray(middle)[0]) else (middle, high)
    hits(p, high)
    key = drawing.panel()
    for x, color, name in ((45, GREEN, "the hit"), (180, RED, "estimated by the method"), (500, ORANGE, "sampled positions"),
                           (740, BLUE, "camera ray")):
        key.dot((x, 24), color, radius_px=7)
        key.text((x + 16, 24), name, INK, SMALL, anchor="start")


A, B, C = (0.18, 0.2), (0.88, 0.34), (0.34, 0.86)  # the corners' u and v
T, BITANGENT, AT = (250.0, 70.0), (-95.0, 190.0), (95.0, 60.0)  # dP/du, dP/dv and the corner a, on the page


def world(uv):
    u, v = uv[0] - A[0], uv[1] - A[1]
    return AT[0] + u * T[0] + v * BITANGENT[0], AT[1] + u * T[1] + v * BITANGENT[1]


@figure("04_tangent_frame", 900, 400,
        "Left: a triangle on a texture, with axes u and v. Right: the same triangle in the world with its edges e1 and e2, "
        "the tangent T along which u grows, the bitangent B along which v grows, and the normal N")
def draw_tangent_frame(drawing: Drawing):
    p = drawing.panel((70, 55), 265)
    p.box((0, 0), (1, 1), GREY, THIN, fill="#ffffff")
    p.line([A, B, C], INK, closed=True, fill=PALE_BLUE)
    p.arrow((0, 0), (1.13, 0), RED, "u", offset=(16, 0))
    p.arrow((0, 0), (0, 1.13), BLUE, "v", offset=(0, 14))
    for corner, name, offset in ((A, "a", (-12, -12)), (B, "b", (16, 0)), (C, "c", (0, 18))):
        p.dot(corner, label=name, offset=offset)
    p.line([A, (B[0], A[1]), B], ORANGE, THIN, dash=True)
    p.text(((A[0] + B[0]) / 2, A[1]), "Δu_{1}", ORANGE, SMALL, offset=(0, -15))
    p.text((B[0], (A[1] + B[1]) / 2), "Δv_{1}", ORANGE, SMALL, anchor="start", offset=(36, -4))
    q = drawing.panel((466, 20), 1.28)
    a, b, c = world(A), world(B), world(C)
    q.line([world((-0.1, 0)), world((1.02, 0)), world((1.02, 1.02)), world((-0.1, 1.02))], None, fill=PALE_GREY)
    q.line([a, b, c], INK, closed=True, fill=PALE_BLUE)
    q.arrow(a, b, ORANGE, "*e*_{1}", at=0.62, offset=(-6, 18))
    q.arrow(a, c, ORANGE, "*e*_{2}", at=0.75, offset=(24, 6))
    q.arrow(a, (a[0] + 0.52 * T[0], a[1] + 0.52 * T[1]), RED, "*T*", offset=(10, -18))
    q.arrow(a, (a[0] + 0.55 * BITANGENT[0], a[1] + 0.55 * BITANGENT[1]), BLUE, "*B*", offset=(-18, 0))
    q.arrow(a, (a[0] + 34, a[1] + 158), NORMAL, "*N*", offset=(0, 16))
    for corner, name, offset in ((a, "a", (-8, -18)), (b, "b", (16, 0)), (c, "c", (-4, 18))):
        q.dot(corner, label=name, offset=offset)
    q.text(between(a, b, 0.5), "u grows along *T*, v along *B*", INK, SMALL, offset=(30, -95))


if __name__ == "__main__":
    for roughness in (0.2, 0.4, 0.6, 0.8, 1.0):
        print(f"roughness {roughness}: lost", ", ".join(f"{1 - kept(view, roughness ** 2):.1%} at n.v = {view}" for view in (1.0, 0.5, 0.2)))
    for degrees in (10, 20, 30):
        print(degrees, f"{density(cos(radians(degrees)), ALPHA) / density(1, ALPHA):.4f}", f"{cos(radians(degrees)) ** EXPONENT:.5f}")
