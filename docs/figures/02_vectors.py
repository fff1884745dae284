"""The directions at a lit point: normal, light, eye, mirror direction, half vector.

python3 docs/figures/02_vectors.py writes docs/images/02_vectors.svg.
"""

from drawing import EYE, HALF, INK, LIGHT, MIRROR, NORMAL, Drawing, polar


def draw() -> Drawing:
    drawing = Drawing(900, 430, "The normal N, the directions L to the light and V to the camera, the mirror direction R "
                                "and the half vector H at a point of a surface")
    p = drawing.panel((430, 60), 300)
    p.ground(-1.35, 1.45)
    p.lamp(polar(1.32, 140))
    p.eye(polar(1.24, 20), 200, 46)
    for angle, color, name in ((90, NORMAL, "*N*"), (140, LIGHT, "*L*"), (20, EYE, "*V*"), (40, MIRROR, "*R*"),
                               (80, HALF, "*H*")):
        p.arrow((0, 0), polar(1.0, angle), color, name)
    p.arc((0, 0), 0.5, 90, 140, "θ", INK)
    p.arc((0, 0), 0.42, 40, 90, "θ", INK, offset=(10, 0))
    p.arc((0, 0), 0.72, 20, 40, "α", INK)
    p.arc((0, 0), 0.82, 80, 90, "α/2", INK, offset=(0, 4), size=18)
    p.text((-1.35, 0.98), "light", LIGHT, anchor="start")
    p.text((1.32, 0.56), "eye", EYE)
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
