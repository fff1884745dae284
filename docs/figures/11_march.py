"""A ray marched by distances, and by steps 1.4 times as long, with a way back.

python3 docs/figures/11_march.py writes docs/images/11_march.svg.
"""

from math import hypot

from drawing import BLUE, FAINT, GREY, INK, PALE_GREY, RED, SMALL, THIN, Drawing

BALLS = [((2.6, 1.25), 0.75), ((7.0, -0.35), 0.75)]


def distance(x: float) -> float:
    return min(hypot(x - c[0], c[1]) - r for c, r in BALLS)


def draw() -> Drawing:
    drawing = Drawing(900, 640, "Above, a ray is marched by steps as long as the distance to the nearest ball: the spheres around its "
                                "points touch. Below, each step is 1.4 times as long; where two spheres leave a gap between them the "
                                "ray goes back")
    for row, relaxation in enumerate((1.0, 1.4)):
        p = drawing.panel((60, 490 - 330 * row), 100)
        for center, radius in BALLS:
            p.circle(center if row == 0 else (center[0], center[1]), radius, GREY, THIN, fill=PALE_GREY)
        p.arrow((0, 0), (8.1, 0), FAINT, width=2)
        t, before, step, said = 0.0, 0.0, 0.0, False
        for _ in range(14):
            here = distance(t)
            gap = before + here < step - 1e-9
            color = RED if gap else BLUE
            p.circle((t, 0), here, color, THIN, dash=gap)
            p.dot((t, 0), color)
            if gap:
                if not said:
                    p.text((t, 0), "a gap: go back", RED, SMALL, offset=(0, -60))
                said = True
                t += before - step
                step = before
                continue
            if here < 0.03:
                break
            before, step = here, relaxation * here
            t += step
        p.text((0, 0), "distance" if row == 0 else "relaxed, 1.4", INK, anchor="start", offset=(-30, 112))
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
