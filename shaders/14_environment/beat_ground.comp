// Level ground under the sphere: it sees the sphere instead of a part of the sky.
#include "14_environment/beat_surface.glsl"
#include "common/view_rays.h"

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D depth;
layout(rgba16f) uniform image2D picture;
layout(scalar) uniform RaysBlock { ViewRays rays; };
layout(scalar) uniform GroundBlock {
    vec3 sphere_light;  // mean radiance of the sphere, over that of the sky above the ground
    float height_m;     // of the plane
} ground;

// Of all light that level ground receives from an even sky, a sphere of radius r at height h over it and at distance d
// takes the share r^2 h / d^3: its projected solid angle over pi.
void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(picture)))) return;
    vec3 ray = ray_through(rays, vec2(pixel) + 0.5);
    float t = ray.y < 0.0 ? (ground.height_m - rays.eye.y) / ray.y : -1.0, stored = texelFetch(depth, pixel, 0).r;
    if (t <= 0.0 || (stored > 0.0 && distance_along_view(rays, stored) < 0.999 * t)) return;
    vec3 to_sphere = beat_now.center - (rays.eye + t * ray);
    float d = length(to_sphere), r = min(beat_now.radius_m, to_sphere.y);
    float share = r * r * to_sphere.y / (d * d * d);
    vec4 before = imageLoad(picture, pixel);
    imageStore(picture, pixel, vec4(min(before.rgb * (1.0 - share + share * ground.sphere_light), LARGEST_HALF), before.a));
}
