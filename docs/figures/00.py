"""Diagrams of chapter 00's lessons: python3 docs/figures/draw.py draws them."""

from drawing import (BLUE, FAINT, GREEN, GREY, INK, ORANGE, PALE_BLUE, PALE_GREEN, PALE_GREY, PALE_ORANGE, PALE_RED, PURPLE, RED,
                     SMALL, THIN, Drawing, figure, polar)


@figure("00_barrier", 900, 330,
        "Without a barrier the copy overlaps the drawing; with one it waits for the drawing's stage, whose cache is written "
        "back, and the image changes its layout in between")
def draw_barrier(drawing: Drawing):
    p = drawing.panel((150, 50), 1)
    for y, waits in ((190, False), (60, True)):
        p.box((0, y), (300, y + 44), BLUE, THIN, fill=PALE_BLUE, label="draw writes *picture*")
        left, low = (470, y) if waits else (160, y - 56)
        p.box((left, low), (left + 250, low + 44), ORANGE, THIN, fill=PALE_ORANGE, label="copy reads *picture*")
    p.text((-14, 212), "without", RED, SMALL, anchor="end")
    p.text((-14, 82), "barrier", INK, SMALL, anchor="end")
    p.box((160, 178), (300, 190), None, fill=PALE_RED)
    p.text((330, 212), "both at once: the copy may read old pixels", RED, SMALL, anchor="start")
    p.box((318, 52), (452, 112), RED, THIN, fill=PALE_RED, label="flush caches,\nnew layout", size=16)
    p.text((150, 26), "stage: color output\naccess: write", BLUE, 16)
    p.text((595, 26), "stage: copy\naccess: read", ORANGE, 16)
    p.arrow((0, -28), (730, -28), GREY, width=THIN)
    p.text((730, -28), "time on the GPU", GREY, SMALL, offset=(-60, 18))


@figure("00_depth", 1000, 330,
        "A camera looks through a column of pixels at a near box and a far wall; the image keeps the colour and the depth of "
        "what is nearer in each pixel")
def draw_depth(drawing: Drawing):
    p = drawing.panel((70, 60), 100)
    eye = (0, 1.1)
    p.eye(eye, 0, 40)
    p.box((3.2, 0.2), (3.9, 1.3), ORANGE, 2.2, fill=PALE_ORANGE)
    p.box((5.6, 0.0), (5.8, 2.4), GREEN, 2.2, fill=PALE_GREEN)
    p.text((3.55, -0.25), "box", ORANGE, SMALL)
    p.text((5.7, -0.25), "wall", GREEN, SMALL)
    p.text((1.3, -0.25), "pixels", GREY, SMALL)
    pixels = [0.85, 0.95, 1.05, 1.15, 1.25, 1.35]
    for y in pixels:
        p.box((1.2, y - 0.05), (1.4, y + 0.05), INK, THIN)
        slope = (y - eye[1]) / 1.3
        at = eye[1] + slope * 3.2
        near = 0.2 < at < 1.3
        end = 3.2 if near else 5.6
        p.line([(1.4, y), (end, eye[1] + slope * end)], ORANGE if near else GREEN, THIN)
        p.dot((end, eye[1] + slope * end), ORANGE if near else GREEN, radius_px=4)
        if near:
            p.line([(3.2, at), (5.6, eye[1] + slope * 5.6)], FAINT, THIN, dash=True)
    q = drawing.panel((700, 60), 100)
    for x, title in ((0, "colour"), (1.3, "depth")):
        q.text((x + 0.4, 2.35), title, INK, SMALL, bold=True)
        for y in pixels:
            near = 0.2 < eye[1] + (y - eye[1]) / 1.3 * 3.2 < 1.3
            low, high = 0.3 + 3 * (y - 0.85), 0.6 + 3 * (y - 0.85)
            if title == "colour":
                q.box((x, low), (x + 0.8, high), INK, THIN, fill=PALE_ORANGE if near else PALE_GREEN)
            else:
                q.box((x, low), (x + 0.8, high), width=THIN, label="3.2 m" if near else "5.6 m", ink=BLUE)
    q.text((1.05, -0.25), "what the two images keep", GREY, SMALL)


@figure("00_dispatch", 1010, 410,
        "A dispatch of four by three workgroups covers an image; one workgroup of eight by eight invocations, a subgroup of "
        "which runs in step; they write shared memory, wait at a barrier and read it")
def draw_dispatch(drawing: Drawing):
    p = drawing.panel()
    left, bottom, cell = 30, 110, 70
    for y in range(3):
        for x in range(4):
            p.box((left + x * cell, bottom + y * cell), (left + (x + 1) * cell, bottom + (y + 1) * cell), BLUE, THIN,
                  fill=PALE_ORANGE if (x, y) == (2, 1) else PALE_BLUE)
    p.text((left + 2 * cell, 365), "dispatch", INK, bold=True)
    p.text((left + 2 * cell, 70), "4 × 3 workgroups\ncover the image", GREY, SMALL)
    x, y, cell = 385, 110, 27
    for j in range(8):
        for i in range(8):
            p.box((x + i * cell, y + j * cell), (x + (i + 1) * cell, y + (j + 1) * cell), FAINT, 1,
                  fill=PALE_GREEN if j >= 4 else PALE_ORANGE)
    p.box((x, y), (x + 8 * cell, y + 8 * cell), ORANGE, 2.2)
    p.box((x, y + 4 * cell), (x + 8 * cell, y + 8 * cell), GREEN, 2.2)
    p.text((x + 4 * cell, 365), "workgroup", INK, bold=True)
    p.text((x + 4 * cell, y + 6 * cell), "a subgroup", GREEN, SMALL)
    p.text((x + 4 * cell, 70), "8 × 8 invocations:\none for each pixel", GREY, SMALL)
    p.line([(30 + 3 * 70, 110 + 2 * 70), (x, y + 8 * cell)], GREY, THIN, dash=True)
    p.line([(30 + 3 * 70, 110 + 70), (x, y)], GREY, THIN, dash=True)
    at = 735
    for i in range(6):
        p.arrow((at + 45 * i, 330), (at + 45 * i, 268), BLUE, width=2)
        p.arrow((at + 45 * i, 180), (at + 45 * i, 122), BLUE, width=2)
        p.box((at - 22 + 45 * i, 232), (at + 23 + 45 * i, 264), ORANGE, THIN, fill=PALE_ORANGE)
        p.line([(at + 45 * i, 228), (at + 45 * i, 212)], BLUE, 2)
    p.line([(at - 30, 205), (at + 255, 205)], RED, 5)
    p.text((at + 112, 365), "shared memory", INK, bold=True)
    p.text((at + 112, 70), "read what others wrote", GREY, SMALL)
    p.text((at - 36, 205), "barrier", RED, SMALL, anchor="end")


@figure("00_memory", 1000, 400,
        "The CPU records commands into a command buffer and submits it to a queue; the GPU executes it. Vertex buffers, "
        "uniforms, textures and render targets lie in the GPU's memory")
def draw_memory(drawing: Drawing):
    p = drawing.panel()

    def box(x, y, wide, high, text, fill, color=INK, size=SMALL):
        p.box((x, y), (x + wide, y + high), color, THIN, fill=fill, label=text, size=size)

    box(30, 240, 190, 110, "CPU\nyour C++", PALE_GREY, size=22)
    box(760, 240, 210, 110, "GPU\nyour shaders", PALE_GREEN, GREEN, 22)
    p.text((490, 375), "command buffer", INK)
    for i, text in enumerate(("bind pipeline", "draw", "barrier", "dispatch")):
        box(300 + 95 * i, 270, 95, 54, text.replace(" ", "\n"), PALE_BLUE, BLUE, 18)
    p.arrow((222, 297), (296, 297), INK)
    p.arrow((682, 297), (756, 297), INK)
    p.text((258, 330), "record", GREY, SMALL)
    p.text((718, 330), "submit", GREY, SMALL)
    p.box((300, 30), (970, 175), GREEN, THIN, dash=True)
    p.text((635, 200), "the GPU's memory", GREEN, SMALL)
    box(320, 60, 140, 80, "buffer:\nvertices", "#ffffff")
    box(480, 60, 140, 80, "buffer:\nuniforms", "#ffffff")
    box(640, 60, 140, 80, "image:\na texture", "#ffffff")
    box(800, 60, 150, 80, "image:\nthe target", PALE_ORANGE, ORANGE)
    box(30, 60, 190, 80, "staging buffer", "#ffffff")
    p.arrow((125, 236), (125, 144), INK)
    p.text((138, 190), "write", GREY, SMALL, anchor="start")
    p.arrow((222, 100), (316, 100), INK)
    p.text((262, 124), "copy", GREY, SMALL)
    p.arrow((865, 236), (865, 179), INK, both=True)


CORNERS = [(0.6, 0.7), (5.4, 1.6), (2.4, 5.3)]  # of the triangle, in pixels of a small screen
SCREEN = 6  # pixels of the screen


def inside(x: float, y: float) -> bool:
    (ax, ay), (bx, by), (cx, cy) = CORNERS
    edges = [((ax, ay), (bx, by)), ((bx, by), (cx, cy)), ((cx, cy), (ax, ay))]
    return all((q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0]) >= 0 for p, q in edges)


def screen(drawing, left: float, bottom: float, fill, triangle: bool, hidden=()):
    p = drawing.panel((left, bottom), 25)
    for y in range(SCREEN):
        for x in range(SCREEN):
            covered = inside(x + 0.5, y + 0.5) and (x, y) not in hidden
            p.box((x, y), (x + 1, y + 1), FAINT, THIN, fill=fill(x, y) if covered else None)
    if triangle:
        p.line(CORNERS, BLUE, 2.2, closed=True)
    return p


@figure("00_pipeline", 1110, 330,
        "Vertices go through the vertex shader, the rasteriser, the depth test and the fragment shader into the pixels of an "
        "image")
def draw_pipeline(drawing: Drawing):
    board = drawing.panel()
    lefts = [20, 245, 470, 695, 915]
    first = drawing.panel((lefts[0], 100), 25)
    for (x, y), name in zip(CORNERS, ("0", "1", "2")):
        first.dot((x * 0.9, y * 0.9 + 0.3), BLUE, name, offset=(14, 14), size=SMALL)
    second = screen(drawing, lefts[1], 100, None, False, {(x, y) for x in range(SCREEN) for y in range(SCREEN)})
    for corner in CORNERS:
        second.dot(corner, BLUE)
    second.line(CORNERS, BLUE, THIN, dash=True, closed=True)
    third = screen(drawing, lefts[2], 100, lambda x, y: PALE_BLUE, True)
    for y in range(SCREEN):
        for x in range(SCREEN):
            third.dot((x + 0.5, y + 0.5), BLUE if inside(x + 0.5, y + 0.5) else FAINT, radius_px=2.5)
    hidden = {(x, y) for x in (3, 4, 5) for y in (2, 3, 4, 5)}
    fourth = screen(drawing, lefts[3], 100, lambda x, y: PALE_BLUE, False, hidden)
    fourth.box((3, 2), (6, 5), ORANGE, 2.2, fill=PALE_ORANGE, label="nearer")
    last = screen(drawing, lefts[4], 100, lambda x, y: f"#{40 + 34 * x:02x}{120 + 22 * y:02x}60", False, hidden)
    last.box((3, 2), (6, 5), None, fill=PALE_ORANGE)
    for x in (3, 4, 5):
        for y in (2, 3, 4):
            last.box((x, y), (x + 1, y + 1), FAINT, THIN)
    titles = [("vertices", INK), ("vertex shader", GREEN), ("rasteriser", GREY), ("depth test", GREY), ("fragment shader", GREEN)]
    below = ["points with\nattributes", "where on\nthe screen?", "which pixels?\nfragments", "is something\nnearer there?", "which\ncolour?"]
    for left, (title, color), text in zip(lefts, titles, below):
        board.text((left + 75, 290), title, color, bold=True)
        board.text((left + 75, 52), text, GREY, SMALL)
    for left in lefts[1:]:
        board.arrow((left - 58, 175), (left - 14, 175), INK)


HOUSE = [(-0.4, 0), (0.4, 0), (0.4, 0.5), (0, 0.9), (-0.4, 0.5)]


def axes(p, at, x, y, size=0.7):
    p.arrow(at, (at[0] + size * x[0], at[1] + size * x[1]), RED, width=2)
    p.arrow(at, (at[0] + size * y[0], at[1] + size * y[1]), GREEN, width=2)


def house(p, place):
    p.line([place(point) for point in HOUSE], INK, 2.2, closed=True, fill=PALE_GREEN)


@figure("00_spaces", 1080, 330,
        "A house in its own space, in the world beside a camera, in the camera's space, in normalised device coordinates, "
        "and in pixels")
def draw_spaces(drawing: Drawing):
    board = drawing.panel()
    lefts = [110, 320, 540, 755, 970]
    names = ["object space", "world space", "view space", "NDC", "screen space"]
    steps = ["model\nmatrix", "view\nmatrix", "projection to\nclip space, ÷ w", "viewport"]
    for left, name in zip(lefts, names):
        board.text((left, 295), name, INK, SMALL, bold=True)
    for left, step in zip(lefts, steps):
        board.arrow((left + 72, 72), (left + 138, 72), INK)
        board.text((left + 105, 28), step, BLUE, SMALL)
    p = drawing.panel((lefts[0], 140), 85)
    house(p, lambda q: q)
    axes(p, (0, 0), (1, 0), (0, 1))
    p = drawing.panel((lefts[1], 140), 85)
    house(p, lambda q: (0.45 + 0.6 * q[0] - 0.2 * q[1], 0.35 + 0.2 * q[0] + 0.6 * q[1]))
    axes(p, (-0.75, -0.25), (1, 0), (0, 1), 0.5)
    p.eye((-0.45, 0.95), -30, 26)
    p = drawing.panel((lefts[2], 140), 85)
    house(p, lambda q: (0.55 + 0.6 * q[0], 0.25 + 0.55 * q[1]))
    p.eye((-0.75, 0.45), 0, 26)
    p.line([(-0.75, 0.45), (1.0, 1.2)], FAINT, THIN)
    p.line([(-0.75, 0.45), (1.0, -0.3)], FAINT, THIN)
    p = drawing.panel((lefts[3], 140), 85)
    p.box((-0.75, -0.3), (0.75, 1.2), ORANGE, THIN)
    house(p, lambda q: (0.1 + 0.9 * q[0], 0.1 + 0.95 * q[1]))
    p.text((-0.72, 1.32), "−1", GREY, SMALL)
    p.text((0.72, 1.32), "1", GREY, SMALL)
    p = drawing.panel((lefts[4], 140), 85)
    for i in range(9):
        p.line([(-0.8 + 0.2 * i, -0.2), (-0.8 + 0.2 * i, 1.0)], FAINT, 1)
    for i in range(7):
        p.line([(-0.8, -0.2 + 0.2 * i), (0.8, -0.2 + 0.2 * i)], FAINT, 1)
    house(p, lambda q: (0.1 + 0.95 * q[0], 0.05 + 0.8 * q[1]))


TEXELS = 8  # texels


def shade(x: int, y: int) -> int:
    """Light stripes that lean, on dark."""
    return 235 if (x + y) % 4 < 2 else 70


def mean(size: int) -> list[list[float]]:
    step = TEXELS // size
    return [[sum(shade(step * x + i, step * y + j) for i in range(step) for j in range(step)) / step ** 2 for x in range(size)]
            for y in range(size)]


def level(p, at, size: int, side: float):
    texel = side / size
    for y, row in enumerate(mean(size)):
        for x, value in enumerate(row):
            color = f"#{round(value):02x}{round(value * 0.93):02x}{round(value * 0.8):02x}"
            p.box((at[0] + x * texel, at[1] + y * texel), (at[0] + (x + 1) * texel, at[1] + (y + 1) * texel), FAINT, 1, fill=color)


@figure("00_texture", 1000, 380,
        "A texture of 8 by 8 texels with coordinates u and v from 0 to 1; a sample between four texel centres; the same "
        "texture in levels of half the size each")
def draw_texture(drawing: Drawing):
    p = drawing.panel()
    left, bottom, side = 50, 70, 240
    level(p, (left, bottom), TEXELS, side)
    p.arrow((left, bottom - 14), (left + side + 22, bottom - 14), INK, "*u*", width=2)
    p.arrow((left - 14, bottom), (left - 14, bottom + side + 22), INK, "*v*", width=2)
    p.text((left, bottom - 40), "0", GREY, SMALL)
    p.text((left + side, bottom - 40), "1", GREY, SMALL)
    p.text((left + side / 2 + 20, bottom + side + 40), "texture", INK, bold=True)
    # The sample.
    x, y, wide = 400, 120, 85
    for i in (0, 1):
        for j in (0, 1):
            value = shade(3 + i, 2 + j)
            color = f"#{value:02x}{round(value * 0.93):02x}{round(value * 0.8):02x}"
            p.box((x + i * wide, y + j * wide), (x + (i + 1) * wide, y + (j + 1) * wide), FAINT, 1, fill=color)
            p.dot((x + (i + 0.5) * wide, y + (j + 0.5) * wide), BLUE)
    at = (x + 0.9 * wide, y + 1.2 * wide)
    for i in (0, 1):
        for j in (0, 1):
            p.line([at, (x + (i + 0.5) * wide, y + (j + 0.5) * wide)], ORANGE, THIN)
    p.dot(at, ORANGE, radius_px=8)
    p.text((x + wide, bottom + side + 40), "sampler", INK, bold=True)
    p.text((x + wide, 70), "a weighted mean of\nthe four nearest texels", GREY, SMALL)
    low, high = [(left + i * side / TEXELS, bottom + j * side / TEXELS) for i, j in ((3, 2), (5, 4))]
    p.box(low, high, ORANGE, 2.2)
    p.line([(high[0], low[1]), (x, y)], GREY, THIN, dash=True)
    p.line([high, (x, y + 2 * wide)], GREY, THIN, dash=True)
    # The levels.
    at = 640
    for i, size in enumerate((8, 4, 2, 1)):
        side_px = 150 / 2 ** i
        level(p, (at, 130), size, side_px)
        p.text((at + side_px / 2, 100), f"{i}", GREY, SMALL)
        at += side_px + 22
    p.text((800, bottom + side + 40), "mip levels", INK, bold=True)
    p.text((800, 60), "each texel: the mean of four\nof the level before", GREY, SMALL)


COLORS = ((BLUE, PALE_BLUE), (ORANGE, PALE_ORANGE))


@figure("00_two_frames", 1000, 370,
        "Rows of CPU, GPU and screen over time. Frames alternate between two sets of commands, semaphores and fences. The CPU "
        "waits for the fence of two frames ago, the GPU for an acquired image, the screen for a finished one")
def draw_two_frames(drawing: Drawing):
    p = drawing.panel((110, 60), 1)
    rows = {"CPU": 210, "GPU": 120, "screen": 30}
    for name, y in rows.items():
        p.text((-14, y + 20), name, INK, SMALL, anchor="end")
    step, record, gpu = 200, 110, 180
    for i in range(4):
        color, fill = COLORS[i % 2]
        begin = i * step
        p.box((begin, rows["CPU"]), (begin + record, rows["CPU"] + 40), color, THIN, fill=fill, label=f"record {i}")
        start = begin + record + 12
        if start + gpu < 870:
            p.box((start, rows["GPU"]), (start + gpu, rows["GPU"] + 40), color, THIN, fill=fill, label=f"draw {i}")
            p.arrow((begin + record, rows["CPU"] + 4), (start + 4, rows["GPU"] + 40), GREY, width=THIN)
            shown = start + gpu + 12
            if shown + 130 < 870:
                p.box((shown, rows["screen"]), (shown + 150, rows["screen"] + 40), color, THIN, fill=PALE_GREEN, label=f"show {i}")
                p.arrow((start + gpu - 4, rows["GPU"]), (shown + 4, rows["screen"] + 40), PURPLE, width=THIN)
        if i >= 2:
            ended = (i - 2) * step + record + 12 + gpu
            p.arrow((ended, rows["GPU"] + 40), (max(begin + 10, ended + 10), rows["CPU"]), RED, width=THIN, dash=True)
    p.text((0, 278), "fence (red): the CPU reuses a set when its frame has ended", RED, SMALL, anchor="start")
    p.text((0, -16), "semaphore (purple): the screen waits for the drawing", PURPLE, SMALL, anchor="start")
    p.arrow((520, -38), (850, -38), GREY, width=THIN)
    p.text((690, -20), "time", GREY, SMALL)


@figure("00_vectors", 1000, 330,
        "A vector between two points; the dot product as a length along a unit vector; the cross product of two edges, "
        "perpendicular to both")
def draw_vectors(drawing: Drawing):
    p = drawing.panel((40, 70), 100)
    p.dot((0.2, 0.3), INK, "*p*", offset=(-16, 10))
    p.dot((2.2, 1.5), INK, "*q*", offset=(16, 10))
    p.arrow((0.2, 0.3), (2.2, 1.5), BLUE, "*q* − *p*", at=0.5, offset=(-34, 22))
    p.text((1.2, -0.35), "from p to q", GREY, SMALL)
    p = drawing.panel((380, 70), 100)
    tip = polar(1.7, 40)
    p.arrow((0, 0), (2.2, 0), GREEN, "*n*")
    p.arrow((0, 0), tip, BLUE, "*a*")
    p.line([tip, (tip[0], 0)], GREY, THIN, dash=True)
    p.right_angle((tip[0], 0), 90)
    p.arc((0, 0), 0.5, 0, 40, "θ")
    p.line([(0, 0), (tip[0], 0)], ORANGE, 6)
    p.text((1.0, -0.35), "*a* · *n* = |*a*| cos θ, for |*n*| = 1", ORANGE, SMALL)
    p = drawing.panel((740, 90), 100)
    a, b = (1.7, -0.1), (0.75, 0.75)
    p.line([(0, 0), a, (a[0] + b[0] - 0.25, a[1] + b[1]), b], None, closed=True, fill=PALE_GREY)
    p.arrow((0, 0), a, BLUE, "*a*")
    p.arrow((0, 0), b, GREEN, "*b*", offset=(20, 8))
    p.arrow((0, 0), (0, 1.6), RED, "*a* × *b*", offset=(52, 4))
    p.text((0.95, -0.55), "length: the area between", GREY, SMALL)


BOXES = {  # name: (left, bottom, width, colour, fill)
    "instance": (20, 330, 130, INK, PALE_GREY), "physical device": (190, 330, 170, INK, PALE_GREY), "device": (400, 330, 110, INK, PALE_GREY),
    "queue": (800, 330, 100, INK, PALE_GREY),
    "buffer": (20, 220, 110, BLUE, PALE_BLUE), "memory": (160, 220, 110, BLUE, PALE_BLUE), "image": (300, 220, 100, BLUE, PALE_BLUE),
    "image view": (430, 220, 130, BLUE, PALE_BLUE),
    "command pool": (600, 220, 160, ORANGE, PALE_ORANGE), "semaphore, fence": (790, 220, 190, PURPLE, PALE_GREY),
    "shader modules": (20, 110, 160, GREEN, PALE_GREEN), "pipeline layout": (210, 110, 160, GREEN, PALE_GREEN),
    "pipeline": (400, 110, 110, GREEN, PALE_GREEN),
    "command buffer": (590, 110, 180, ORANGE, PALE_ORANGE), "submission": (820, 110, 130, ORANGE, PALE_ORANGE),
}
ARROWS = [("instance", "physical device"), ("physical device", "device"), ("device", "queue"), ("memory", "buffer"), ("memory", "image"),
          ("image", "image view"), ("shader modules", "pipeline layout"), ("pipeline layout", "pipeline"), ("command pool", "command buffer"),
          ("pipeline", "command buffer"), ("command buffer", "submission"), ("semaphore, fence", "submission"), ("image view", "command buffer")]
HIGH = 44


@figure("00_vulkan_objects", 1000, 410,
        "Instance, physical device, device and queue; memory, buffers, images and views; shaders, layout and pipeline; a "
        "pool, its command buffer, and a submission with semaphores and a fence")
def draw_vulkan_objects(drawing: Drawing):
    p = drawing.panel((0, 0), 1)
    for name, (left, bottom, width, color, fill) in BOXES.items():
        p.box((left, bottom), (left + width, bottom + HIGH), color, THIN, fill=fill, label=name)

    def side(name: str, other: str):
        left, bottom, width, *_ = BOXES[name]
        x, y = BOXES[other][0] + BOXES[other][2] / 2, BOXES[other][1]
        if y == bottom:
            return (left if x < left else left + width), bottom + HIGH / 2
        return min(max(x, left + 14), left + width - 14), bottom if y < bottom else bottom + HIGH

    for a, b in ARROWS:
        p.arrow(side(a, b), side(b, a), GREY, width=THIN)
    p.text((500, 50), "The device makes everything below the first row. An arrow: is made from, or uses.", INK, SMALL)


@figure("00_descriptors", 1040, 400,
        "Four draws read three textures: through a set of each draw's own, through a kept set of each texture, through a "
        "reference in the command buffer, and through an index into one table, in which the textures of a model are a range")
def draw_descriptors(drawing: Drawing):
    colors = {"a": (BLUE, PALE_BLUE), "b": (ORANGE, PALE_ORANGE), "c": (GREEN, PALE_GREEN)}
    read = ("b", "a", "b", "c")  # by each draw
    rows, heights = (210, 150, 90, 30), {"a": 190, "b": 120, "c": 50}
    for k, (title, words) in enumerate((("a set per draw", "per draw: allocate,\nwrite, bind"),
                                        ("a set per texture", "per draw: bind"),
                                        ("push descriptors", "per draw: write into\nthe command buffer"),
                                        ("one table", "bind once;\nper draw: an index"))):
        p = drawing.panel((30 + 258 * k, 90), 1)
        p.text((103, 272), title, INK, SMALL, bold=True)
        p.text((103, -44), words, GREY, SMALL)
        for name, (color, pale) in colors.items():
            y = heights[name]
            p.box((172, y - 18), (208, y + 18), color, THIN, fill=pale, label=name)
        entries = {"a": 0, "b": 1, "c": 5}
        middle = {name: 206 - 22 * i for name, i in entries.items()}
        if title == "a set per texture":
            for name, y in heights.items():
                p.box((95, y - 14), (123, y + 14), colors[name][0], THIN)
                p.arrow((109, y), (170, y), colors[name][0], width=THIN)
        if title == "one table":
            for i in range(9):
                held = [colors[name][1] for name, entry in entries.items() if entry == i]
                p.box((95, 195 - 22 * i), (123, 217 - 22 * i), GREY, THIN, fill=held[0] if held else None)
            for name, y in middle.items():
                p.arrow((109, y), (170, heights[name]), colors[name][0], width=THIN)
        for y, name in zip(rows, read):
            color = colors[name][0]
            p.box((0, y - 18), (44, y + 18), INK, THIN, fill=PALE_GREY)
            if title == "a set per draw":
                p.box((95, y - 14), (123, y + 14), color, THIN, dash=True)
                p.arrow((44, y), (93, y), INK, width=THIN)
                p.arrow((109, y), (170, heights[name]), color, width=THIN)
            elif title == "a set per texture":
                p.arrow((44, y), (93, heights[name]), INK, width=THIN)
            elif title == "push descriptors":
                p.box((24, y - 12), (40, y + 12), color, THIN, dash=True)
                p.arrow((32, y), (170, heights[name]), color, width=THIN)
            else:
                p.arrow((44, y), (93, middle[name]), INK, width=THIN)
            p.text((13 if title == "push descriptors" else 22, y), str(entries[name]) if title == "one table" else name,
                   INK if title == "one table" else color, SMALL, rim=False)
