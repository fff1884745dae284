// Exercise 09.chromatic_aberration: a lens that enlarges red more than blue.
// Until you fill it in, it is a perfect lens.

// [chromatic_aberration]
// Where, in uv from 0 to 1, a channel of the pixel at uv is read. The lens moves what it shows along the line from the
// picture's middle by `shift` times r^2, where r is the distance from the middle over that of a corner (in uv: the middle is
// (0.5, 0.5), a corner (0, 0)): the channel is read at middle + (uv - middle) * (1 + shift * r^2), and shift is -0.2 to 0.2.
// That reaches out of the picture where shift is above 0, and there is nothing to read. So the whole is brought inside: what
// would be read at a corner is read at a corner again, whatever a shift above 0 is, and all other places shrink towards the
// middle by the same factor. A shift of 0 or less stays as it is.
//
// The middle itself has no direction. It needs none.
// [/chromatic_aberration]
vec2 aberrated(vec2 uv, float shift) {
    return uv;
}
