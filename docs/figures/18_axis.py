"""The mouse's ray and an axis of the gizmo, the closest points of both, and the angle between them.

python3 docs/figures/18_axis.py writes docs/images/18_axis.svg.
"""

from drawing import BLUE, GREEN, GREY, INK, ORANGE, SMALL, THIN, Drawing


def draw() -> Drawing:
    drawing = Drawing(860, 420, "The eye's ray through the mouse passes an axis of the gizmo; the closest points of both lines are "
                                "joined by a line that is perpendicular to both")
    p = drawing.panel((80, 80), 100)
    p.eye((0.1, 2.2), -20)
    pivot, tip = (1.6, 0.2), (6.6, 1.2)
    p.arrow(pivot, tip, ORANGE, "axis a", offset=(46, 2))
    p.line([(0.3, 2.15), (6.9, 0.45)], BLUE)
    p.text((1.9, 1.74), "ray of the mouse, d", BLUE, SMALL, offset=(90, 12))
    on_ray, on_axis = (5.05, 0.927), (4.85, 0.85)
    p.line([on_ray, (4.95, 0.87)], GREEN)
    p.dot(on_axis, GREEN, "closest point: t along the axis", offset=(70, -30), size=SMALL)
    p.dot(pivot, INK, "pivot", offset=(0, -24))
    p.line([pivot, (0.3, 2.15)], GREY, THIN, dash=True)
    p.text((0.9, 1.2), "w", GREY, SMALL, offset=(-14, 6))
    p.arc((5.0, 0.89), 0.8, 165, 191, "", INK)
    p.text((2.7, 2.45), "a pixel counts 1/sin of the angle between them", INK, SMALL, anchor="start")
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
