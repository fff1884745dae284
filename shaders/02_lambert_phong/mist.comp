// Mist over surfaces by distance; the sky stays.
#include "02_lambert_phong/mist.h"
#include "common/view_rays.h"

layout(local_size_x = 16, local_size_y = 16) in;
layout(rgba16f) uniform image2D result;
uniform sampler2D depth;
layout(scalar) uniform MistBlock { Mist mist; };

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(result)))) return;
    float stored = texelFetch(depth, pixel, 0).r;
    if (stored == 0.0) return;
    float distance = depth_to_metres(stored, mist.inverse_near, mist.inverse_far);
    vec4 seen = imageLoad(result, pixel);
    imageStore(result, pixel, vec4(mix(mist.color, seen.rgb, exp(-mist.per_m * distance)), seen.a));
}
