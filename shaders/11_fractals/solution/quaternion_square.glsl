// Solution of 11.quaternion_square (W. R. Hamilton, 1843).

vec4 quaternion_square(vec4 q) {
    // Of the product's three cross products one is v x v = 0, and the two others add up.
    return vec4(q.x * q.x - dot(q.yzw, q.yzw), 2.0 * q.x * q.yzw);
}
