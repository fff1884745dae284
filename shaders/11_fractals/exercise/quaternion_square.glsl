// Exercise 11.quaternion_square: the square of a quaternion, the repeated step of a Julia set.
// Starter: nothing is squared: the set is a ball.

// [quaternion_square]
// Returns the square of the quaternion q = x + y i + z j + w k. The units multiply as i
// i = j j = k k = -1, i j = k = -j i, j k = i = -k j and k i = j = -i k. The sixteen
// products of the general formula are not needed: some of them cancel, others are
// equal.
// [/quaternion_square]
vec4 quaternion_square(vec4 q) {
    return q;
}
