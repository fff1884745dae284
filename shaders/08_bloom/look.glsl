// An image of any size, stretched over the picture; black where it is not to be read.
#include "common/structs.h"

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D image;
layout(scalar) uniform GainBlock { float gain; };
layout(rgba16f) writeonly uniform image2D result;

// Shows the part of it that begins at `first` and is `extent` large, in texels.
void look(bool readable, vec2 first, vec2 extent) {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy), size = imageSize(result);
    if (any(greaterThanEqual(pixel, size))) return;
    vec2 uv = (vec2(pixel) + 0.5) / vec2(size);
    ivec2 texel = ivec2(first + uv * extent);
    vec3 shown = readable ? gain * texelFetch(image, texel, 0).rgb : vec3(0.0);
    imageStore(result, pixel, vec4(min(shown, LARGEST_HALF), 1.0));
}
