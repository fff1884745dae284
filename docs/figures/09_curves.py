"""Tone curves over stops: displayed codes of grey light, at equal middle grey.

python3 docs/figures/09_curves.py writes docs/images/09_curves.svg.
"""

from math import log2

from drawing import BLUE, FAINT, GREEN, GREY, INK, ORANGE, PURPLE, RED, SMALL, THIN, Drawing

# Gain for each curve that maps 0.18 to the reference's brightness: build/tests/test_09_post_effects "[figures]".
GAINS = {"clamp": 0.578, "reinhard": 0.645, "hill": 0.990, "neutral": 0.800, "agx": 0.450}


def hill(x: float) -> float:
    # For grey the matrices are 1 but for rounding.
    return (x * (x + 0.0245786) - 0.000090537) / (x * (0.983729 * x + 0.4329510) + 0.238081)


def neutral(x: float) -> float:
    x -= x - 6.25 * x * x if x < 0.08 else 0.04
    return x if x < 0.76 else 1 - 0.24 * 0.24 / (x + 0.24 - 0.76)


def agx(x: float) -> float:
    t = (min(max(log2(max(x, 1e-10)), -12.47393), 4.026069) + 12.47393) / 16.499999
    y = 0
    for c in (15.5, -40.14, 31.96, -6.868, 0.4298, 0.1191, -0.00232):
        y = y * t + c
    return min(max(y, 0), 1) ** 2.2


CURVES = {"clamp": (lambda x: min(x, 1), GREY), "reinhard": (lambda x: x / (1 + x), ORANGE), "hill": (hill, RED),
          "neutral": (neutral, GREEN), "agx": (agx, BLUE)}


def code(light: float) -> float:
    light = min(max(light, 0), 1)
    return 12.92 * light if light <= 0.0031308 else 1.055 * light ** (1 / 2.4) - 0.055


def draw() -> Drawing:
    drawing = Drawing(900, 440, "What is shown of grey light from 6 stops below middle grey to 8 above: clamp ends at 3.3 stops with a "
                                "corner, neutral bends just before, Hill's curve is S-shaped, AgX and Reinhard bend long before")
    p = drawing.panel((430, 70), 52)
    tall = 6.2
    p.arrow((-7, 0), (8.4, 0), INK)
    p.arrow((-7, 0), (-7, tall + 0.5), INK)
    p.line([(-7, tall), (8, tall)], FAINT, THIN, dash=True)
    p.text((-7, tall), "255", INK, SMALL, offset=(-24, 0))
    p.text((8.2, 0), "stops from middle grey", INK, anchor="end", offset=(0, -44))
    for stop in (-6, -3, 0, 3, 6):
        p.text((stop, 0), str(stop), INK, SMALL, offset=(0, -18))
    for name, (curve, color) in CURVES.items():
        p.curve(lambda s, curve=curve, name=name: (s, tall * code(curve(GAINS[name] * 0.18 * 2 ** s))), -7, 8, color, 3)
    p.text((-6.6, 5.9), "clamp", GREY, anchor="start", offset=(0, -6))
    p.text((-6.6, 5.2), "Hill", RED, anchor="start", offset=(0, -6))
    p.text((-6.6, 4.5), "neutral", GREEN, anchor="start", offset=(0, -6))
    p.text((-6.6, 3.8), "Reinhard", ORANGE, anchor="start", offset=(0, -6))
    p.text((-6.6, 3.1), "AgX", BLUE, anchor="start", offset=(0, -6))
    p.dot((0, tall * code(0.104)), PURPLE)
    p.text((0, tall * code(0.104)), "0.18: all alike", PURPLE, SMALL, anchor="start", offset=(12, -16))
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
