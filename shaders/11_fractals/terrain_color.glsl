// Snow and land under a clear sky: the ground's colour where it is seen.
#include "common/structs.h"
#include "10_atmosphere/preetham_inputs.glsl"
#include "11_fractals/quintic_noise.glsl"
#include "11_fractals/terrain.glsl"
#include "11_fractals/terrain_mix.glsl"

uniform sampler2D land_map;
uniform sampler2D rock_map;
layout(scalar) uniform TerrainMixLookBlock {
    vec3 land, rock, snow;
    vec2 snow_begins, snow_ends;
} terrain_mix_look;

// The includer reads maps: uv, and its change from pixel to pixel.
vec4 look_up(sampler2D map, vec2 uv, vec2 across, vec2 down);

// A texture twice, at scales that do not fit each other, so that its repetition does not show.
vec3 photographed(sampler2D map, vec2 uv, vec2 across, vec2 down) {
    return look_up(map, uv, across, down).rgb *
           (0.4 + 1.8 * look_up(map, uv.yx * 0.137, across.yx * 0.137, down.yx * 0.137).g);
}

// The shadow of mountains without a map: the light on a ground of so few octaves that each slope is a mountain's side.
float low_shadow(vec2 place) {
    vec3 ground = terrain_at(place, 3.0);
    return smoothstep(-0.1, 0.2, dot(normalize(vec3(-ground.y, 1.0, -ground.z)), terrain_now.to_sun));
}

// Its truth: along the ray to the sun, in steps that grow with the distance.
float marched_shadow(vec3 from) {
    float t = 2.0, free = 1.0, top = 1.3 * terrain.height_m;
    for (int i = 0; i < terrain.shadow_steps && free > 0.0; ++i) {
        vec3 at = from + t * terrain_now.to_sun;
        if (at.y > top) break;
        float above = at.y - terrain_at(at.xz, octaves_for(max(0.02 * t, 1.0))).x;
        free = min(free, 0.5 + 60.0 * above / t);  // the sun's disc is half a degree wide: 1 / 120
        t += max(0.35 * above, 0.02 * t);
    }
    return clamp(free, 0.0, 1.0);
}

float sun_visible(vec3 from) {
#if TERRAIN_SHADOW == TERRAIN_SHADOW_SMOOTH
    return low_shadow(from.xz);
#elif TERRAIN_SHADOW == TERRAIN_SHADOW_MARCHED
    return marched_shadow(from);
#else
    return 1.0;
#endif
}

// Waves from 90 m down, which break the snow's edge up; without derivatives, for nobody asks for them.
float edge_noise(vec2 place, float octaves) {
    ivec2 cell = terrain_now.cell;
    vec2 offset = terrain_now.offset + place / terrain.wave_m;
    float sum = 0.0, amplitude = 1.0;
    for (int k = 0; k < 9 && float(k) < octaves; ++k) {
        settle(cell, offset);
        if (k >= 5) {
            sum += amplitude * min(octaves - float(k), 1.0) * quintic_noise(cell, offset);
            amplitude *= 0.6;
        }
        next_octave(cell, offset);
    }
    return sum;
}

// Irradiance by a second light, 30 degrees high opposite the sun, of the sky's colour there.
vec3 back_light(vec3 normal) {
    vec2 away = -terrain_now.to_sun.xz;
    vec3 to_light = normalize(vec3(away.x, max(0.577 * length(away), 1e-3), away.y));
    return terrain.back_light * 3.14159265 * sky_light(to_light, terrain_now.to_sun) * max(dot(normal, to_light), 0.0);
}

// Towards the eye, linear, from a place of the ground. `across` and `down`: how the place changes from this pixel to the
// next ones.
vec3 terrain_color(vec3 position, vec3 across, vec3 down) {
    float distance_m = length(position - terrain_now.eye), octaves = octaves_for(pixel_footprint(distance_m));
    vec3 normal = terrain_normal(position.xz, octaves);
#if TERRAIN_SHOW == TERRAIN_SHOW_NORMALS
    return 0.5 + 0.5 * normal;
#elif TERRAIN_SHOW == TERRAIN_SHOW_OCTAVES
    return vec3(octaves / terrain.most_octaves);
#endif
    float noise = edge_noise(position.xz, octaves);
    float rough = clamp(noise + (position.y - terrain.snow_line_m) / (0.5 * terrain.height_m), -1.0, 1.0);
    vec2 begins = terrain_mix_look.snow_begins, ends = terrain_mix_look.snow_ends;
    float snow = terrain_mix(normal.y, rough, begins, ends, 1.0);

    // Land where it is flat, rock where it is steep: there the texture runs down the wall.
    vec2 uv = terrain_now.offset * terrain.wave_m + position.xz;
    vec3 land = terrain_mix_look.land * photographed(land_map, uv / 23.0, across.xz / 23.0, down.xz / 23.0);
    vec3 rock = terrain_mix_look.rock * photographed(rock_map, vec2(uv.x + uv.y, 0.6 * position.y) / 41.0,
                                                     vec2(across.x + across.z, 0.6 * across.y) / 41.0,
                                                     vec2(down.x + down.z, 0.6 * down.y) / 41.0);
    vec3 albedo = mix(mix(rock, land, smoothstep(0.62, 0.82, normal.y)), terrain_mix_look.snow, snow);

    vec3 sun = sun_light(terrain_now.to_sun) * max(dot(normal, terrain_now.to_sun), 0.0) * sun_visible(position);
    vec3 sky = 3.14159265 * sky_light(normalize(vec3(normal.x, 1.5, normal.z)), terrain_now.to_sun);
    float open = pow(max(normal.y, 0.0), terrain.ambient_power) * (1.0 - terrain.ambient) + terrain.ambient;
    if (terrain.ambient_noise > 0.0) open *= max(1.0 + terrain.ambient_noise * noise, 0.0);
    if (terrain.back_light > 0.0) sun += back_light(normal);
    return min(albedo / 3.14159265 * (sun + open * sky), LARGEST_HALF);
}
