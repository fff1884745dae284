// One direction of one Gaussian, over the texels of a chart.
#include "12_skin/profile.h"

layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2D from;     // light; a: the chart
uniform sampler2D stretch;  // texels per mm along u and v
layout(rgba16f) writeonly uniform image2D into;
layout(scalar) uniform SkinBlurBlock { SkinBlur blur; };

const float finest = 0.5;  // of this blur's sigma: reads stand no farther apart
const int most_taps = 48;  // to each side

#if PER_CHANNEL
#define WEIGHT vec3
#define SIGMA(s) (s)
#else
#define WEIGHT float
#define SIGMA(s) (s).x
#endif

// Of a Gaussian that is narrower than a texel the weights at texels' middles say little: three weights with its variance.
WEIGHT weight_at(float texels, WEIGHT variance) {
    WEIGHT narrow = WEIGHT(texels == 0.0 ? 1.0 : 0.0) + (texels == 0.0 ? -1.0 : texels == 1.0 ? 0.5 : 0.0) * variance;
    return mix(exp(-0.5 * texels * texels / max(variance, 1e-6)), narrow, WEIGHT(lessThan(vec3(variance), vec3(0.36))));
}

// [blur]
void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy), size = imageSize(into);
    if (any(greaterThanEqual(texel, size))) return;
    vec4 own = texelFetch(from, texel, 0);
    if (own.a == 0.0) {
        imageStore(into, texel, vec4(0.0));
        return;
    }
    vec2 per_mm = texelFetch(stretch, texel, 0).xy;
    vec3 sigma = blur.sigma_mm * dot(per_mm, vec2(blur.direction));
    float widest = max(sigma.x, max(sigma.y, sigma.z));
    // A blur by sigma texels can be sampled at every sigma-th texel, with an error of at most 2 exp(-2 pi²).
    int radius = int(ceil(3.0 * widest));
    int stride = int(min(blur.smooth_mm * dot(per_mm, vec2(blur.direction)), finest * widest));
    stride = max(max(stride, 1), (radius + most_taps - 1) / most_taps);
    int taps = radius / stride;
    WEIGHT variance = SIGMA(sigma) * SIGMA(sigma), weights = weight_at(0.0, variance);
    vec3 sum = weights * own.rgb;
    for (int i = 1; i <= taps; ++i) {
        WEIGHT weight = weight_at(float(i * stride), variance);
        for (int side = -1; side <= 1; side += 2) {
            ivec2 at = texel + side * i * stride * blur.direction;
            vec4 other = texelFetch(from, clamp(at, ivec2(0), size - 1), 0);
            if (other.a != own.a) continue;  // another chart's, or none's
            sum += weight * other.rgb;
            weights += weight;
        }
    }
    imageStore(into, texel, vec4(sum / weights, own.a));
}
// [/blur]
