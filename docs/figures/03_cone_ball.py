"""How far a point is from a cone: three places around the apex.

python3 docs/figures/03_cone_ball.py writes docs/images/03_cone_ball.svg.
"""

from math import cos, radians, sin

from drawing import BLUE, GREEN, INK, LIGHT, PALE_ORANGE, RED, SMALL, THIN, Drawing, polar

HALF = 24  # of the cone, in degrees; its axis points to the right


def draw() -> Drawing:
    drawing = Drawing(900, 425, "A cone and the middles of three balls: one within the cone, distance 0; one beside it, distance l sin "
                                "a to the cone's side; one more than 90 degrees from the side, distance l to the apex")
    p = drawing.panel((330, 192), 230)
    p.line([(0, 0), polar(1.86, HALF), polar(1.86, -HALF)], None, fill=PALE_ORANGE)
    for side in (HALF, -HALF):
        p.line([(0, 0), polar(1.86, side)], LIGHT)
    p.arrow((0, 0), (1.6, 0), LIGHT, "axis", at=0.85, offset=(0, -18), size=SMALL)
    p.arc((0, 0), 0.75, 0, HALF)
    p.text(polar(0.6, 10), "γ_{outer}", INK, SMALL, offset=(2, 0))
    p.dot(polar(1.35, 12), GREEN, "0", offset=(18, 0))
    beside, angle = polar(1.05, HALF + 40), 40
    p.line([(0, 0), beside], BLUE, THIN)
    p.text(polar(0.62, HALF + 40), "l", BLUE, offset=(-14, 6))
    p.arc((0, 0), 0.32, HALF, HALF + angle, "a", BLUE)
    foot = polar(1.05 * cos(radians(angle)), HALF)
    p.line([beside, foot], BLUE)
    p.right_angle(foot, HALF + 90, color=BLUE)
    p.dot(beside, BLUE)
    p.text(((beside[0] + foot[0]) / 2, (beside[1] + foot[1]) / 2), "l sin a", BLUE, anchor="start", offset=(10, 8))
    behind = polar(0.85, HALF + 130)
    p.line([(0, 0), behind], RED)
    p.dot(behind, RED)
    p.text(polar(0.45, HALF + 130), "l", RED, offset=(4, 18))
    p.arc((0, 0), 0.2, HALF, HALF + 130, color=RED)
    p.text((-0.34, 0.46), "a > 90°", RED, SMALL, anchor="end")
    p.line([(0, 0), polar(0.8, HALF + 90)], RED, THIN, dash=True)
    p.lamp((0, 0), 9)
    assert abs(1.05 * sin(radians(angle)) - ((beside[0] - foot[0]) ** 2 + (beside[1] - foot[1]) ** 2) ** 0.5) < 1e-9
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
