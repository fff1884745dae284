// Exercise 10.table_uv: the position of a ray in the table of transmittance.
// Starter: rows are heights and columns are slopes, and half of the table is never used.

// [table_uv]
// A table of size.x by size.y texels stores the transmittance from the height `height`
// (0 to top) along a ray of slope `slope`, the cosine of the angle with straight up, to
// the top of the air. Only rays that miss the ground occur. It is read with a linear
// filter. All lengths are in metres.
//
// Let level(h) = sqrt(h (2 radius + h)), the distance from the height h to the horizon.
// - Row: level(height) / level(top), from 0 to 1.
// - Column: the distance along the ray to the top of the air, mapped linearly. 0 stands
//   for the shortest possible distance from this height, top - height (straight up),
//   and 1 for the longest, level(height) + level(top) (past the horizon).
//
// In texture coordinates, 0 must fall on the centre of the first texel and 1 on the
// centre of the last one, because a linear filter has nothing to interpolate beyond
// these centres.
//
// table_uv returns the texture coordinates of a ray. table_place is its inverse: it
// returns (height, slope) for texture coordinates. At the top, straight up, the
// distance is 0: return a slope of 1 there. At the radius of a planet a float has no
// digits for a difference of squares; use products.
// [/table_uv]
vec2 table_uv(float height, float slope, float radius, float top, vec2 size) {
    return vec2(0.5 + 0.5 * slope, height / top);
}

vec2 table_place(vec2 uv, float radius, float top, vec2 size) {
    return vec2(uv.y * top, 2.0 * uv.x - 1.0);
}
