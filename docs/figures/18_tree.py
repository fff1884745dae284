"""A selection in a tree: moved entries, entries moved along, and refused parents.

python3 docs/figures/18_tree.py writes docs/images/18_tree.svg.
"""

from drawing import BLUE, GREEN, GREY, INK, ORANGE, PALE_ORANGE, RED, SMALL, THIN, Drawing

NODES = {"scene": (3.2, 3.0), "table": (1.2, 2.0), "lamps": (5.2, 2.0), "leg": (0.4, 1.0), "vase": (2.0, 1.0), "flower": (2.0, 0.0)}
LINKS = [("scene", "table"), ("scene", "lamps"), ("table", "leg"), ("table", "vase"), ("vase", "flower")]
CHOSEN = {"vase", "flower"}


def draw() -> Drawing:
    drawing = Drawing(860, 430, "A tree: scene, table with leg and vase, a flower below the vase, lamps. Vase and flower are selected: the vase "
                                "moves to the lamps, the flower goes with it; the flower cannot become the vase's parent")
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
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
