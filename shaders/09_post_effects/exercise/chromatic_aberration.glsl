// Exercise 09.chromatic_aberration: a lens that enlarges red more than blue.
// Until you fill it in, it is a perfect lens.

// [chromatic_aberration]
// Where, in uv from 0 to 1, a channel of the pixel at uv is read: at middle + (uv - middle) * (1 + shift * r^2). r is the distance
// from the middle, (0.5, 0.5), over that of a corner, both in uv, and shift is -0.2 to 0.2. Above 0 that reaches out of the picture,
// where there is nothing to read. So for a shift above 0 the whole is brought inside: all vectors from the middle shrink by one
// factor, such that a corner is read at the corner again. A shift of 0 or less stays as it is.
//
// The middle itself has no direction. It needs none.
// [/chromatic_aberration]
vec2 aberrated(vec2 uv, float shift) {
    return uv;
}
