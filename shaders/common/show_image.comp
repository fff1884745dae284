// Image of any size, shown in place of the picture.
#include "common/image_shown.h"
#include "common/structs.h"

layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2D image;
layout(scalar) uniform ShownBlock { ImageShown shown; };
#ifdef GATED
layout(scalar) readonly buffer WordBuffer { uint words[]; };
#endif
layout(rgba16f) writeonly uniform image2D result;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(result)))) return;
    vec2 at = (vec2(pixel) + 0.5 - shown.place) / shown.size;
    bool inside = all(greaterThanEqual(at, vec2(0.0))) && all(lessThan(at, vec2(1.0)));
#ifdef GATED
    inside = inside && words[shown.gate] != 0u;
#endif
    vec3 light = vec3(shown.around);
    if (inside) light += shown.gain * texelFetch(image, ivec2(shown.first + at * shown.extent), 0).rgb;
    imageStore(result, pixel, vec4(min(light, LARGEST_HALF), 1.0));
}
