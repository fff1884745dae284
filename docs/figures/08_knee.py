"""How much of a luminance passes a hard and a soft threshold.

python3 docs/figures/08_knee.py writes docs/images/08_knee.svg.
"""

from drawing import BLUE, FAINT, GREY, INK, RED, SMALL, THIN, Drawing


def knee(luminance: float, threshold: float, w: float) -> float:
    above = luminance - threshold
    return above if above >= w else 0 if above <= -w else (above + w) ** 2 / (4 * w)


def draw() -> Drawing:
    drawing = Drawing(900, 400, "What passes a threshold t: a hard one lets all pass from one luminance on, with a step; a soft one "
                                "begins at t - w with a parabola and goes on as a straight line from t + w")
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
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
