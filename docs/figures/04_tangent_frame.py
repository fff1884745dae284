"""A triangle in texture space and in the world: tangent and bitangent are the images of u and v.

python3 docs/figures/04_tangent_frame.py writes docs/images/04_tangent_frame.svg.
"""

from drawing import BLUE, GREY, INK, NORMAL, ORANGE, PALE_BLUE, PALE_GREY, RED, SMALL, THIN, Drawing, between

A, B, C = (0.18, 0.2), (0.88, 0.34), (0.34, 0.86)  # the corners' u and v
T, BITANGENT, AT = (250.0, 70.0), (-95.0, 190.0), (95.0, 60.0)  # dP/du, dP/dv and the corner a, on the page


def world(uv):
    u, v = uv[0] - A[0], uv[1] - A[1]
    return AT[0] + u * T[0] + v * BITANGENT[0], AT[1] + u * T[1] + v * BITANGENT[1]


def draw() -> Drawing:
    drawing = Drawing(900, 400, "Left: a triangle on a texture, with axes u and v. Right: the same triangle in the world with its edges "
                                "e1 and e2, the tangent T along which u grows, the bitangent B along which v grows, and the normal N")
    p = drawing.panel((70, 55), 265)
    p.box((0, 0), (1, 1), GREY, THIN, fill="#ffffff")
    p.line([A, B, C], INK, closed=True, fill=PALE_BLUE)
    p.arrow((0, 0), (1.13, 0), RED, "u", offset=(16, 0))
    p.arrow((0, 0), (0, 1.13), BLUE, "v", offset=(0, 14))
    for corner, name, offset in ((A, "a", (-12, -12)), (B, "b", (16, 0)), (C, "c", (0, 18))):
        p.dot(corner, label=name, offset=offset)
    p.line([A, (B[0], A[1]), B], ORANGE, THIN, dash=True)
    p.text(((A[0] + B[0]) / 2, A[1]), "Δu_{1}", ORANGE, SMALL, offset=(0, -15))
    p.text((B[0], (A[1] + B[1]) / 2), "Δv_{1}", ORANGE, SMALL, anchor="start", offset=(36, -4))
    q = drawing.panel((466, 20), 1.28)
    a, b, c = world(A), world(B), world(C)
    q.line([world((-0.1, 0)), world((1.02, 0)), world((1.02, 1.02)), world((-0.1, 1.02))], None, fill=PALE_GREY)
    q.line([a, b, c], INK, closed=True, fill=PALE_BLUE)
    q.arrow(a, b, ORANGE, "*e*_{1}", at=0.62, offset=(-6, 18))
    q.arrow(a, c, ORANGE, "*e*_{2}", at=0.75, offset=(24, 6))
    q.arrow(a, (a[0] + 0.52 * T[0], a[1] + 0.52 * T[1]), RED, "*T*", offset=(10, -18))
    q.arrow(a, (a[0] + 0.55 * BITANGENT[0], a[1] + 0.55 * BITANGENT[1]), BLUE, "*B*", offset=(-18, 0))
    q.arrow(a, (a[0] + 34, a[1] + 158), NORMAL, "*N*", offset=(0, 16))
    for corner, name, offset in ((a, "a", (-8, -18)), (b, "b", (16, 0)), (c, "c", (-4, 18))):
        q.dot(corner, label=name, offset=offset)
    q.text(between(a, b, 0.5), "u grows along *T*, v along *B*", INK, SMALL, offset=(30, -95))
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
