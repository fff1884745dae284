// What the ground looks like where it was found: textures by height and slope, the sun, its shadow, and the sky.
#include "10_atmosphere/ground_light.glsl"
#include "10_atmosphere/view_path.glsl"
#include "15_terrain_water/chunks.glsl"
#include "15_terrain_water/land_shadow.glsl"
#include "15_terrain_water/land_materials.glsl"
#include "15_terrain_water/land_shadow.glsl"
#include "common/structs.h"
#include "common/view_rays.h"

layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2D found;
layout(rgba16f) uniform image2D result;
layout(scalar) uniform RaysBlock { ViewRays rays; };
layout(scalar) uniform ToSunBlock { vec3 to_sun; };

bool is_drawn() { return int(gl_GlobalInvocationID.x) >= 0; }

#if LAND_SHOW == LAND_SHOW_LEVELS
vec3 level_color(vec3 position) {
    ivec2 at = ivec2(land_place(position.xz)) / CHUNK_CELLS;
    for (int level = top_level(); level > 0; --level) {
        Chunk chunk = Chunk(at.x >> level, at.y >> level, level);
        if (chunk_error(chunk) <= chunk_distance(chunk) * chunk_limit())
            return 0.5 + 0.5 * cos(1.7 * float(level) + vec3(0.0, 2.1, 4.2));
    }
    return vec3(0.95);
}
#endif

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(result)))) return;
    float along = texelFetch(found, pixel, 0).r;
    if (along <= 0.0) return;
    vec3 ray = ray_through(rays, vec2(pixel) + 0.5), position = opaque(rays.eye + along * ray), sun_at = opaque(to_sun);
    float footprint = along * length(rays.right);

    // [surface]
    // 1. The normal of as much ground as the pixel shows, and the textures on it.
    vec3 slope = land_slope(position.xz, 1.5 * footprint);
    vec3 normal = normalize(vec3(-slope.x, 1.0, -slope.y));
    float seen = max(-dot(normalize(ray), normal), 0.06);
    LandSurface surface = land_surface(position, normal, footprint * inversesqrt(seen));
    // [/surface]
#if LAND_SHOW == LAND_SHOW_NORMALS
    imageStore(result, pixel, vec4(0.5 + 0.5 * surface.normal, 1.0));
    return;
#elif LAND_SHOW == LAND_SHOW_LEVELS
    imageStore(result, pixel, vec4(level_color(position) * (0.25 + 0.75 * max(dot(normal, sun_at), 0.0)), 1.0));
    return;
#endif

    // [light]
    // 2. The sun where nothing hides it; the sky, less of it in valleys and on walls; and what sunny ground opposite sends.
    Path here = path_from(position, sun_at, sun_at);
    Place place = Place(max(here.height, 0.0), here.sun);
    vec3 sun = sunlight_on(place), sky = skylight_on(place);
    float facing = max(dot(surface.normal, sun_at), 0.0);
    float lit = facing > 0.0 ? sun_visible(position + 0.02 * footprint * normal, sun_at) : 0.0;
    float hollow = max(land_slope(position.xz, 250.0).z - position.y, 0.0) / 90.0 + max(land_slope(position.xz, 1200.0).z - position.y, 0.0) / 450.0;
    float open = (0.35 + 0.65 * surface.normal.y) * surface.occlusion / (1.0 + hollow);
    vec3 bounce = 0.12 * (1.0 - 0.6 * normal.y) * max(sun_at.y, 0.0) * sun * vec3(0.9, 0.8, 0.6);
    vec3 light = surface.albedo / 3.14159265 * (sun * facing * lit + sky * open + bounce * surface.occlusion);
    imageStore(result, pixel, vec4(min(light, LARGEST_HALF), 1.0));
    // [/light]
}
