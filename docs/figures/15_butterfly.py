"""Butterflies of a transform of eight values: three steps of four pairs, each a sum and a turned difference.

python3 docs/figures/15_butterfly.py writes docs/images/15_butterfly.svg.
"""

from drawing import BLUE, GREY, INK, ORANGE, SMALL, Drawing


def draw() -> Drawing:
    drawing = Drawing(900, 430, "A transform of eight amplitudes in three steps. In each step four pairs become their sum and their difference, and the "
                                "difference is turned")
    p = drawing.panel((150, 60), 1)
    columns, row = [0, 200, 400, 600], 40
    size = 8
    for step, column in enumerate(columns):
        for i in range(size):
            p.dot((column, row * (size - 1 - i)), INK, radius_px=4.5)
    for i in range(size):
        p.text((-22, row * (size - 1 - i)), f"*h*_{{{i}}}", BLUE, SMALL, anchor="end")
        p.text((622, row * (size - 1 - i)), f"*y*_{{{i}}}", ORANGE, SMALL, anchor="start")
    # Stockham's order: values a half apart meet, and their results stand beside each other, `stride` apart.
    for step in range(3):
        stride, left, right = 1 << step, columns[step], columns[step + 1]
        for j in range(size // 2):
            q, k = j & (stride - 1), j & ~(stride - 1)
            to = q + 2 * k
            for source in (j, j + size // 2):
                for target in (to, to + stride):
                    turned = target == to + stride
                    p.line([(left, row * (size - 1 - source)), (right, row * (size - 1 - target))], ORANGE if turned else BLUE,
                           2.4 if j == 0 else 1.0)
    for step in range(3):
        p.text((columns[step] + 100, row * size - 12), f"step {step + 1}", GREY, SMALL)
    p.text((300, -34), "blue: *a* + *b*    orange: (*a* − *b*) turned", INK, SMALL)
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
