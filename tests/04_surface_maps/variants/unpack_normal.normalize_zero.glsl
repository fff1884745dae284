// wrong: normalizes a vector of length 0
vec3 unpack_normal(vec2 code, float strength) {
    vec2 xy = code * 2.0 - 1.0;
    return normalize(vec3(strength * xy, sqrt(max(1.0 - dot(xy, xy), 0.0))));
}
