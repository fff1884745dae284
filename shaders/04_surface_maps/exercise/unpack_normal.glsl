// Exercise 04.unpack_normal: a unit normal from the two channels of a texel.
// Starter: every texel is flat.

// [unpack_normal]
// The unit normal in tangent space. `code` holds its x and y, with 0 to 1 standing for -1
// to 1. z, 0 or more, follows from the unit length; in a filtered or damaged texel x and y
// can be too long for any z, and then z is 0. Then `strength`, 0 or more, scales the slope:
// multiply x and y by it, and make the vector unit length again. If no length is left
// (strength 0 and z 0), the result is (0, 0, 1).
// [/unpack_normal]
vec3 unpack_normal(vec2 code, float strength) {
    return vec3(0.0, 0.0, 1.0);
}
