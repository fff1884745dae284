// wrong: expected (-1, 0, 0, 0)
vec4 quaternion_square(vec4 q) { return q * q; }
