// Exercise 09.chromatic_aberration: a lens that enlarges each colour differently.
// Starter: the lens is perfect.

// [chromatic_aberration]
// Returns the position, in uv from 0 to 1, at which one colour channel of the pixel at
// uv is read: middle + (uv - middle) * (1 + shift * r^2). middle is (0.5, 0.5). r is
// the distance of uv from the middle divided by the distance of a corner, both in uv.
// shift is -0.2 to 0.2.
//
// A shift above 0 would read outside of the picture, where there is nothing. For a
// shift above 0, therefore, divide all vectors from the middle by one factor, chosen so
// that a corner is read exactly at that corner. For a shift of 0 or less change
// nothing.
//
// The middle itself has no direction, and the formula needs none.
// [/chromatic_aberration]
vec2 aberrated(vec2 uv, float shift) {
    return uv;
}
