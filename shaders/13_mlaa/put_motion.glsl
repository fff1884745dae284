// A motion vector: pixels to where a surface was in the frame before, where it is the one that is seen.
uniform sampler2D depth;
layout(location = 0) out vec4 moved_since;  // a: how much of its light has stayed

const float same_depth = 1e-3;  // relative: two vertex shaders round differently

// Both without the shift within a pixel. `size`: of the picture.
void put_motion(vec4 clip_now, vec4 clip_before, vec2 size) {
    float seen = texelFetch(depth, ivec2(gl_FragCoord.xy), 0).r;
    if (abs(gl_FragCoord.z - seen) > same_depth * seen || clip_before.w <= 0.0) discard;
    vec2 pixels = 0.5 * size * (clip_before.xy / clip_before.w - clip_now.xy / clip_now.w);
    moved_since = vec4(pixels, clip_before.w, 1.0);
}
