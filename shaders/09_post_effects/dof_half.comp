// The picture at half of its size; its alpha is how far out of focus the nearest of the four pixels is.
#include "09_post_effects/dof_lens.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2D hdr;
uniform sampler2D depth;
layout(rgba16f) writeonly uniform image2D result;

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(result)))) return;
    ivec2 last = textureSize(hdr, 0) - 1;
    vec3 sum = vec3(0.0);
    float nearest = 1e9;
    for (int i = 0; i < 4; ++i) {
        ivec2 pixel = min(2 * at + ivec2(i & 1, i >> 1), last);
        sum += min(texelFetch(hdr, pixel, 0).rgb, 16000.0);
        nearest = min(nearest, confusion(texelFetch(depth, pixel, 0).r));
    }
    imageStore(result, at, vec4(0.25 * sum, nearest));
}
