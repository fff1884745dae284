// The terrain as a function of position: heights and slopes, with the requested number of octaves. The module Terrain
// provides the names used here. Positions are metres from the grid's middle, x and z.
#include "11_fractals/eroded_fbm.glsl"
#include "11_fractals/integrate_octaves.glsl"
#include "11_fractals/terrain_data.h"

layout(scalar) uniform TerrainBlock {
    float wave_m, height_m, erosion, gain, most_octaves, difference_m, shortest_px, snow_line_m, ambient, ambient_power;
    float ambient_noise, back_light;
    int shadow_steps;
} terrain;
layout(scalar) uniform TerrainNowBlock { TerrainNow terrain_now; };

// Height in metres, and its slopes along x and z.
vec3 terrain_at(vec2 place, float octaves) {
    vec2 offset = terrain_now.offset + place / terrain.wave_m;
    vec3 ground = eroded_fbm(terrain_now.cell, offset, octaves, terrain.erosion, terrain.gain);
    return terrain.height_m * vec3(ground.x, ground.yz / terrain.wave_m);
}

// Half of the shortest wave that a pixel so far away shows, metres.
float pixel_footprint(float distance_m) { return 0.5 * terrain.shortest_px * terrain_now.pixel_rad * distance_m; }

// For a footprint of so many metres of ground.
float octaves_for(float footprint_m) {
#if TERRAIN_OCTAVES == TERRAIN_OCTAVES_FIXED
    return terrain.most_octaves;
#else
    return integrate_octaves(terrain.wave_m, lacunarity, footprint_m, terrain.most_octaves);
#endif
}

// Unit length.
vec3 terrain_normal(vec2 place, float octaves) {
#if TERRAIN_METHOD == TERRAIN_METHOD_CENTRAL
    vec2 h = vec2(terrain.difference_m, 0.0);
    vec2 slope = vec2(terrain_at(place + h.xy, octaves).x - terrain_at(place - h.xy, octaves).x,
                      terrain_at(place + h.yx, octaves).x - terrain_at(place - h.yx, octaves).x) / (2.0 * h.x);
#else
    vec2 slope = terrain_at(place, octaves).yz;
#endif
    return normalize(vec3(-slope.x, 1.0, -slope.y));
}
