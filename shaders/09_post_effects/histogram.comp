// How many pixels of the picture are how bright.
#include "09_post_effects/histogram_bin.glsl"
#include "common/light.glsl"

layout(local_size_x = 16, local_size_y = 16) in;
uniform sampler2D hdr;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    bool inside = all(lessThan(pixel, textureSize(hdr, 0)));
    vec3 radiance = inside ? texelFetch(hdr, pixel, 0).rgb : vec3(0.0);
    count_together(histogram_bin(luminance(radiance)), inside);
}
