"""Depth: of all surfaces along the ray of a pixel, the nearest one is kept.

python3 docs/figures/00_depth.py writes docs/images/00_depth.svg.
"""

from drawing import BLUE, FAINT, GREEN, GREY, INK, ORANGE, PALE_GREEN, PALE_ORANGE, SMALL, THIN, Drawing


def draw() -> Drawing:
    drawing = Drawing(1000, 330, "A camera looks through a column of pixels at a near box and a far wall; the image keeps the colour and "
                                 "the depth of what is nearer in each pixel")
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
                q.box((x, low), (x + 0.8, high), INK, THIN)
                q.text((x + 0.4, (low + high) / 2), "3.2 m" if near else "5.6 m", BLUE, SMALL, rim=False)
    q.text((1.05, -0.25), "what the two images keep", GREY, SMALL)
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
