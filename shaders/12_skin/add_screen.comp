// The blurred light in the picture.
#include "common/structs.h"

layout(local_size_x = 16, local_size_y = 16) in;
uniform sampler2D light, after;
layout(rgba16f) uniform image2D hdr;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(hdr)))) return;
    vec4 own = texelFetch(light, pixel, 0);
    if (own.a == 0.0) return;
    vec4 seen = imageLoad(hdr, pixel);
    imageStore(hdr, pixel, vec4(min(seen.rgb + own.rgb * texelFetch(after, pixel, 0).rgb, LARGEST_HALF), seen.a));
}
