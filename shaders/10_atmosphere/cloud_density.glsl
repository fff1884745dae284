// Density of the cloud layer at a place, from the planet's map, and from one tile of noise at four scales.
#include "10_atmosphere/map_uv.glsl"
#include "10_atmosphere/air.glsl"

layout(scalar) uniform CloudsBlock {
    float base_m, top_m, cover, around_km, extinction, drift_m_s;
    int steps;
} clouds;
layout(scalar) uniform MovedBlock { float moved_m; };
layout(scalar) uniform TurnBlock { mat3 to_map; };  // from the world to the map's axes
uniform sampler3D cloud_noise;
#if PLANET_MAP == PLANET_MAP_EARTH
uniform sampler2D cloud_map;
#endif

// Sides of the noise's tile in metres, coarse to fine, and the weight of each. Turned, so that repeats do not line up.
const float tile_m[4] = float[4](310e3, 61e3, 13e3, 2.7e3);
const float weight[4] = float[4](0.30, 0.30, 0.27, 0.13);
const float cells = 6.0;  // of the coarsest octave of a tile
const float mean_noise = 0.42;
const mat2 turned = mat2(0.8, 0.6, -0.6, 0.8);

// Share of the sky that clouds cover at a place, 0 to 1.
float cover_at(vec3 at) {
    float around = length(at.xz) / (1000.0 * clouds.around_km), share = clouds.cover;
#if PLANET_MAP == PLANET_MAP_EARTH
    vec3 up = normalize(at + vec3(0.0, air.radius, 0.0));
    float map = textureLod(cloud_map, map_uv(to_map * up), 0.0).r;
    share = mix(clamp(1.3 * map - 0.05, 0.0, 1.0), share, smoothstep(1.0, 0.1, around));
#endif
    return share;
}

// 0 to 1 at `at` metres, `height` above the ground, without detail finer than `footprint_m` metres. `scales`: number of
// lookups, at most four.
float cloud_density(vec3 at, float height, float footprint_m, float share, int scales) {
    float high = (height - clouds.base_m) / (clouds.top_m - clouds.base_m);
    if (high <= 0.0 || high >= 1.0 || share <= 0.0) return 0.0;
    float noise = 0.0, known = 0.0;
    vec2 across = at.xz - vec2(moved_m, 0.0);
    for (int i = 0; i < scales; ++i) {
        float seen = smoothstep(0.5, 0.15, footprint_m * cells / tile_m[i]);
        float there = mean_noise;
        if (seen > 0.0) there = mix(mean_noise, textureLod(cloud_noise, vec3(across, height * 1.6) / tile_m[i], 0.0).r, seen);
        noise += weight[i] * there;
        // Coarse scales bend the finer ones: rows of equal billows would show the noise's cells.
        across = turned * across + (there - mean_noise) * tile_m[i] * vec2(0.045, -0.025);
        known += weight[i];
    }
    noise += (1.0 - known) * mean_noise;
    // Flat below, round above.
    float rounded = smoothstep(0.0, 0.08, high) * (1.0 - high * high);
    float threshold = mix(0.78, 0.16, sqrt(share));
    return clamp((noise * (0.55 + 0.6 * rounded) * smoothstep(0.0, 0.12, rounded) - threshold) * 6.0, 0.0, 1.0);
}
