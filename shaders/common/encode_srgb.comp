// sRGB encoding of linear HDR; values above 1 are clamped.
#include "common/srgb.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

uniform sampler2D hdr;
layout(rgba8) writeonly uniform image2D result;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(result)))) return;
    imageStore(result, pixel, vec4(nearest_code(encode_srgb(texelFetch(hdr, pixel, 0).rgb)), 1.0));
}
