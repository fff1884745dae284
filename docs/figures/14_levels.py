"""The level of a band: it rises fast with a beat and falls slowly after it.

python3 docs/figures/14_levels.py writes docs/images/14_levels.svg.
"""

from math import exp

from drawing import BLUE, FAINT, GREY, INK, SMALL, THIN, Drawing

ATTACK_S, RELEASE_S, STEP_S = 0.010, 0.150, 1 / 128
BEATS_S = (0.1, 0.5, 0.72, 0.9)


def measured(t: float) -> float:
    """A drum: a strike that fades within some hundredths of a second."""
    return max((0.95 * exp(-(t - beat) / 0.03) for beat in BEATS_S if t >= beat), default=0.0)


def draw() -> Drawing:
    drawing = Drawing(1000, 330, "The measured level of a drum, grey, and the smoothed level, blue, which reaches each beat within hundredths of a "
                                 "second and falls to 37 percent in 150 milliseconds")
    p = drawing.panel((60, 60), 740)
    high = 0.26
    p.arrow((0, 0), (1.2, 0), GREY, "*t*", width=2)
    p.arrow((0, 0), (0, 0.32), GREY, width=2)
    p.line([(i / 1000, high * measured(i / 1000)) for i in range(1190)], FAINT, 3)
    level, points = 0.0, []
    for i in range(int(1.19 / STEP_S)):
        now = measured(i * STEP_S)
        level += (now - level) * (1 - exp(-STEP_S / (ATTACK_S if now > level else RELEASE_S)))
        points.append((i * STEP_S, high * level))
    p.line(points, BLUE)
    p.line([(0.2, -0.012), (0.2, 0.012)], GREY, THIN)
    p.text((0.2, -0.04), "0.2 s", GREY, SMALL)
    p.text((0.3, 0.2), "measured", GREY, SMALL)
    p.text((0.3, 0.255), "smoothed", BLUE, SMALL)
    p.text((0.02, 0.34), "level", INK, SMALL, anchor="start")
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
