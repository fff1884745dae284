// The Gaussians, each with its share of red, green and blue.
#include "12_skin/profile.h"

layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2D levels[6];
layout(scalar) uniform SkinSumBlock { SkinSum sum_of; };
layout(rgba16f) writeonly uniform image2D result;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, imageSize(result)))) return;
    vec4 first = texelFetch(levels[0], texel, 0);
    vec3 sum = sum_of.weight[0] * first.rgb;
    if (first.a > 0.0) {
        if (sum_of.count > 1u) sum += sum_of.weight[1] * texelFetch(levels[1], texel, 0).rgb;
        if (sum_of.count > 2u) sum += sum_of.weight[2] * texelFetch(levels[2], texel, 0).rgb;
        if (sum_of.count > 3u) sum += sum_of.weight[3] * texelFetch(levels[3], texel, 0).rgb;
        if (sum_of.count > 4u) sum += sum_of.weight[4] * texelFetch(levels[4], texel, 0).rgb;
        if (sum_of.count > 5u) sum += sum_of.weight[5] * texelFetch(levels[5], texel, 0).rgb;
    }
    imageStore(result, texel, vec4(sum, first.a));
}
