"""Index triples of an OBJ file become vertices: equal triples are one vertex.

python3 docs/figures/01_weld.py writes docs/images/01_weld.svg.
"""

from drawing import BLUE, GREEN, GREY, ORANGE, PALE_BLUE, PALE_GREEN, PALE_ORANGE, SMALL, THIN, Drawing

# Two faces that share an edge along which the normal breaks: the second corner of each is the same triple in neither.
CORNERS = ["1/1/1", "2/2/1", "3/3/1", "3/3/1", "2/2/1", "4/4/1", "4/4/2", "2/2/2", "5/5/2"]


def draw() -> Drawing:
    drawing = Drawing(900, 380, "Corners of three faces, each an index triple, and the vertices they become: equal triples "
                                "share a vertex, triples that differ in the normal alone do not")
    p = drawing.panel()
    vertices = list(dict.fromkeys(CORNERS))
    where = {triple: 62 + 118 * i for i, triple in enumerate(vertices)}
    p.text((30, 350), "file: corners  v/vt/vn", anchor="start", bold=True)
    p.text((30, 26), "GPU: vertices, and indices to them", anchor="start", bold=True)
    for i, triple in enumerate(CORNERS):
        face = i // 3
        x = 95 + 84 * i + 22 * face
        color, fill = ((BLUE, PALE_BLUE), (GREEN, PALE_GREEN), (ORANGE, PALE_ORANGE))[face]
        p.arrow((x, 262), (where[triple] + 51, 142), color, width=THIN)
        p.box((x - 40, 262), (x + 40, 300), color, THIN, fill=fill)
        p.text((x, 281), triple, color, SMALL, rim=False)
        if i % 3 == 1:
            p.text((x, 320), f"face {face + 1}", color, SMALL)
    for i, triple in enumerate(vertices):
        left = where[triple]
        p.box((left, 100), (left + 102, 142), width=THIN, fill="#ffffff")
        p.text((left + 51, 121), triple, size=SMALL, rim=False)
        p.text((left + 51, 72), f"vertex {i}", GREY, SMALL)
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
