// A map of the skin in the middle of the picture.
#include "common/structs.h"

layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2D image;
layout(scalar) uniform LookBlock { vec3 gain; };
layout(rgba16f) writeonly uniform image2D result;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy), size = imageSize(result);
    if (any(greaterThanEqual(pixel, size))) return;
    vec2 wide = vec2(min(float(size.x), 4.0 / 3.0 * float(size.y)), 0.0), from = 0.5 * vec2(size) - vec2(0.5 * wide.x, 0.375 * wide.x);
    vec2 at = (vec2(pixel) + 0.5 - from) / vec2(wide.x, 0.75 * wide.x);
    vec3 shown = vec3(0.01);
    if (all(greaterThanEqual(at, vec2(0.0))) && all(lessThan(at, vec2(1.0))))
        shown += gain * texelFetch(image, ivec2(at * vec2(textureSize(image, 0))), 0).rgb;
    imageStore(result, pixel, vec4(min(shown, LARGEST_HALF), 1.0));
}
