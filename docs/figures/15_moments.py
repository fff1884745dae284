"""The transmittance along a ray that four moments describe, beside the true one.

python3 docs/figures/15_moments.py writes docs/images/15_moments.svg.
"""

from math import exp, log, sqrt

from drawing import BLUE, GREY, INK, SMALL, Drawing

LAYERS = [(-0.75, 0.45), (-0.6, 0.35), (-0.5, 0.3), (0.35, 0.5), (0.5, 0.4), (0.62, 0.3)]  # depth from -1 to 1, opacity
OVERESTIMATION = 0.25


def moments() -> list[float]:
    absorbed = [(z, -log(1 - alpha)) for z, alpha in LAYERS]
    return [sum(a * z ** k for z, a in absorbed) for k in range(5)]


def solve(rows: list[list[float]], right: list[float]) -> list[float]:
    """Gauss's elimination with pivots."""
    n = len(right)
    m = [row + [value] for row, value in zip(rows, right)]
    for i in range(n):
        pivot = max(range(i, n), key=lambda r: abs(m[r][i]))
        m[i], m[pivot] = m[pivot], m[i]
        for r in range(i + 1, n):
            factor = m[r][i] / m[i][i]
            m[r] = [a - factor * b for a, b in zip(m[r], m[i])]
    out = [0.0] * n
    for i in reversed(range(n)):
        out[i] = (m[i][n] - sum(m[i][j] * out[j] for j in range(i + 1, n))) / m[i][i]
    return out


def estimated(z0: float) -> float:
    """Münstermann et al. 2018: the mass in front of z0 of the distribution on z0 and two other depths with these moments."""
    b = [value / moments()[0] for value in moments()]
    b = [b[0], *[value * (1 - 5e-7) for value in b[1:]]]
    c = solve([[b[i + j] for j in range(3)] for i in range(3)], [1, z0, z0 * z0])
    root = sqrt(max(c[1] ** 2 - 4 * c[2] * c[0], 0))
    depths = [z0, *sorted(((-c[1] - root) / (2 * c[2]), (-c[1] + root) / (2 * c[2])))]
    weights = solve([[z ** k for z in depths] for k in range(3)], b[:3])
    mass = OVERESTIMATION * weights[0] + sum(w for z, w in zip(depths[1:], weights[1:]) if z < z0)
    return exp(-moments()[0] * mass)


def true(z0: float) -> float:
    left = 1.0
    for z, alpha in LAYERS:
        if z < z0:
            left *= 1 - alpha
    return left


def draw() -> Drawing:
    drawing = Drawing(1000, 360, "Six layers in two groups along a ray; the true transmittance falls in six steps, that of four moments in a smooth "
                                 "curve with two falls")
    p = drawing.panel((500, 70), 420)
    high = 0.55
    p.arrow((-1.05, 0), (1.08, 0), GREY, "*z*", width=2)
    p.arrow((-1, 0), (-1, 0.62), GREY, width=2)
    p.text((-1, high), "1", GREY, SMALL, anchor="end", offset=(-8, 0))
    for z, alpha in LAYERS:
        p.line([(z, -0.02), (z, -0.02 - 0.12 * alpha)], INK, 4)
    p.line([(-1 + 2 * i / 1000, high * true(-1 + 2 * i / 1000)) for i in range(1001)], INK)
    p.line([(-0.999 + 1.998 * i / 300, high * min(estimated(-0.999 + 1.998 * i / 300), 1)) for i in range(301)], BLUE, 2.4, dash=True)
    p.text((-0.2, 0.34), "true: a step at each layer", INK, SMALL, anchor="start")
    p.text((-0.2, 0.42), "from four moments", BLUE, SMALL, anchor="start")
    p.text((-0.93, 0.66), "transmittance", GREY, SMALL, anchor="start")
    p.text((-0.1, -0.1), "layers", GREY, SMALL)
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
