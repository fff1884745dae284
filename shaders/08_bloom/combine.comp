// The picture with its bloom, in place.
#define DISPATCH_ACCESS readonly
#include "08_bloom/combine.glsl"
#include "08_bloom/dispatches.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

layout(scalar) uniform BloomBlock { float strength; } bloom;
uniform sampler2D spread;
layout(rgba16f) uniform image2D hdr;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(hdr)))) return;
    vec4 before = imageLoad(hdr, pixel);
    // Where no blur ran, its result holds anything.
    vec3 light = dispatches[spreads_at()] != 0u ? texelFetch(spread, pixel, 0).rgb : vec3(0.0);
    bool mixes = BLOOM_COMPOSE == BLOOM_COMPOSE_MIX;
    imageStore(hdr, pixel, vec4(combine(before.rgb, light, mixes ? min(bloom.strength, 1.0) : bloom.strength, mixes), before.a));
}
