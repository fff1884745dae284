"""Diagrams of chapter 06's lessons: python3 docs/figures/draw.py draws them."""

from drawing import (BLUE, EYE, GREEN, GREY, INK, LIGHT, ORANGE, PALE_BLUE, PALE_GREEN, PALE_ORANGE, PURPLE, RED, THIN, Drawing,
                     figure, polar)


@figure("06_light_volume", 900, 400,
        "Rays from a camera outside and one inside a light's sphere: the back face is behind the surface where the surface "
        "may be lit, and in front of it where it is not")
def draw_light_volume(drawing: Drawing):
    p = drawing.panel((440, 70), 100)
    p.circle((0, 1.1), 1.5, LIGHT, dash=True, fill=PALE_ORANGE)
    p.ground(-3.9, 4.2)
    p.line([(2.5, 0), (2.5, 2.9), (3.1, 2.9), (3.1, 0)], INK)
    p.lamp((0, 1.1))
    p.eye((-3.6, 2.5), -25, 36)
    p.eye((-0.5, 2.0), 10, 36)
    p.line([(-3.6, 2.5), (0.35, 0)], EYE, THIN)
    p.dot((0.35, 0), GREEN)
    p.line([(0.35, 0), (0.9, -0.35)], GREY, THIN, dash=True)
    p.text((0.2, -0.45), "surface first, back face behind it: lit", GREEN, size=18)
    p.line([(-0.5, 2.0), (2.5, 2.2)], EYE, THIN)
    p.dot(polar(1.5, 45, (0, 1.1)), LIGHT)
    p.dot((2.5, 2.2), RED)
    p.text((2.8, 3.05), "back face first: skipped", RED, size=18)
    p.text((-3.6, 2.95), "camera outside", EYE, size=18)
    p.text((-0.45, 2.85), "camera inside", EYE, size=18)


@figure("06_octahedron", 900, 430,
        "A direction is scaled onto an octahedron; its lower half is folded outwards, so that both halves fill a square")
def draw_octahedron(drawing: Drawing):
    p = drawing.panel((210, 225), 130)
    p.circle((0, 0), 1.0, GREY, THIN, dash=True)
    p.line([(0, 1), (1, 0), (0, -1), (-1, 0)], INK, closed=True)
    tip = polar(1.0, 62)
    share = 1 / (abs(tip[0]) + abs(tip[1]))
    p.arrow((0, 0), tip, GREEN, "*n*")
    p.dot((tip[0] * share, tip[1] * share), RED)
    p.line([(tip[0] * share, tip[1] * share), (tip[0] * share, 0)], RED, THIN, dash=True)
    p.dot((tip[0] * share, 0), RED, "*e*", offset=(0, -20))
    p.text((0, 1.18), "+z", INK)
    p.text((0, -1.22), "−z", INK)
    p.text((0.0, -1.5), "from the side", GREY, size=18)
    q = drawing.panel((640, 225), 130)
    q.box((-1, -1), (1, 1), INK, fill=PALE_ORANGE)
    q.line([(0, 1), (1, 0), (0, -1), (-1, 0)], INK, closed=True, fill=PALE_BLUE)
    q.text((0, 0), "+z", BLUE, offset=(0, -6))
    for x, y in ((-1, 1), (1, 1), (-1, -1), (1, -1)):
        q.text((0.84 * x, 0.84 * y), "−z", ORANGE, offset=(0, -6))
    q.arrow((0.28, 0.34), (0.66, 0.72), RED)
    q.text((0.2, 0.42), "fold", RED, size=18, anchor="end")
    q.text((1.12, 0), "+x", INK, anchor="start", offset=(0, -6))
    q.text((0, 1.16), "+y", INK)
    q.text((0, -1.5), "from above, unfolded", GREY, size=18)


@figure("06_passes", 900, 330,
        "Surfaces are written into a G-buffer with depth; lights read it and write radiance; emission is added; the forward "
        "path does all at once")
def draw_passes(drawing: Drawing):
    p = drawing.panel((0, 0), 1)

    def box(x, y, wide, text, fill, color):
        p.box((x, y), (x + wide, y + 76), color, fill=fill)
        p.text((x + wide / 2, y + 38), text, INK, size=18, offset=(0, -6))

    box(30, 190, 150, "surfaces", PALE_BLUE, BLUE)
    box(260, 190, 170, "G-buffer + depth", PALE_GREEN, GREEN)
    box(520, 190, 150, "lights", PALE_ORANGE, ORANGE)
    box(750, 190, 120, "radiance", PALE_GREEN, GREEN)
    for a, b in ((180, 260), (430, 520), (670, 750)):
        p.arrow((a, 228), (b, 228), INK)
    p.text((220, 290), "raster, 12 bytes per pixel", GREY, size=18)
    p.text((600, 290), "compute, or volumes", GREY, size=18)
    box(520, 70, 150, "emission", PALE_BLUE, PURPLE)
    p.arrow((670, 108), (806, 186), PURPLE)
    p.text((595, 36), "written first, where depth is equal", GREY, size=18)
    p.arrow((105, 186), (105, 120), GREY)
    p.text((105, 92), "forward: lit at once,", GREY, size=18)
    p.text((105, 66), "layer by layer", GREY, size=18)
