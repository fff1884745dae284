// The table of the sky, for the eye's height and the sun of this frame.
#include "common/structs.h"
#include "10_atmosphere/sun_table.glsl"
#include "10_atmosphere/in_scatter.glsl"
#include "10_atmosphere/sky_view.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f) writeonly uniform image2D result;
layout(scalar) uniform EyeBlock { vec2 eye; };  // its height, and the sun's cosine there

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    vec2 size = vec2(imageSize(result));
    if (any(greaterThanEqual(texel, imageSize(result)))) return;
    vec2 there = sky_direction(vec2(texel) / (size - 1.0), eye.x);
    float slope = max(sin(there.x), horizon_slope(eye.x)), sun_sine = sqrt(max(1.0 - eye.y * eye.y, 0.0));
    float cos_angle = clamp(slope * eye.y + cos(there.x) * sun_sine * cos(there.y), -1.0, 1.0);
    Path path = Path(eye.x, slope, eye.y, cos_angle, ray_sphere(eye.x, slope, air.radius, air.top).y);
    // Most of a long path is thin air: as many samples on its first fifth as on the rest.
    Path near_by = path, far = path_on(path, 0.2 * path.way);
    near_by.way *= 0.2;
    Along first = in_scatter(20, near_by), then = in_scatter(20, far);
    imageStore(result, texel, vec4(min(first.light + first.transmittance * then.light, LARGEST_HALF), 1.0));
}
