#!/usr/bin/env python3
"""Writes a large OBJ file for --load-bench: a displaced grid of quadrilaterals with uvs and normals.

make_big_obj.py SIZE_MB OUT      104 gives 640 000 v, vt and vn and 638 401 f v/vt/vn, six decimals each
"""
import math
import sys


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    side = max(2, round(800 * math.sqrt(float(sys.argv[1]) / 104)))
    with open(sys.argv[2], "w") as out:
        out.write("# displaced grid, %d x %d vertices\no grid\n" % (side, side))
        frequency, height, size = 0.13, 1.7, 100.0
        for j in range(side):
            for i in range(side):
                x, z = size * (i / (side - 1) - 0.5), size * (j / (side - 1) - 0.5)
                y = height * math.sin(frequency * x) * math.cos(frequency * 1.3 * z) + 0.01 * math.sin(12.9898 * i + 78.233 * j)
                out.write("v %.6f %.6f %.6f\n" % (x, y, z))
        for j in range(side):
            out.write("".join("vt %.6f %.6f\n" % (i / (side - 1), j / (side - 1)) for i in range(side)))
        for j in range(side):
            for i in range(side):
                x, z = size * (i / (side - 1) - 0.5), size * (j / (side - 1) - 0.5)
                dx = height * frequency * math.cos(frequency * x) * math.cos(frequency * 1.3 * z)
                dz = -height * frequency * 1.3 * math.sin(frequency * x) * math.sin(frequency * 1.3 * z)
                length = math.sqrt(dx * dx + 1 + dz * dz)
                out.write("vn %.6f %.6f %.6f\n" % (-dx / length, 1 / length, -dz / length))
        for j in range(side - 1):
            row = []
            for i in range(side - 1):
                a = j * side + i + 1
                corners = (a, a + side, a + side + 1, a + 1)
                row.append("f " + " ".join("%d/%d/%d" % (c, c, c) for c in corners) + "\n")
            out.write("".join(row))


main()
