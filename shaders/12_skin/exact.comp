// The truth: light from every texel within 9 mm, by distance in space and represented area.
#include "12_skin/charts.glsl"
#include "12_skin/profile.h"

layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2D from;     // light; a: the chart
uniform sampler2D stretch;  // texels per mm along u and v, mm²
layout(rgba32f) writeonly uniform image2D result;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, imageSize(result)))) return;
    vec4 own = place_at(texel);
    if (own.w == 0.0) {
        imageStore(result, texel, vec4(0.0));
        return;
    }
    ivec2 reach = ivec2(min(ceil(9.0 * texelFetch(stretch, texel, 0).xy), 96.0));
    vec3 sums[6] = vec3[](vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0));
    float weights[6] = float[](0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    for (int y = -reach.y; y <= reach.y; ++y)
        for (int x = -reach.x; x <= reach.x; ++x) {
            ivec2 at = texel + ivec2(x, y);
            vec4 place = place_at(at);
            vec3 apart = 1000.0 * (place.xyz - own.xyz);
            float square = dot(apart, apart);
            if (place.w != own.w || square > 81.0) continue;
            vec3 light = texelFetch(from, at, 0).rgb;
            float area = texelFetch(stretch, at, 0).z;
            for (uint i = square > 9.1 ? 4u : 0u; i < SKIN_GAUSSIANS; ++i) {  // narrow ones have ended at 4 sigma
                float weight = area * exp(-0.5 * square / skin_variance_mm2[i]);
                sums[i] += weight * light;
                weights[i] += weight;
            }
        }
    // Each Gaussian's weights add up to 1: of one that is narrower than a texel all of it is this texel's.
    vec3 sum = vec3(0.0);
    for (uint i = 0u; i < SKIN_GAUSSIANS; ++i)
        sum += skin_weight[i] * (weights[i] > 0.0 ? sums[i] / weights[i] : texelFetch(from, texel, 0).rgb);
    imageStore(result, texel, vec4(sum, own.w));
}
