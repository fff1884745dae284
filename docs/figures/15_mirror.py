"""The camera below the water, with the water as near plane.

python3 docs/figures/15_mirror.py writes docs/images/15_mirror.svg.
"""

from drawing import BLUE, FAINT, GREY, INK, ORANGE, PALE_BLUE, PALE_GREEN, PALE_GREY, RED, SMALL, THIN, Drawing


def draw() -> Drawing:
    drawing = Drawing(1000, 400, "A camera above a lake sees a tower in the water; the ray to the mirrored tower is the mirrored camera's ray to "
                                 "the tower itself; the bed of the lake below the surface is clipped")
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
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
