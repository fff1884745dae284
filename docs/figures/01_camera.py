"""The camera's axes in the world: to the right, up, and along the view; and the frustum between the near and the far plane.

python3 docs/figures/01_camera.py writes docs/images/01_camera.svg.
"""

from drawing import BLUE, FAINT, GREEN, GREY, INK, PALE_BLUE, PALE_GREEN, RED, SMALL, THIN, Drawing

RIGHT, UP, ALONG = (0.5, -0.3), (0.0, 0.85), (0.97, 0.12)  # on paper


def draw() -> Drawing:
    drawing = Drawing(900, 420, "A camera at c with its axes r to the right, u up and d along the view, and its frustum, a pyramid without its tip")
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
    p.text(at(0, 0, 2.4), "*d*, −*z*", INK, offset=(40, -20))
    p.dot(at(0, 0, 0), INK, "*c*", offset=(-20, 0))
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
