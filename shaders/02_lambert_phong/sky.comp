// Sky gradient from the mist's colour to the zenith's.
#include "02_lambert_phong/mist.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f) writeonly uniform image2D result;
layout(scalar) uniform MistBlock { Mist mist; };

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy), size = imageSize(result);
    if (any(greaterThanEqual(pixel, size))) return;
    float height = clamp(1.0 - 2.0 * (float(pixel.y) + 0.5) / float(size.y), 0.0, 1.0);  // 0 in the lower half
    imageStore(result, pixel, vec4(mix(mist.color, mist.zenith, height), 1.0));
}
