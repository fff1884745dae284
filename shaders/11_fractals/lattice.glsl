// Random numbers at whole coordinates, and the way from one octave of noise to the next. A place is a cell, of whole
// numbers, and where in the cell: so it is as precise after 10,000 km as after one.

// -1 to 1, the same for the same cell, on every device: integers alone, which wrap around (M. Jarzynski and M. Olano,
// Hash functions for GPU rendering, JCGT 9(3), 2020: pcg2d).
float lattice(ivec2 cell) {
    uvec2 v = uvec2(cell) * 1664525u + 1013904223u;
    v.x += v.y * 1664525u;
    v.y += v.x * 1664525u;
    v ^= v >> 16u;
    v.x += v.y * 1664525u;
    v.y += v.x * 1664525u;
    v ^= v >> 16u;
    return float(v.x >> 8u) * (2.0 / 16777215.0) - 1.0;
}

// An octave has sqrt(5) times as many cells along each axis, turned by 26.57°, that no grid shows. Whole cells stay whole.
const float lacunarity = 2.2360680;
const mat2 finer = mat2(2.0, 1.0, -1.0, 2.0);  // by columns: (x, y) becomes (2 x - y, x + 2 y)

// From a place in one octave to that in the next. The sum is so that octaves are not alike around (0, 0).
void next_octave(inout ivec2 cell, inout vec2 offset) {
    cell = ivec2(2 * cell.x - cell.y, cell.x + 2 * cell.y) + ivec2(57, 113);
    offset = finer * offset;
}

// `offset` back to 0 to 1.
void settle(inout ivec2 cell, inout vec2 offset) {
    vec2 whole = floor(offset);
    cell += ivec2(whole);
    offset -= whole;
}
