// right
vec3 position_from_depth(uvec2 pixel, float depth, vec2 size, mat4 clip_to_world) {
    vec2 share = (vec2(pixel) + vec2(0.5)) / size;
    vec4 p = clip_to_world[0] * mix(-1.0, 1.0, share.x) + clip_to_world[1] * mix(-1.0, 1.0, share.y) +
             clip_to_world[2] * depth + clip_to_world[3];
    return p.xyz * (1.0 / p.w);
}
