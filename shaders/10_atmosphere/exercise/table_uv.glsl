// Exercise 10.table_uv: where in a table the transmittance of a way out of the air is kept.
// Until you fill it in, its rows are heights and its columns slopes, and half of it is never used.

// [table_uv]
// A table of size.x by size.y texels, read with a linear filter, keeps what of light gets through the air, from the height
// `height` (0 to top) along a ray with the slope `slope` (the cosine of the angle with straight up) out of it. Only rays that
// miss the ground are asked for. The table is best used like this: with level(h) = sqrt(h (2 radius + h)), how far it is
// from h down to the horizon, a row stands for level(height) / level(top), from 0 to 1; a column for how long the way out
// is, from top - height, straight up, which is 0, to level(height) + level(top), which is 1. 0 must fall on the middle of
// the first texel and 1 on the middle of the last: between a table's edge and the texel's middle there is nothing to
// filter with. table_uv gives the texture coordinates of a ray; table_place is its inverse: (height, slope) of texture
// coordinates. At the top, straight up, the way is 0 long: a slope of 1. Metres; at the radius of a planet a float has no
// digits for a difference of squares.
// [/table_uv]
vec2 table_uv(float height, float slope, float radius, float top, vec2 size) {
    return vec2(0.5 + 0.5 * slope, height / top);
}

vec2 table_place(vec2 uv, float radius, float top, vec2 size) {
    return vec2(uv.y * top, 2.0 * uv.x - 1.0);
}
