// Solution of 06.screen_box.

ScreenBox screen_box(vec3 center, vec3 half_size, mat4 to_clip, vec2 size) {
    ScreenBox box = ScreenBox(vec2(1e30), vec2(-1e30), 0.0);
    for (int i = 0; i < 8; ++i) {
        vec3 side = vec3(i & 1, i >> 1 & 1, i >> 2) * 2.0 - 1.0;
        vec4 clip = to_clip * vec4(center + side * half_size, 1.0);
        if (clip.z > clip.w) return ScreenBox(vec2(0.0), size, 1.0);  // nearer than the near plane
        vec2 at = (0.5 + 0.5 * clip.xy / clip.w) * size;
        box.low = min(box.low, at);
        box.high = max(box.high, at);
        box.nearest = max(box.nearest, clip.z / clip.w);
    }
    return box;
}
