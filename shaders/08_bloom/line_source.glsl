// For 08.blur_line: a workgroup's line of texels, its weights, and the shared memory to keep it in.
#include "08_bloom/step.glsl"

const int threads = 256;         // of a workgroup, and texels of the line that it blurs
const int most_kept = 2048;      // radius is at most (most_kept - threads) / 2
// 24 KiB: Vulkan promises 16, desktop drivers give 32 and more. A float each, red, green and blue apart: neighbours then
// lie in different banks.
shared float line[3][most_kept];

void keep_texel(int slot, vec3 value) { line[0][slot] = value.r, line[1][slot] = value.g, line[2][slot] = value.b; }
vec3 kept_texel(int slot) { return vec3(line[0][slot], line[1][slot], line[2][slot]); }

#ifdef COUNTED
// For checks: a line whose texels are known, and how often each was read.
layout(scalar) buffer CountBuffer { uint check_counts[]; };
uniform sampler2D check_known;
int check_base;
vec3 texel(int i) {
    atomicAdd(check_counts[clamp(i - check_base + COUNTED, 0, check_counts.length() - 1)], 1u);
    return texelFetch(check_known, ivec2(i + 1024, 0), 0).rgb;
}
float weight_at(int distance) { return 1.0 / float(1 + distance); }
#else
layout(scalar) readonly buffer TapBuffer { vec2 taps[]; };
int line_number;

// The i-th texel of this workgroup's line, in front of it and behind it too: slow, from the image.
vec3 texel(int i) {
    vec2 along = vec2(step_now.direction);
    return read((float(i) + 0.5) * along + (float(line_number) + 0.5) * along.yx);
}

// That of the neighbours so many texels to either side.
float weight_at(int distance) { return taps[step_now.first_tap + distance].y; }
#endif
