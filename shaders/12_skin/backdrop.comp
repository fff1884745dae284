// The surroundings behind, out of focus.
#include "common/environment.glsl"
#include "common/structs.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(scalar) uniform ViewBlock { CameraView view; };
layout(scalar) uniform BackdropBlock { float backdrop; };
layout(rgba16f) writeonly uniform image2D result;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(result)))) return;
    vec2 at = 2.0 * (vec2(pixel) + 0.5) / view.size - 1.0;
    vec4 far = inverse(view.view_projection) * vec4(at, 0.0, 1.0);
    vec3 direction = normalize(far.xyz - view.eye * far.w);
    imageStore(result, pixel, vec4(min(environment_radiance(direction, backdrop), LARGEST_HALF), 1.0));
}
