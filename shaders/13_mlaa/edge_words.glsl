// Edges, one bit each: a word holds sixteen pixels of a row, or of a column. In a row's word the low half are the
// edges below its pixels, the high half those on their right; in a column's word the low half are the edges on the
// right, the high half those below. The low half forms lines in that direction, the high half crosses them.
const int word_pixels = 16;
uniform usampler2D edge_rows, edge_columns;

ivec2 picture_size() { return ivec2(textureSize(edge_columns, 0).x, textureSize(edge_rows, 0).y); }

// The word number `tile` of a row (`horizontal`) or column. No edges outside of the picture. (Always read: no read waits for
// a comparison.)
uint edge_word(int tile, int line, bool horizontal) {
    ivec2 at = horizontal ? ivec2(tile, line) : ivec2(line, tile), size = horizontal ? textureSize(edge_rows, 0) : textureSize(edge_columns, 0);
    ivec2 inside = clamp(at, ivec2(0), size - 1);
    uint word = horizontal ? texelFetch(edge_rows, inside, 0).x : texelFetch(edge_columns, inside, 0).x;
    return at == inside ? word : 0u;
}

// Between the pixel and the one below it, or on its right.
bool edge_below(ivec2 pixel) { return (edge_word(pixel.x >> 4, pixel.y, true) >> (pixel.x & 15) & 1u) != 0u; }
bool edge_right(ivec2 pixel) { return (edge_word(pixel.x >> 4, pixel.y, true) >> (pixel.x & 15) + 16 & 1u) != 0u; }

// Both in one read: below, right.
bvec2 edges_of(ivec2 pixel) {
    uint word = edge_word(pixel.x >> 4, pixel.y, true) >> (pixel.x & 15);
    return bvec2((word & 1u) != 0u, (word & 0x10000u) != 0u);
}
