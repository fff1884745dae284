// The ground's light towards the camera: textures by height and slope, the sun, its shadows, and the sky.
#include "10_atmosphere/ground_light.glsl"
#include "10_atmosphere/view_path.glsl"
#include "15_terrain_water/ground.glsl"
#include "15_terrain_water/land_shadow.glsl"
#include "15_terrain_water/land_materials.glsl"

// The normal of as much ground as the pixel shows, and the textures on it. `ray`: of unit length, from the eye; `footprint`:
// metres that a pixel covers there, across the ray.
LandSurface land_seen(vec3 position, vec3 ray, float footprint, out vec3 normal) {
    vec3 slope = land_slope(position.xz, 1.5 * footprint);
    normal = normalize(vec3(-slope.x, 1.0, -slope.y));
    float seen = max(-dot(ray, normal), 0.06);
    return land_surface(position, normal, footprint * inversesqrt(seen));
}

// Unoccluded sun; the sky, less of it in valleys and on walls; and light from sunny ground opposite.
vec3 land_light(LandSurface surface, vec3 normal, vec3 position, float footprint, vec3 to_sun) {
    Path here = path_from(position, to_sun, to_sun);
    Place place = Place(max(here.height, 0.0), here.sun);
    vec3 sun = sunlight_on(place), sky = skylight_on(place);
    float facing = max(dot(surface.normal, to_sun), 0.0);
    float lit = facing > 0.0 ? sun_visible(position + 0.02 * footprint * normal, to_sun) : 0.0;
    if (lit > 0.0) lit *= sun_left_by_houses(position, normal, to_sun);
    float hollow = max(land_slope(position.xz, 250.0).z - position.y, 0.0) / 90.0 + max(land_slope(position.xz, 1200.0).z - position.y, 0.0) / 450.0;
    float open = (0.35 + 0.65 * surface.normal.y) * surface.occlusion / (1.0 + hollow);
    vec3 bounce = 0.12 * (1.0 - 0.6 * normal.y) * max(to_sun.y, 0.0) * sun * vec3(0.9, 0.8, 0.6);
    return surface.albedo / 3.14159265 * (sun * facing * lit + sky * open + bounce * surface.occlusion);
}
