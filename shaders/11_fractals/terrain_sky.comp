// The sky behind the ground, and the sun in it.
#include "common/structs.h"
#include "10_atmosphere/preetham_inputs.glsl"
#include "common/view_rays.h"

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D depth;
layout(rgba16f) writeonly uniform image2D result;
layout(scalar) uniform RaysBlock { ViewRays rays; };
layout(scalar) uniform ToSunBlock { vec3 to_sun; };

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(result))) || texelFetch(depth, pixel, 0).r > 0.0) return;
    vec3 ray = normalize(ray_through(rays, vec2(pixel) + 0.5));
    // A disc of half a degree, drawn a little wider, and far less bright than it is: it is white all the same.
    float disc = smoothstep(0.99993, 0.99996, dot(ray, to_sun));
    vec3 light = sky_light(ray, to_sun) + disc * 2.0 * sun_light(to_sun);
    imageStore(result, pixel, vec4(min(light, LARGEST_HALF), 1.0));
}
