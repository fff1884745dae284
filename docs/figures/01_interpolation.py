"""Equal steps on the screen are unequal steps on a surface that recedes.

python3 docs/figures/01_interpolation.py writes docs/images/01_interpolation.svg.
"""

from drawing import BLUE, GREY, INK, RED, SMALL, THIN, Drawing, between

EYE_AT, SCREEN = (0.0, 0.0), 1.0
A, B = (1.0, -1.0), (3.0, -1.0)  # a floor from the distance 1 to the distance 3


def draw() -> Drawing:
    drawing = Drawing(900, 330, "A floor from the distance 1 to 3: the middle between the two ends on the screen is a quarter of the way along the floor")
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
        u = (far - A[0]) / (B[0] - A[0])
        p.text(end, {0: "*u* = 0", 2: "*u* = ¼", 4: "*u* = 1"}.get(i, ""), RED if i == 2 else INK, SMALL, offset=(0, -24))
        assert i != 2 or abs(u - 0.25) < 1e-9
    p.text((2.55, -0.35), "equal steps on the screen,\nunequal steps on the floor", GREY, SMALL)
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
