// The ground's heights and slopes at a point of the world. The module Ground provides the names used here.
#include "15_terrain_water/land_data.h"

layout(scalar) uniform LandMapBlock { LandMap land_map; };
uniform sampler2D land_heights;
uniform sampler2D land_slopes;
uniform sampler2D land_bounds;

// In samples, from the map's corner.
vec2 land_place(vec2 world) { return (world - land_map.corner) / land_map.spacing_m; }

float land_sample(ivec2 at) { return texelFetch(land_heights, clamp(at, ivec2(0), ivec2(land_map.samples - 1)), 0).r; }

// Metres; between samples on the two triangles of a cell. Beyond the map its border goes on.
float land_height(vec2 world) {
    vec2 place = clamp(land_place(world), vec2(0.0), vec2(land_map.samples - 1));
    ivec2 cell = min(ivec2(place), ivec2(land_map.samples - 2));
    vec2 t = place - vec2(cell);
    float b = land_sample(cell + ivec2(1, 0)), c = land_sample(cell + ivec2(0, 1));
    if (t.x + t.y <= 1.0) {
        float a = land_sample(cell);
        return a + t.x * (b - a) + t.y * (c - a);
    }
    float d = land_sample(cell + 1);
    return d + (1.0 - t.x) * (c - d) + (1.0 - t.y) * (b - d);
}

// Slopes along x and z and the mean height, of `footprint_m` metres of ground.
vec3 land_slope(vec2 world, float footprint_m) {
    float level = max(log2(max(footprint_m, 1e-3) / land_map.spacing_m), 0.0);
    return textureLod(land_slopes, (land_place(world) + 0.5) / float(land_map.samples), level).xyz;
}
