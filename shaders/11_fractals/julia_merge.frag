// A Julia set into a picture that others have drawn into: where it is met, with the depth at which it is. Or that alone.
#include "11_fractals/julia_data.h"
#include "11_fractals/march_along.glsl"

layout(scalar) uniform JuliaNowBlock { JuliaNow julia_now; };
uniform sampler2D found;
#ifndef DEPTH_ALONE
uniform sampler2D color_map;

layout(location = 0) out vec4 color;
#endif

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 march = texelFetch(found, pixel, 0);
    if (int(march.z) == MARCH_MISS) discard;
    ViewRays rays = julia_now.rays;
    float along_view = march.x / length(ray_through(rays, gl_FragCoord.xy));
    gl_FragDepth = (1.0 / along_view - rays.inverse_far) / (rays.inverse_near - rays.inverse_far);
#ifndef DEPTH_ALONE
    color = texelFetch(color_map, pixel, 0);
#endif
}
