// Exercise 06.screen_box: find the fault in the bounds of a box on the screen.
// Starter: a wall right beside the camera vanishes if something stands behind it: see the shot alley.

// [screen_box]
// Returns the rectangle of pixels that a box may cover, and the depth of its nearest point.
// The box reaches half_size from its center; metres, world space. The matrix to_clip maps to
// clip space: after the division by w, x and y are -1 to 1 across the picture of `size`
// pixels, and depth is 1 at the near plane, 0 at the far one. A corner nearer than the near
// plane, behind the camera too, has z > w in clip space; its projection means nothing. A box
// that has one may cover everything: low is then 0, high is `size`, and nearest is 1.
//
// The function below has one fault. Find it by its symptom, and mend it.
// [/screen_box]
ScreenBox screen_box(vec3 center, vec3 half_size, mat4 to_clip, vec2 size) {
    ScreenBox box = ScreenBox(vec2(1e30), vec2(-1e30), 0.0);
    for (int i = 0; i < 8; ++i) {
        vec3 side = vec3(i & 1, i >> 1 & 1, i >> 2) * 2.0 - 1.0;
        vec4 clip = to_clip * vec4(center + side * half_size, 1.0);
        if (clip.z > clip.w) continue;
        vec2 at = (0.5 + 0.5 * clip.xy / clip.w) * size;
        box.low = min(box.low, at);
        box.high = max(box.high, at);
        box.nearest = max(box.nearest, clip.z / clip.w);
    }
    return box;
}
