"""One frame's three problems: ground at every distance, reflection and refraction in water, glass before both.

python3 docs/figures/15_frame.py writes docs/images/15_frame.svg.
"""

from drawing import BLUE, GREEN, GREY, INK, ORANGE, PALE_BLUE, PALE_GREEN, PALE_ORANGE, PURPLE, SMALL, THIN, Drawing


def draw() -> Drawing:
    drawing = Drawing(1000, 470, "A camera above a lake: one ray meets a mountain, one is mirrored by the water and partly goes down to the bed, one "
                                 "passes two panes of glass")
    p = drawing.panel((0, 90), 50)
    bed = [(0, 0.7), (2, 0.6), (4.5, -0.6), (8, -0.9), (11, -0.3), (12.6, 0.9), (13.8, 2.6), (15, 3.4), (16.2, 5.2), (17.2, 6.1), (18.2, 5.3),
           (19, 4.9), (20, 4.6), (20, -1.8), (0, -1.8)]
    p.line(bed, None, fill=PALE_GREEN)
    p.line([(2.42, 0.4), (11.93, 0.4), (11, -0.3), (8, -0.9), (4.5, -0.6)], None, fill=PALE_BLUE)
    p.line(bed[:-2], GREEN)
    p.line([(2.42, 0.4), (11.93, 0.4)], BLUE)
    eye, met = (1.5, 4.2), (9, 0.4)
    # 1: the ground.
    p.arrow(eye, (16.2, 5.2), GREEN, width=2.4)
    p.text((10.6, 5.35), "1 ground: how fine?", GREEN, SMALL)
    # 2: the water, by the law of reflection, and by Snell's law with an index of 1.333.
    p.arrow(eye, met, BLUE, width=2.4)
    p.arrow(met, (14.95, 3.41), BLUE, width=2.4)
    p.arrow(met, (9.95, -0.6), BLUE, width=2.4)
    p.line([met, (9, 1.6)], GREY, THIN, dash=True)
    p.text((10.9, 2.35), "2 reflected", BLUE, SMALL)
    p.text((6.6, -0.2), "refracted, absorbed", BLUE, SMALL)
    # 3: two panes before the water.
    for x, color, pale in ((3.0, ORANGE, PALE_ORANGE), (4.3, PURPLE, PALE_BLUE)):
        p.box((x - 0.08, 0.75), (x + 0.08, 3.75), color, 2, fill=pale)
    p.text((3.65, 6.2), "3 glass: which pane first?", ORANGE, SMALL)
    p.arrow((3.65, 5.9), (3.65, 3.9), ORANGE, width=THIN)
    p.eye(eye, -12, 44)
    p.text((1.2, 5.0), "camera", INK, SMALL)
    p.text((17, 2.2), "15a Terrain", GREEN)
    p.text((8, -1.35), "15b Water", BLUE)
    p.text((3.65, 6.85), "15c Transparency", ORANGE)
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
