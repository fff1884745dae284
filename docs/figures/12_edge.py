"""An edge of light on skin: the spread of red, green and blue into the shadow.

python3 docs/figures/12_edge.py writes docs/images/12_edge.svg.
"""

import math

from drawing import BLUE, FAINT, GREEN, INK, RED, SMALL, THIN, Drawing

VARIANCE = (0.0064, 0.0484, 0.187, 0.567, 1.99, 7.41)
WEIGHT = {RED: (0.233, 0.1, 0.118, 0.113, 0.358, 0.078), GREEN: (0.455, 0.336, 0.198, 0.007, 0.004, 0.0),
          BLUE: (0.649, 0.344, 0.0, 0.007, 0.0, 0.0)}


def edge(x: float, color: str) -> float:
    return sum(w * 0.5 * math.erfc(-x / math.sqrt(2 * v)) for w, v in zip(WEIGHT[color], VARIANCE))


def draw() -> Drawing:
    drawing = Drawing(900, 400, "Light begins at 0 mm. Blue and green rise within half a millimetre; red begins 3 mm within the shadow "
                                "and is full 3 mm within the light")
    p = drawing.panel((440, 60), 96)
    p.arrow((-4.2, 0), (4.2, 0), INK, "mm", offset=(24, 0))
    for x in range(-4, 5, 2):
        p.text((x, 0), str(x), INK, SMALL, offset=(0, -20))
    p.line([(-4, 0), (0, 0)], FAINT, 4)
    p.line([(0, 0), (0, 2.8)], FAINT, THIN, dash=True)
    for color in (BLUE, GREEN, RED):
        p.curve(lambda x, color=color: (x, 2.8 * edge(x, color)), -4, 4, color, 4, steps=300)
    p.text((-1.5, 0.62), "red: light in the shadow", RED, anchor="end")
    p.text((0.35, 1.75), "green", GREEN, anchor="start", offset=(6, -14))
    p.text((0.05, 2.66), "blue", BLUE, anchor="end", offset=(-10, -4))
    p.text((-3, 2.7), "shadow", INK)
    p.text((3, 1.2), "light", INK)
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
