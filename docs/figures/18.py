"""Diagrams of chapter 18's lessons: python3 docs/figures/draw.py draws them."""

from drawing import BLUE, GREEN, GREY, INK, ORANGE, PALE_ORANGE, RED, SMALL, THIN, Drawing, figure


@figure("18_axis", 860, 420,
        "The eye's ray through the mouse passes an axis of the gizmo; the closest points of both lines are joined by a line "
        "that is perpendicular to both")
def draw_axis(drawing: Drawing):
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


NODES = {"scene": (3.2, 3.0), "table": (1.2, 2.0), "lamps": (5.2, 2.0), "leg": (0.4, 1.0), "vase": (2.0, 1.0), "flower": (2.0, 0.0)}
LINKS = [("scene", "table"), ("scene", "lamps"), ("table", "leg"), ("table", "vase"), ("vase", "flower")]
CHOSEN = {"vase", "flower"}


@figure("18_tree", 860, 430,
        "A tree: scene, table with leg and vase, a flower below the vase, lamps. Vase and flower are selected: the vase moves "
        "to the lamps, the flower goes with it; the flower cannot become the vase's parent")
def draw_tree(drawing: Drawing):
    p = drawing.panel((170, 60), 100)
    for upper, lower in LINKS:
        p.line([NODES[upper], NODES[lower]], GREY, THIN)
    for name, at in NODES.items():
        p.circle(at, 0.3, ORANGE if name in CHOSEN else INK, THIN, fill=PALE_ORANGE if name in CHOSEN else "#ffffff")
        p.text(at, name, INK, SMALL, offset=(0, 5), rim=False)
    p.arrow((2.35, 1.12), (4.86, 1.9), GREEN, "moved", offset=(-120, -4), size=SMALL)
    p.text(NODES["flower"], "selected, and goes along", BLUE, SMALL, anchor="start", offset=(44, 5))
    p.arrow((1.72, 0.86), (1.72, 0.14), RED)
    p.text((1.6, 0.45), "refused: a circle", RED, SMALL, anchor="end", offset=(-6, 5))
