// One direction of a blur over the picture: as wide as skin spreads light at that distance, and not across edges.
#include "12_skin/screen_kernel.h"

layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2D from;  // light; a: how far away, in metres; 0: no skin
layout(rgba16f) writeonly uniform image2D into;
layout(scalar) uniform ScreenBlurBlock { ScreenBlur blur; };
layout(scalar) readonly buffer KernelBuffer { vec4 kernel[]; };  // share of red, green, blue; w: mm

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy), size = imageSize(into);
    if (any(greaterThanEqual(pixel, size))) return;
    vec4 own = texelFetch(from, pixel, 0);
    vec3 sum = own.rgb;
    if (own.a > 0.0) {
        float pixels = 0.001 * blur.pixels_at_1m / own.a;  // in a mm
        sum = vec3(0.0);
        for (int i = 0; i < blur.taps; ++i) {
            vec2 at = (vec2(pixel) + 0.5 + kernel[i].w * pixels * vec2(blur.direction)) / vec2(size);
            vec4 other = textureLod(from, at, 0.0);
            // Samples off the skin, or at a very different depth, use the pixel's own light instead.
            float apart = other.a > 0.0 ? clamp(1000.0 * abs(other.a - own.a) / blur.edge_mm, 0.0, 1.0) : 1.0;
            sum += kernel[i].rgb * mix(other.rgb, own.rgb, apart);
        }
    }
    imageStore(into, pixel, vec4(sum, own.a));
}
