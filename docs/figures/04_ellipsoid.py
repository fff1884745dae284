"""GGX as the normals of a flattened ball: heights times alpha, slopes times alpha.

python3 docs/figures/04_ellipsoid.py writes docs/images/04_ellipsoid.svg.
"""

from math import atan2, cos, radians, sin, sqrt

from drawing import EYE, FAINT, GREY, INK, NORMAL, PURPLE, SMALL, THIN, Drawing, polar

ALPHA, SLANT = 0.45, 58  # of the ball's height; of the camera, in degrees from the normal


def draw() -> Drawing:
    drawing = Drawing(900, 290, "Left: a half ball and the same with its heights multiplied by alpha; a normal of the flattened one leans less. Right: "
                                "the part of the flattened ball that a slanted camera sees")
    p, q = drawing.panel((230, 40), 175), drawing.panel((670, 40), 175)
    p.curve(lambda a: polar(1, a), 0, 180, FAINT)
    for panel in (p, q):
        panel.ground(-1.15, 1.15)
        panel.curve(lambda a: (cos(radians(a)), ALPHA * sin(radians(a))), 0, 180, INK)
    angle = 50
    ball, flat = polar(1, angle), (cos(radians(angle)), ALPHA * sin(radians(angle)))
    p.line([ball, flat], GREY, THIN, dash=True)
    p.arrow(ball, polar(1.32, angle), GREY)
    steep = sqrt((ALPHA * cos(radians(angle))) ** 2 + sin(radians(angle)) ** 2)
    p.arrow(flat, (flat[0] + 0.42 * ALPHA * cos(radians(angle)) / steep, flat[1] + 0.42 * sin(radians(angle)) / steep), NORMAL)
    p.text((-0.62, 1.06), "half ball: *α* = 1", GREY, SMALL)
    p.text((-0.05, 0.18), "heights times *α*", INK, SMALL)
    # The grazing ray of the camera.
    along = (sin(radians(SLANT)), cos(radians(SLANT)))
    graze = sqrt(cos(radians(SLANT)) ** 2 + (ALPHA * sin(radians(SLANT))) ** 2)
    touch = (-cos(radians(SLANT)) / graze, ALPHA * ALPHA * sin(radians(SLANT)) / graze)
    q.line([touch, (touch[0] + 0.95 * along[0], touch[1] + 0.95 * along[1])], EYE, THIN, dash=True)
    q.curve(lambda t: (cos(t), ALPHA * sin(t)), 0.0, atan2(touch[1] / ALPHA, touch[0]), PURPLE, 6)
    q.arrow((0.2, 0.42), (0.2 + 0.75 * along[0], 0.42 + 0.75 * along[1]), EYE, "*V*")
    q.text((-0.45, 0.78), "seen by the camera", PURPLE, SMALL)
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
