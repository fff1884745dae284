"""Where the floats of a depth buffer lie along the view, forward and reverse. Drawn with floats of 3 bits behind the point.

python3 docs/figures/01_depth_floats.py writes docs/images/01_depth_floats.svg.
"""

from drawing import GREEN, GREY, RED, SMALL, THIN, Drawing

NEAR, FAR = 1.0, 8.0  # metres


def small_floats() -> list[float]:
    """The numbers from 2^-8 to 1 that have three bits behind the leading one."""
    return sorted({(8 + m) / 8 * 2.0 ** -e for e in range(1, 9) for m in range(8)} | {1.0})


def distance(depth: float, reverse: bool) -> float:
    """The distance that has this depth."""
    share = depth if reverse else 1 - depth
    return 1 / (share * (1 / NEAR - 1 / FAR) + 1 / FAR)


def draw() -> Drawing:
    drawing = Drawing(900, 330, "Depths that a float can hold, as distances from the camera: with forward depth they crowd at the "
                                "near plane, with reverse depth they are spread evenly")
    p = drawing.panel((20, 0), 100)
    p.eye((0.34, 2.05), 0, 46)
    for y, reverse, color, name in ((2.5, False, RED, "0 near, 1 far"), (1.15, True, GREEN, "1 near, 0 far")):
        p.line([(NEAR, y), (FAR, y)], GREY, THIN)
        for depth in small_floats():
            x = distance(depth, reverse)
            p.line([(x, y - 0.18), (x, y + 0.18)], color, 2)
        p.text((NEAR, y + 0.42), name, color, anchor="start", offset=(10, 0))
    for x, name in ((NEAR, "near plane"), (FAR, "far plane")):
        p.line([(x, 0.7), (x, 3.0)], GREY, THIN, dash=True)
        p.text((x, 0.48), name, GREY, SMALL)
    p.text((4.5, 0.48), "distance from the camera →", GREY, SMALL)
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
