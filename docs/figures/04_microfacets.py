"""A rough surface as mirrors: one that faces the half vector, one hidden from the camera, one hidden from the light.

python3 docs/figures/04_microfacets.py writes docs/images/04_microfacets.svg.
"""

from drawing import EYE, GREY, HALF, INK, LIGHT, NORMAL, PALE_BLUE, SMALL, SURFACE, THIN, Drawing, polar

PROFILE = [(-2.7, 0.25), (-2.35, 0.1), (-1.95, 0.3), (-1.5, 0.03), (-1.05, 0.66), (-0.6, 0.02), (-0.25, 0.22), (0.25, 0.32), (0.6, 0.02),
           (1.05, 0.66), (1.5, 0.03), (1.95, 0.3), (2.35, 0.1), (2.7, 0.25)]
TO_LIGHT, TO_EYE = 128, 52
FACET = (0.0, 0.27)


def draw() -> Drawing:
    drawing = Drawing(900, 400, "Microfacets: the mirror whose normal is the half vector sends the light to the camera; neighbours hide other "
                                "mirrors from the light or from the camera")
    p = drawing.panel((450, 60), 155)
    p.line([*PROFILE, (2.7, -0.25), (-2.7, -0.25)], None, fill=SURFACE)
    p.line(PROFILE, INK)
    p.line(PROFILE[6:8], HALF, 7)
    p.arrow(FACET, (0, 1.75), NORMAL, "*N*")
    p.arrow(polar(1.75, TO_LIGHT, FACET), FACET, LIGHT)
    p.text(polar(1.75, TO_LIGHT, FACET), "light, *L*", LIGHT, SMALL, offset=(-48, 4))
    p.arrow(FACET, polar(1.75, TO_EYE, FACET), EYE)
    p.text(polar(1.75, TO_EYE, FACET), "camera, *V*", EYE, SMALL, offset=(62, 4))
    p.arrow(FACET, polar(1.15, 101, FACET), HALF, "*H*", offset=(-14, 6))
    # The light is on the left, so the right side of a steep peak is dark; the camera is on the right.
    for side, color, name in ((1, LIGHT, "hidden from the light:\n*shadowing*"), (-1, EYE, "hidden from the camera:\n*masking*")):
        p.line([(side * 1.05, 0.66), (side * 1.5, 0.03)], PALE_BLUE, 8)
        p.line([(side * 1.05, 0.66), (side * 1.5, 0.03)], GREY, THIN)
        p.line([(side * 1.28, 0.4), (side * 1.28 - side * 0.62, 0.4 + 0.79)], color, THIN, dash=True)
        p.text((side * 1.75, 0.98), name, GREY, SMALL)
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
