"""Layers of glass along a ray: each one's transmittance, and the light that reaches the camera.

python3 docs/figures/15_layers.py writes docs/images/15_layers.svg.
"""

from drawing import BLUE, GREEN, GREY, INK, ORANGE, PALE_BLUE, PALE_GREEN, PALE_ORANGE, SMALL, THIN, Drawing

LAYERS = [(2.4, 0.5, ORANGE, PALE_ORANGE), (5.0, 0.3, GREEN, PALE_GREEN), (7.6, 0.6, BLUE, PALE_BLUE)]  # place, α


def draw() -> Drawing:
    drawing = Drawing(1000, 430, "A ray passes three panes; the transmittance falls at each pane from 1 to 0.5, 0.35 and 0.14; the share of each "
                                 "pane in the pixel is its opacity times the transmittance before it")
    p = drawing.panel((60, 265), 80)
    p.eye((0.2, 0.7), 0, 40)
    p.line([(0.5, 0.7), (10.6, 0.7)], GREY, THIN)
    for i, (x, alpha, color, pale) in enumerate(LAYERS, 1):
        p.box((x - 0.07, 0.05), (x + 0.07, 1.35), color, 2, fill=pale)
        p.text((x, 1.62), f"*c*_{{{i}}}, α_{{{i}}} = {alpha}", color, SMALL)
    p.box((10.4, 0.05), (10.7, 1.35), INK, 2, fill="#d9d7cf")
    p.text((10.45, 1.62), "background", INK, SMALL)
    q = drawing.panel((60, 70), 80)
    q.arrow((0.5, 0), (10.9, 0), GREY, "*z*", width=2)
    q.arrow((0.5, 0), (0.5, 1.75), GREY, width=2)
    q.text((0.3, 1.5), "1", GREY, SMALL)
    left, x0, share = 1.0, 0.5, []
    for x, alpha, color, _ in LAYERS:
        q.line([(x0, 1.5 * left), (x, 1.5 * left)], INK)
        q.line([(x, 1.5 * left), (x, 1.5 * left * (1 - alpha))], color, 4)
        share.append((x, left, alpha, color))
        left *= 1 - alpha
        x0 = x
    q.line([(x0, 1.5 * left), (10.7, 1.5 * left)], INK)
    for x, before, alpha, color in share:
        q.text((x, 1.5 * before * (1 - alpha / 2)), f"{before * alpha:.2f}", color, SMALL, anchor="start", offset=(12, 4))
    q.text((9.6, 1.5 * left), f"{left:.2f}", INK, SMALL, offset=(0, 16))
    q.text((1.3, 1.72), "transmittance", GREY, SMALL)
    q.text((5.6, -0.45), "each step is that layer's share of the pixel; the shares and the rest add up to 1", GREY, SMALL)
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
