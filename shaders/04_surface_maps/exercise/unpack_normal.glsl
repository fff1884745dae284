// Exercise 04.unpack_normal: from a texel's two numbers to a unit vector.
// Until you fill it in, every texel is flat.

// [unpack_normal]
// `code` holds the normal's x and y, from 0 to 1 for -1 to 1. z follows from the length, which is 1: but a filtered or
// damaged texel can have x and y too long for any z, and then z is 0. `strength`, 0 or more, then scales the slope: x and y
// times strength, and the whole made unit length again. Where nothing is left of it (strength 0 and z 0) it is (0, 0, 1).
// [/unpack_normal]
vec3 unpack_normal(vec2 code, float strength) {
    return vec3(0.0, 0.0, 1.0);
}
