// right, in its pictures too
// M. Jarzynski and M. Olano, Hash Functions for GPU Rendering, 2020: pcg3d.
float film_grain(uvec2 pixel, uint frame) {
    uvec3 v = uvec3(pixel, frame) * 1664525u + 1013904223u;
    v.x += v.y * v.z; v.y += v.z * v.x; v.z += v.x * v.y;
    v ^= v >> 16u;
    v.x += v.y * v.z; v.y += v.z * v.x; v.z += v.x * v.y;
    return float(v.x >> 8u) * (2.0 / 16777216.0) - 1.0;
}
