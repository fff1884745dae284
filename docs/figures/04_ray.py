"""A ray against a height field: the hits of offset, steep, occlusion and relief, and the true one.

python3 docs/figures/04_ray.py writes docs/images/04_ray.svg.
"""

from math import cos

from drawing import BLUE, EYE, FAINT, GREEN, GREY, INK, ORANGE, PALE_GREY, RED, SMALL, THIN, Drawing

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


def draw() -> Drawing:
    drawing = Drawing(900, 550, "A ray enters a height field. Offset uses the depth at the entry; steep takes the first of five "
                                "layers that is below; occlusion intersects that step with a straight line; relief halves it")
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
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
