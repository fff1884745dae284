"""The two processors, their memories, and the contents of the GPU's.

python3 docs/figures/00_memory.py writes docs/images/00_memory.svg.
"""

from drawing import BLUE, GREEN, GREY, INK, ORANGE, PALE_BLUE, PALE_GREEN, PALE_GREY, PALE_ORANGE, SMALL, THIN, Drawing


def draw() -> Drawing:
    drawing = Drawing(1000, 400, "The CPU records commands into a command buffer and submits it to a queue; the GPU executes it. Vertex "
                                 "buffers, uniforms, textures and render targets lie in the GPU's memory")
    p = drawing.panel()

    def box(x, y, wide, high, text, fill, color=INK, size=SMALL):
        p.box((x, y), (x + wide, y + high), color, THIN, fill=fill)
        p.text((x + wide / 2, y + high / 2), text, color, size, rim=False)

    box(30, 240, 190, 110, "CPU\nyour C++", PALE_GREY, size=22)
    box(760, 240, 210, 110, "GPU\nyour shaders", PALE_GREEN, GREEN, 22)
    p.text((490, 375), "command buffer", INK)
    for i, text in enumerate(("bind pipeline", "draw", "barrier", "dispatch")):
        box(300 + 95 * i, 270, 95, 54, text.replace(" ", "\n"), PALE_BLUE, BLUE, 18)
    p.arrow((222, 297), (296, 297), INK)
    p.arrow((682, 297), (756, 297), INK)
    p.text((258, 330), "record", GREY, SMALL)
    p.text((718, 330), "submit", GREY, SMALL)
    p.box((300, 30), (970, 175), GREEN, THIN, dash=True)
    p.text((635, 200), "the GPU's memory", GREEN, SMALL)
    box(320, 60, 140, 80, "buffer:\nvertices", "#ffffff")
    box(480, 60, 140, 80, "buffer:\nuniforms", "#ffffff")
    box(640, 60, 140, 80, "image:\na texture", "#ffffff")
    box(800, 60, 150, 80, "image:\nthe target", PALE_ORANGE, ORANGE)
    box(30, 60, 190, 80, "staging buffer", "#ffffff")
    p.arrow((125, 236), (125, 144), INK)
    p.text((138, 190), "write", GREY, SMALL, anchor="start")
    p.arrow((222, 100), (316, 100), INK)
    p.text((262, 124), "copy", GREY, SMALL)
    p.arrow((865, 236), (865, 179), INK, both=True)
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
