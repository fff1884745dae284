// Separable blur of moments, one direction; the first pass computes moments from depths. BLUR_BY: each invocation reads
// all its taps, or a workgroup shares them.
#include "05_shadow_maps/shadow.glsl"
#include "05_shadow_maps/moments.glsl"
#include "05_shadow_maps/blur.h"

const int along = 64, lines = 4;
layout(local_size_x = along * lines) in;

layout(scalar) uniform BlurBlock { Blur blur; };
uniform sampler2D source;
writeonly uniform image2D result;

// Texel n of a line along u (first pass) or v (second).
ivec2 texel_of(int n, int line) {
#if PASS == 0
    return ivec2(n, line);
#else
    return ivec2(line, n);
#endif
}

vec4 moments_at(int n, int line) {
    int size = textureSize(source, 0).x;
    vec4 texel = texelFetch(source, texel_of(clamp(n, 0, size - 1), min(line, size - 1)), 0);
#if PASS == 0
    return moments_of(linear_depth(shadow_views[blur.view], texel.r), blur.exponent, blur.exponent_negative);
#else
    return texel;
#endif
}

#if SHADOW_BLUR_BY == SHADOW_BLUR_BY_SHARED
shared vec4 read_once[lines][along + 2 * WIDEST_BLUR];
#endif

void main() {
    int radius = blur.radius, at = int(gl_LocalInvocationIndex);
#if PASS == 0
    ivec2 inside = ivec2(at % along, at / along);  // adjacent invocations read adjacent memory
#else
    ivec2 inside = ivec2(at / lines, at % lines);
#endif
    int first = int(gl_WorkGroupID.x) * along, n = first + inside.x, line = int(gl_WorkGroupID.y) * lines + inside.y;
#if SHADOW_BLUR_BY == SHADOW_BLUR_BY_SHARED
    // [read_once]
    for (int i = inside.x; i < along + 2 * radius; i += along) read_once[inside.y][i] = moments_at(first + i - radius, line);
    barrier();  // before other invocations read
    // [/read_once]
#endif
    vec4 sum = vec4(0.0);
    for (int offset = -radius; offset <= radius; ++offset) {
#if SHADOW_BLUR_BY == SHADOW_BLUR_BY_SHARED
        sum += blur.weights[abs(offset)] * read_once[inside.y][inside.x + radius + offset];
#else
        sum += blur.weights[abs(offset)] * moments_at(n + offset, line);
#endif
    }
    if (all(lessThan(texel_of(n, line), imageSize(result)))) imageStore(result, texel_of(n, line), sum);
}
