"""Width of a penumbra: similar triangles between a light, an edge and the ground.

python3 docs/figures/05_penumbra.py writes docs/images/05_penumbra.svg.
"""

from drawing import FAINT, GREY, INK, LIGHT, PURPLE, RED, SMALL, THIN, Drawing

LAMP, EDGE = 3.0, 1.55  # heights above the ground
HALF = 0.5              # of the light's size


def draw() -> Drawing:
    drawing = Drawing(900, 470, "A light of size s, an edge at distance b from it and the ground at distance r: the penumbra is "
                                "s (r - b) / b wide")
    p = drawing.panel((430, 60), 125)
    p.ground(-2.6, 2.6)
    p.line([(-HALF, LAMP), (HALF, LAMP)], LIGHT, 7)
    p.text((HALF, LAMP), "light, *s*", LIGHT, offset=(16, 0), anchor="start")
    p.line([(-2.0, EDGE), (0, EDGE)], INK, 7)
    p.text((-2.0, EDGE), "blocker", INK, SMALL, offset=(0, 20), anchor="start")
    ends = []
    for x in (-HALF, HALF):
        end = -x * EDGE / (LAMP - EDGE)
        ends.append(end)
        p.line([(x, LAMP), (end, 0)], LIGHT, THIN, dash=True)
    p.line([(min(ends), 0), (max(ends), 0)], PURPLE, 7)
    p.line([(-2.6, 0), (min(ends), 0)], INK, 7)
    p.text((0, 0), "penumbra  *w* = *s* (*r* − *b*) / *b*", PURPLE, offset=(20, -38))
    p.text((-2.55, 0), "umbra", INK, SMALL, offset=(0, 18), anchor="start")
    p.text((1.4, 0), "lit", GREY, SMALL, offset=(0, 18), anchor="end")
    p.span((2.0, LAMP), (2.0, EDGE), "")
    p.text((2.0, 0.5 * (LAMP + EDGE)), "*b*", GREY, offset=(18, 0))
    p.span((2.5, LAMP), (2.5, 0.0), "")
    p.text((2.5, 0.5 * LAMP), "*r*", GREY, offset=(18, 0))
    p.line([(HALF + 1.05, LAMP), (2.6, LAMP)], FAINT, THIN, dash=True)
    p.line([(0.05, EDGE), (2.1, EDGE)], FAINT, THIN, dash=True)
    p.dot((0, EDGE), RED)
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
