// Exercise 11.quaternion_square: what is done again and again to find out whether a point is in a Julia set.
// Until you fill it in, nothing is done to it: the set is a ball.

// [quaternion_square]
// The quaternion q = x + y i + z j + w k, times itself. i, j and k multiply as i i = j j = k k = -1, i j = k = -j i,
// j k = i = -k j and k i = j = -i k. Sixteen products are not needed: which of them cancel, and which are equal?
// [/quaternion_square]
vec4 quaternion_square(vec4 q) {
    return q;
}
