// Exercise 06.decode_normal: a direction from its octahedral code.
// Starter: every surface faces +z.

// [decode_normal]
// The unit vector from which encode_normal() made `code`, which is in [-1, 1]. The z of the
// octahedron is 1 - |x| - |y|. If it is negative, the code lies in a corner of the square:
// fold x and y as encode_normal() does. Then make the vector unit length. The code may have
// been rounded; the result has unit length all the same.
// [/decode_normal]
vec3 decode_normal(vec2 code) {
    return vec3(0.0, 0.0, 1.0);
}
