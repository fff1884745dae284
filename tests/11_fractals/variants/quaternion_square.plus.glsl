// wrong: expected (-1, 0, 0, 0)
vec4 quaternion_square(vec4 q) {
    // Of the product's three cross products one is v x v = 0, and the two others add up.
    return vec4(q.x * q.x + dot(q.yzw, q.yzw), 2.0 * q.x * q.yzw);
}
