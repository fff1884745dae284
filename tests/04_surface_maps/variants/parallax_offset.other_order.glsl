// right
vec2 parallax_offset(float depth, vec3 to_eye, vec2 deepest) {
    return to_eye.xy / to_eye.z * deepest * depth * -1.0;
}

vec2 parallax_offset_limited(float depth, vec3 to_eye, vec2 deepest) {
    return -depth * deepest * to_eye.xy;
}
