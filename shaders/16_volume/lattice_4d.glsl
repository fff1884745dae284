// Random numbers at whole coordinates of four dimensions, by integers alone: the same on every device, and far from 0.

// -1 to 1 (M. Jarzynski and M. Olano, Hash functions for GPU rendering, JCGT 9(3), 2020: pcg4d).
float lattice_4d(ivec4 cell) {
    uvec4 v = uvec4(cell) * 1664525u + 1013904223u;
    v += v.yzxy * v.wxyz;
    v ^= v >> 16u;
    v += v.yzxy * v.wxyz;
    return float(v.x >> 8u) * (2.0 / 16777215.0) - 1.0;
}
