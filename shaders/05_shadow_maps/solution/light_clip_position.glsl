// Solution of 05.light_clip_position.

vec3 light_clip_position(mat4 to_clip, vec3 position) {
    vec4 clip = to_clip * vec4(position, 1.0);
    if (clip.w <= 0.0) return vec3(-1.0);  // the division would mirror it to the front
    return vec3(0.5 + 0.5 * clip.xy / clip.w, clip.z / clip.w);
}
