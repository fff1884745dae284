"""The angles of reflection on a ball: normal, sun, camera, and the phase angle between the last two.

python3 docs/figures/17_angles.py writes docs/images/17_angles.svg.
"""

from math import cos, radians, sin

from drawing import BLUE, GREEN, GREY, INK, ORANGE, PALE_GREY, SMALL, THIN, Drawing, polar

RADIUS, NORMAL, SUN, CAMERA = 1.6, 70, 125, 25


def draw() -> Drawing:
    drawing = Drawing(860, 600, "A place of a ball with its normal, the directions to the sun and to the camera, and the phase angle "
                                "between those two; the terminator and the limb")
    p = drawing.panel((390, 200), 100)
    p.circle((0, 0), RADIUS, GREY, THIN, fill=PALE_GREY)
    at = polar(RADIUS, NORMAL)
    for angle, color, length, label, offset in ((NORMAL, INK, 1.25, "n", (-8, 14)), (SUN, ORANGE, 1.5, "to the sun, l", (-30, 14)),
                                                (CAMERA, BLUE, 1.5, "to the camera, v", (70, 8))):
        tip = (at[0] + length * cos(radians(angle)), at[1] + length * sin(radians(angle)))
        p.arrow(at, tip, color)
        p.text(tip, label, color, SMALL, offset=offset)
    p.arc(at, 0.62, CAMERA, SUN, "", GREEN)
    p.text(polar(0.8, 0.5 * (CAMERA + NORMAL), at), "g", GREEN, SMALL)
    terminator = polar(RADIUS, SUN + 90)
    p.line([(0, 0), terminator], ORANGE, THIN, dash=True)
    p.line([(0, 0), polar(RADIUS, SUN - 90)], ORANGE, THIN, dash=True)
    p.text(terminator, "terminator: n·l = 0", ORANGE, SMALL, offset=(-90, -8))
    limb = polar(RADIUS, CAMERA - 90)
    p.line([polar(RADIUS, CAMERA + 90), limb], BLUE, THIN, dash=True)
    p.text(limb, "limb: n·v = 0", BLUE, SMALL, offset=(60, -8))
    
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
