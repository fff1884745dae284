"""Diagrams of chapter 08's lessons: python3 docs/figures/draw.py draws them."""

from drawing import (BLUE, FAINT, GREEN, GREY, INK, ORANGE, PALE_BLUE, PALE_GREEN, PALE_GREY, PALE_ORANGE, RED, SMALL, THIN,
                     Drawing, figure)


@figure("08_apron", 900, 290,
        "A line of texels. A workgroup's own texels lie in the middle, and as many as the radius on each side are its apron. "
        "Each thread reads some of them once; after the barrier it sums a stretch around its own")
def draw_apron(drawing: Drawing):
    p = drawing.panel((50, 130), 40)
    for i in range(20):
        own = 5 <= i < 15
        p.box((i, 0), (i + 1, 1), INK, THIN, fill=PALE_BLUE if own else PALE_ORANGE)
    p.span((0, 1.6), (5, 1.6), "apron: radius", ORANGE)
    p.span((5, 1.6), (15, 1.6), "256 threads' own texels", BLUE)
    p.span((15, 1.6), (20, 1.6), "apron: radius", ORANGE)
    p.text((0.5, 0), "slot 0", INK, SMALL, offset=(4, -18))
    p.dot((8.5, 0.5), GREEN)
    p.arrow((8.5, -1.3), (8.5, 0.3), GREEN, width=2)
    p.line([(3.5, -1.3), (13.5, -1.3)], GREEN, 4)
    p.text((8.5, -2.2), "thread t sums slots t to t + 2 radius", GREEN)


def grid(p, size: int):
    """Texels of the image that is read, in a square around the origin."""
    half = size / 2
    for i in range(size + 1):
        p.line([(-half, i - half), (half, i - half)], FAINT, THIN)
        p.line([(i - half, -half), (i - half, half)], FAINT, THIN)


def reads(p, points, color, label: str = "", offset=(0, 0)):
    for x, y in points:
        p.dot((x, y), color)
    if label:
        p.text(points[-1], label, color, SMALL, offset=offset)


def around(d: float) -> list[tuple[float, float]]:
    return [(-d, -d), (d, -d), (-d, d), (d, d)]


@figure("08_kernels", 900, 380,
        "Left, three passes of Kawase's filter: each reads four points, one texel farther out in each pass. Middle, the dual "
        "filter on the way down: the middle and four corners of the new texel. Right, on the way up: eight points on a "
        "diamond around the new texel")
def draw_kernels(drawing: Drawing):
    p = drawing.panel((160, 215), 34)
    grid(p, 7)
    p.box((-0.5, -0.5), (0.5, 0.5), INK, THIN, fill=PALE_BLUE)
    reads(p, around(0.5), ORANGE, "0", (12, 12))
    reads(p, around(1.5), GREEN, "1", (12, 12))
    reads(p, around(2.5), RED, "2", (12, 12))
    p.text((0, -3.5), "Kawase: passes 0, 1, 2\neach read 1/4", INK, SMALL, offset=(0, -34))

    p = drawing.panel((455, 215), 60)
    grid(p, 4)
    p.box((-1, -1), (1, 1), INK, THIN, fill=PALE_BLUE)
    grid(p, 2)
    reads(p, [(0, 0)], ORANGE, "1/2", (24, 14))
    reads(p, around(1), GREEN, "1/8", (24, 14))
    p.text((0, -2), "dual filter, down\nfive reads", INK, SMALL, offset=(0, -34))

    p = drawing.panel((750, 215), 60)
    grid(p, 4)
    p.box((0, 0), (0.5, 0.5), INK, THIN, fill=PALE_BLUE)
    middle = (0.25, 0.25)
    reads(p, [(middle[0] + x, middle[1] + y) for x, y in ((-1, 0), (0, -1), (0, 1), (1, 0))], ORANGE, "1/12", (28, 14))
    reads(p, [(middle[0] + x, middle[1] + y) for x, y in around(0.5)], GREEN, "1/6", (22, 14))
    p.text((0, -2), "dual filter, up\neight reads", INK, SMALL, offset=(0, -34))
    p.text((0, 2), "texels: the image that is read", GREY, SMALL, offset=(-345, 24), rim=False)
    p.text((0, 2), "blue: the texel that is written", BLUE, SMALL, offset=(-60, 24), rim=False)


def knee(luminance: float, threshold: float, w: float) -> float:
    above = luminance - threshold
    return above if above >= w else 0 if above <= -w else (above + w) ** 2 / (4 * w)


@figure("08_knee", 900, 400,
        "What passes a threshold t: a hard one lets all pass from one luminance on, with a step; a soft one begins at t - w "
        "with a parabola and goes on as a straight line from t + w")
def draw_knee(drawing: Drawing):
    p = drawing.panel((70, 70), 140)
    q = drawing.panel((500, 70), 140)
    for panel in (p, q):
        panel.arrow((0, 0), (2.5, 0), INK, "luminance", offset=(-40, -26))
        panel.arrow((0, 0), (0, 2.15), INK)
        panel.line([(0, 0), (2.1, 2.1)], FAINT, THIN, dash=True)
        panel.text((1, 0), "*t*", INK, offset=(0, -24))
    p.line([(0, 0), (1, 0)], RED, 5)
    p.line([(1, 1), (2.1, 2.1)], RED, 5)
    p.line([(1, 0), (1, 1)], RED, THIN, dash=True)
    p.text((1, 0.5), "a step: it pops", RED, anchor="start", offset=(10, 0))
    p.text((0.9, 2.0), "hard", RED)
    q.curve(lambda x: (x, knee(x, 1, 0.5)), 0, 2.4, BLUE, 5)
    for x in (0.5, 1.5):
        q.line([(x, 0), (x, knee(x, 1, 0.5))], GREY, THIN, dash=True)
    q.text((0.5, 0), "t - w", GREY, SMALL, offset=(0, -24))
    q.text((1.5, 0), "t + w", GREY, SMALL, offset=(4, -24))
    q.text((0.9, 2.0), "soft", BLUE)


@figure("08_pyramid", 900, 430,
        "Left, a picture is halved three times by 13 reads a texel. At the bottom the variance that is missing is added by a "
        "small Gaussian. Right, tents of four reads bring it up again; for a sum of Gaussians each level's own light is added "
        "on the way")
def draw_pyramid(drawing: Drawing):
    p = drawing.panel((30, 4), 30)
    widths, tops = (8, 4, 2, 1), (10.6, 6.4, 3.6, 1.8)
    for i, (width, top) in enumerate(zip(widths, tops)):
        high = 0.36 * width + 0.3
        p.box((5 - width / 2, top), (5 + width / 2, top + high), INK, 2, fill=PALE_GREY if i == 0 else PALE_BLUE)
        p.box((22 - width / 2, top), (22 + width / 2, top + high), INK, 2, fill=PALE_ORANGE if i == 0 else PALE_GREEN)
        if i:
            above = tops[i - 1]
            p.arrow((5, above - 0.1), (5, top + high + 0.15), BLUE)
            p.arrow((22, top + high + 0.1), (22, above - 0.15), GREEN)
            if i < 3:
                p.arrow((5 + width / 2 + 0.3, top + high / 2), (22 - width / 2 - 0.3, top + high / 2), ORANGE, width=2, dash=True)
    p.text((5, 12.1), "cut out", INK, rim=False)
    p.text((22, 12.1), "spread", INK, rim=False)
    p.text((5, 9.4), "13 reads", BLUE, anchor="start", offset=(14, 8))
    p.text((22, 9.4), "4 reads", GREEN, anchor="start", offset=(14, 8))
    p.text((13.5, 7.3), "its own light, for a sum", ORANGE, SMALL, offset=(0, 18))
    p.arrow((5.9, 2.1), (21.1, 2.1), INK)
    p.text((13.5, 2.1), "a small Gaussian: what is missing", INK, offset=(0, -20))
