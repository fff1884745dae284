// The surroundings behind, and the ground below with the photographed ground projected on it.
#include "common/cubic_picture.glsl"
#include "common/environment.glsl"
#include "14_environment/backdrop_data.h"
#include "14_environment/direction_to_equirect.glsl"
#include "14_environment/projected_ground.glsl"
#include "common/structs.h"
#include "common/view_rays.h"

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D picture;
uniform sampler2D arriving;  // at the ground: its share of the light from all around
layout(scalar) uniform RaysBlock { ViewRays rays; };
layout(scalar) uniform BackdropNowBlock { BackdropNow now; };
layout(rgba16f) writeonly uniform image2D result;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(result)))) return;
    vec3 direction = normalize(ray_through(rays, vec2(pixel) + 0.5)), seen = direction;
    float t = direction.y < 0.0 ? (now.ground_y - rays.eye.y) / direction.y : -1.0;
    bool on_ground = now.has_ground == 1u && t > 0.0;
    vec3 place = rays.eye + t * direction;
    if (now.has_ground == 1u) seen = projected_direction(rays.eye, direction, now.ground_y, now.camera_m, now.radius_m);
    vec3 light = cubic_picture(picture, direction_to_equirect(environment_space(seen)), now.level);
    if (on_ground) {
        // Outside of the map everything arrives; towards its edges shadows fade.
        vec2 at = (place.xz - now.map_corner) / now.map_extent, inside = smoothstep(0.0, 0.1, at) * smoothstep(0.0, 0.1, 1.0 - at);
        light *= mix(vec3(1.0), textureLod(arriving, at, 0.0).rgb, inside.x * inside.y);
    }
    imageStore(result, pixel, vec4(min(environment_scale.intensity * light, LARGEST_HALF), 1.0));
}
