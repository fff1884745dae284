// Shared by every method's pass over the picture: the pixel's path, and its composition with the picture.
#include "common/light.glsl"
#include "10_atmosphere/view_path.glsl"
#include "common/view_rays.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f) uniform image2D result;
uniform sampler2D depth;
layout(scalar) uniform RaysBlock { ViewRays rays; };
layout(scalar) uniform SunBlock { vec3 to_sun; };
layout(scalar) uniform AtmosphereBlock {
    float turbidity, exposure;
    int steps, light_steps, paths;
} atmosphere;
layout(scalar) uniform DiscBlock { float disc; };  // brightness of the sun's disc, of its true one

const float endless = 1e12;
bool unfinished = false;  // along() has found part of the light, and another dispatch goes on

// Defined by each pass: light and transmittance of a path within the air, to a point `distance` metres from the eye.
Along along(Path path, vec3 direction, ivec2 pixel, float distance);

// The sun itself, in a direction: as bright as its light over its disc, darker towards its edge (D. Hestroffer and C. Magnan,
// Astronomy and Astrophysics 333, 1998, for green light). The edge is as wide as a pixel.
vec3 sun_disc(float cos_angle, float sine, float pixel_rad) {
    float away = atan(sine, cos_angle), edge = clamp((air.sun_rad - away) / pixel_rad + 0.5, 0.0, 1.0);
    float inside = clamp(away / air.sun_rad, 0.0, 1.0), mu = sqrt(max(1.0 - inside * inside, 1e-6));
    float middle = 1.2 / (3.14159265 * air.sun_rad * air.sun_rad);  // of the disc the mean of mu to the power of 0.4 is 1 / 1.2
    return disc * middle * edge * pow(mu, 0.4) * air.sun;
}

// The pixel's own picture and the air before it.
void look(ivec2 pixel) {
    vec3 ray = ray_through(rays, vec2(pixel) + 0.5);
    float stretch = length(ray), stored = texelFetch(depth, pixel, 0).r;
    vec3 direction = ray / stretch;
    Path path = path_from(rays.eye, direction, to_sun);
    float ground = distance_to_ground(path);
    float distance = stored > 0.0 ? stretch * distance_along_view(rays, stored) : ground >= 0.0 ? ground : endless;
    vec4 seen = imageLoad(result, pixel);
    vec3 light = seen.rgb;
    if (distance >= endless && disc > 0.0)
        light += sun_disc(path.cos_angle, length(cross(direction, to_sun)), length(rays.right) / (stretch * stretch));
    if (clip_to_air(path, distance)) {
        Along air_before = along(path, direction, pixel, distance);
        if (unfinished) return;
        light = light * air_before.transmittance + air_before.light;
    }
    imageStore(result, pixel, vec4(finite_light(light), seen.a));
}
