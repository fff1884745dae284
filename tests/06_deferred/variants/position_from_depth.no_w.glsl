// wrong: expected (
vec3 position_from_depth(uvec2 pixel, float depth, vec2 size, mat4 clip_to_world) {
    return (clip_to_world * vec4(2.0 * (vec2(pixel) + 0.5) / size - 1.0, depth, 1.0)).xyz;
}
