// Shading of the ground where it was found.
#include "15_terrain_water/no_sun_shadow.glsl"
#include "15_terrain_water/land_light.glsl"
#include "15_terrain_water/chunks.glsl"
#include "common/structs.h"
#include "common/view_rays.h"

layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2D found;
layout(rgba16f) uniform image2D result;
layout(scalar) uniform RaysBlock { ViewRays rays; };
layout(scalar) uniform ToSunBlock { vec3 to_sun; };

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
    vec3 ray = ray_through(rays, vec2(pixel) + 0.5), position = rays.eye + along * ray, sun_at = to_sun;
    float footprint = along * length(rays.right);
    vec3 normal;
    LandSurface surface = land_seen(position, normalize(ray), footprint, normal);
#if LAND_SHOW == LAND_SHOW_NORMALS
    imageStore(result, pixel, vec4(0.5 + 0.5 * surface.normal, 1.0));
#elif LAND_SHOW == LAND_SHOW_LEVELS
    imageStore(result, pixel, vec4(level_color(position) * (0.25 + 0.75 * max(dot(normal, sun_at), 0.0)), 1.0));
#else
    imageStore(result, pixel, vec4(min(land_light(surface, normal, position, footprint, sun_at), LARGEST_HALF), 1.0));
#endif
}
