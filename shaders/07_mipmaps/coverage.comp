// Coverage kept down the levels, in three steps. STEP 0 counts a level's texels by alpha, 1 finds each level's factor, 2
// multiplies a level's alpha by it.
#include "07_mipmaps/keep_coverage.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

layout(scalar) buffer FactorBuffer { float factors[]; };  // of each level of each layer
layout(scalar) uniform CoverageBlock {
    int level, levels;
    float cutoff;
} coverage;

#if STEP == 1
// The share that reaches the cutoff in the first level, in texels of this one.
void main() {
    if (gl_LocalInvocationIndex > 0) return;
    int level = int(gl_WorkGroupID.x), layer = int(gl_WorkGroupID.y);
    float kept = 0.0, all = 0.0, here = 0.0;
    counted = layer * coverage.levels;
    for (int code = 0; code < 256; ++code) {
        all += float(texels_with(code));
        if (float(code) / 255.0 >= coverage.cutoff) kept += float(texels_with(code));
    }
    counted += level;
    for (int code = 0; code < 256; ++code) here += float(texels_with(code));
    factors[counted] = level == 0 ? 1.0 : keep_coverage(kept / all * here, coverage.cutoff);
}
#else
#if STEP == 0
uniform sampler2DArray source;
shared uint bins[256];
#else
#ifndef RESULT_FORMAT
#define RESULT_FORMAT rgba8
#endif
layout(RESULT_FORMAT) uniform image2DArray result;
#endif

void main() {
    ivec3 at = ivec3(gl_GlobalInvocationID);
    counted = at.z * coverage.levels + coverage.level;
#if STEP == 0
    bool inside = all(lessThan(at.xy, textureSize(source, 0).xy));
    vec4 texel = texelFetch(source, inside ? at : ivec3(0), 0);
    bins[gl_LocalInvocationIndex] = 0u;
    barrier();
    if (inside) atomicAdd(bins[int(round(255.0 * clamp(texel.a, 0.0, 1.0)))], 1u);
    barrier();
    uint count = bins[gl_LocalInvocationIndex];
    if (count > 0u) atomicAdd(alpha_count[256 * counted + int(gl_LocalInvocationIndex)], count);
#else
    if (any(greaterThanEqual(at.xy, imageSize(result).xy))) return;
    vec4 texel = imageLoad(result, at);
    imageStore(result, at, vec4(texel.rgb, min(texel.a * factors[counted], 1.0)));
#endif
}
#endif
