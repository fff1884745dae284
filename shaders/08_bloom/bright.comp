// Bright pass: the light that bleeds.
#include "08_bloom/bright_pass.glsl"
#include "08_bloom/dispatches.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

layout(scalar) uniform BloomBlock { float threshold, knee; } bloom;
layout(scalar) uniform FrameNowBlock { uint frame_now; };
uniform sampler2D hdr;
layout(rgba16f) writeonly uniform image2D result;
shared bool lit;

vec3 cut(vec3 radiance) {
#if BLOOM_CUT == BLOOM_CUT_NONE
    return finite_light(radiance);
#elif BLOOM_CUT == BLOOM_CUT_HARD
    vec3 light = finite_light(radiance);
    return luminance(light) > bloom.threshold ? light : vec3(0.0);
#else
    return bright_pass(radiance, bloom.threshold, bloom.knee);
#endif
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    bool inside = all(lessThan(pixel, imageSize(result)));
    if (gl_LocalInvocationIndex == 0u) lit = false;
    barrier();
    vec3 bright = inside ? cut(texelFetch(hdr, pixel, 0).rgb) : vec3(0.0);
    if (any(greaterThan(bright, vec3(0.0)))) lit = true;
    if (inside) imageStore(result, pixel, vec4(bright, 1.0));
    barrier();
    if (gl_LocalInvocationIndex == 0u && lit) dispatches[lit_at()] = frame_now;  // all writers store the same value
}
