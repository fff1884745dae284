// right
vec3 light_clip_position(mat4 to_clip, vec3 position) {
    vec4 c = to_clip * vec4(position, 1.0);
    return c.w > 0.0 ? vec3((c.xy / c.w + 1.0) / 2.0, c.z / c.w) : vec3(-1.0, -1.0, -1.0);
}
