// wrong: decode_normal(code
vec3 decode_normal(vec2 code) { return vec3(code, sqrt(max(0.0, 1.0 - dot(code, code)))); }
