// Solution of 13.reproject.
vec3 reproject(vec2 at, float depth, vec2 size, mat4 to_before) {
    vec4 clip = to_before * vec4(2.0 * at / size - 1.0, depth, 1.0);
    if (clip.w <= 0.0) return vec3(0.0);
    return vec3((0.5 * clip.xy / clip.w + 0.5) * size, clip.w);
}
