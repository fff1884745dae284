// Hits of reflected rays: ground, houses and objects, lit as in the camera's view.
#include "15_terrain_water/no_sun_shadow.glsl"
#include "05_shadow_maps/bvh.glsl"
#include "15_terrain_water/land_light.glsl"
#include "15_terrain_water/land_march.glsl"
#include "15_terrain_water/city_light.glsl"
#include "15_terrain_water/city_rays.glsl"
#include "common/structs.h"
#include "common/view_rays.h"

layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2D reflected;  // direction, and metres along the view of where the ray begins; 0: there is none
layout(scalar) readonly buffer RayColorsBlock { vec3 ray_colors[]; };  // albedo of each triangle
layout(rgba16f) writeonly uniform image2D met;
layout(scalar) uniform WaterRaysBlock { ViewRays water_rays; };
layout(scalar) uniform ToSunBlock { vec3 to_sun; };
layout(scalar) uniform RaysMeetBlock { uvec3 rays_meet; };  // 1: ground, houses, objects

// Transmittance of `t` metres of air at a height, with constant density along the path.
vec3 left_by_air(float height, float t) { return exp(-t * extinction(density_at(max(height, 0.0)))); }

vec3 house_light(CityHit hit, vec3 position, float seen_m) {
    CityBox box = city_boxes[hit.box];
    float along = abs(hit.normal.y) > 0.5 || abs(abs(hit.local.z) - box.half_size.z) < abs(abs(hit.local.x) - box.half_size.x)
                      ? hit.local.x + box.half_size.x
                      : hit.local.z + box.half_size.z;
    vec3 on_wall = vec3(along, position.y - land_height(box.place), box.base_m + 2.0 * box.half_size.y);
    return city_light_of(position, hit.normal, on_wall, box.kind, box.number, 1.0, seen_m, to_sun);
}

// A matt surface in the light that falls on the ground: neither textures nor gloss.
vec3 object_light(RayHit hit, vec3 position, vec3 direction) {
    RayTriangle triangle = rays_triangles[hit.triangle];
    vec3 normal = normalize(cross(triangle.b - triangle.a, triangle.c - triangle.a));
    if (dot(normal, direction) > 0.0) normal = -normal;
    Path here = path_from(position, to_sun, to_sun);
    Place place = Place(max(here.height, 0.0), here.sun);
    float facing = max(dot(normal, to_sun), 0.0);
    if (facing > 0.0) facing *= sun_left_by_houses(position, normal, to_sun);
    return ray_colors[hit.triangle] / 3.14159265 * (sunlight_on(place) * facing + skylight_on(place) * (0.5 + 0.5 * normal.y));
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(met)))) return;
    vec4 ray = texelFetch(reflected, pixel, 0);
    vec3 direction = ray.xyz;
    vec3 begins = water_rays.eye + ray.w * ray_through(water_rays, vec2(pixel) + 0.5);
    // A little away from the water, so far that rounding does not put the ray below the shore.
    vec3 origin = begins + 1e-4 * length(begins - water_rays.eye) * direction;
    float nearest = 1e30;
    vec4 light = vec4(0.0);
    if (ray.w > 0.0) {
        // 1. The nearest hit.
        float ground = rays_meet.x == 1u ? march(origin, direction) : -1.0;
        if (ground > 0.0) nearest = ground;
        CityHit house = CityHit(-1.0, 0u, vec3(0.0), vec3(0.0));
        if (rays_meet.y == 1u) house = city_hit(origin, direction, nearest);
        if (house.t > 0.0) nearest = house.t;
        RayHit object;
        bool is_object = false;
        if (rays_meet.z == 1u) is_object = closest_hit(Ray(origin, 1e-3, direction, nearest), object);
        if (is_object) nearest = object.t;

        // 2. Its light, and the transmittance of the air.
        if (nearest < 1e30) {
            vec3 position = origin + nearest * direction, shown;
            float seen_m = nearest + length(begins - water_rays.eye);
            if (is_object) {
                shown = object_light(object, position, direction);
            } else if (house.t > 0.0) {
                shown = house_light(house, position, seen_m);
            } else {
                vec3 normal;
                float footprint = seen_m * length(water_rays.right);
                LandSurface surface = land_seen(position, direction, footprint, normal);
                shown = land_light(surface, normal, position, footprint, to_sun);
            }
            vec3 left = left_by_air(0.5 * (origin.y + position.y), nearest);
            light = vec4(min(left * shown, LARGEST_HALF), dot(left, vec3(1.0 / 3.0)));
        }
    }
    imageStore(met, pixel, light);
}
