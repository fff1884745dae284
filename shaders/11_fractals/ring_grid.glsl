// A flat grid of rings around a middle, each of cells twice as large as the one within.

// Position of a vertex in cells of the innermost ring, from the middle. A ring's outer edge has twice as many
// vertices as the ring around it. The extra ones move onto their neighbours: the remaining triangles close without a
// crack. `cells` along a side of each ring: a multiple of 4.
ivec2 ring_place(ivec2 vertex, int ring, int cells, int rings, bool stitch) {
    if (stitch && ring + 1 < rings) {
        if (vertex.x == 0 || vertex.x == cells) vertex.y &= ~1;
        if (vertex.y == 0 || vertex.y == cells) vertex.x &= ~1;
    }
    return (vertex - cells / 2) * (1 << ring);
}
