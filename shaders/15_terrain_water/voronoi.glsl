// Distances to the two nearest points of a jittered grid. S. Worley, "A Cellular Texture Basis Function", SIGGRAPH 1996.

uint voronoi_hash(uvec2 cell) {
    uint n = cell.x * 73856093u ^ cell.y * 19349663u;
    n = (n ^ n >> 16) * 0x7feb352du;
    n = (n ^ n >> 15) * 0x846ca68bu;
    return n ^ n >> 16;
}

// F1 and F2 in cells; the pattern repeats after `period` cells. `reach` 1: the cell and its eight neighbours; 2: 25. Two by two
// cells (`reach` 0), those around the nearest corner, miss a nearest point now and then.
vec2 voronoi(vec2 at, int period, int reach) {
    ivec2 first = ivec2(floor(reach == 0 ? at - 0.5 : at)) - reach, last = first + (reach == 0 ? 1 : 2 * reach);
    vec2 nearest = vec2(1e9);
    for (int y = first.y; y <= last.y; ++y)
        for (int x = first.x; x <= last.x; ++x) {
            ivec2 cell = ivec2(x, y);
            uint h = voronoi_hash(uvec2((cell % period + period) % period));
            vec2 point = vec2(cell) + vec2(float(h & 0xffffu), float(h >> 16)) / 65536.0;
            float d = distance(at, point);
            if (d < nearest.x)
                nearest = vec2(d, nearest.x);
            else
                nearest.y = min(nearest.y, d);
        }
    return nearest;
}
