"""A probe's cube is looked up along the way from its own middle to the wall, not along the reflected ray.

python3 docs/figures/14_box.py writes docs/images/14_box.svg.
"""

from drawing import BLUE, GREEN, GREY, INK, PALE_GREY, RED, SMALL, Drawing


def draw() -> Drawing:
    drawing = Drawing(900, 430, "A room from above, with a probe in its middle and a mirror to the left. The reflected ray meets the right "
                                "wall; from the probe the same place lies in another direction than the ray's")
    p = drawing.panel((450, 205), 165)
    p.box((-2, -1.1), (2, 1.1), INK, 4, fill=PALE_GREY)
    place, hit = (-1.2, -0.6), (2.0, 0.75)
    p.line([(-1.5, -0.75), (-0.9, -0.75)], GREY, 5)
    place = (-1.2, -0.75)
    p.arrow(place, hit, RED, "")
    p.arrow((0, 0.1), hit, GREEN, "")
    slope = (hit[1] - place[1]) / (hit[0] - place[0])
    p.arrow((0, 0.1), (1.6, 0.1 + 1.6 * slope), BLUE, "", dash=True)
    p.dot((0, 0.1), INK)
    p.dot(place, INK)
    p.dot(hit, INK)
    p.text((0, 0.1), "center", INK, SMALL, offset=(-40, 18))
    p.text(place, "position", INK, SMALL, offset=(0, -26))
    p.text((0.4, -0.08), "direction", RED, SMALL, offset=(20, -32))
    p.text((1.0, 0.42), "box_project", GREEN, SMALL, offset=(-60, 34))
    p.text((1.6, 0.1 + 1.6 * slope), "without it", BLUE, SMALL, offset=(-30, 34))
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
