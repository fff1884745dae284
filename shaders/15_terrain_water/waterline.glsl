// Rings of small waves around whatever stands in the water.
#include "15_terrain_water/waterline_data.h"

#if WATERLINE_METHOD == WATERLINE_METHOD_RINGS

layout(scalar) uniform WaterlineMapBlock { WaterlineMap waterline_map; };
uniform sampler2D waterline_distances;

// Metres, and the direction away from the nearest object; beside the map far away.
vec3 from_waterline(vec2 at) {
    vec2 uv = (at - waterline_map.corner) / waterline_map.side_m;
    if (any(lessThan(uv, vec2(0.0))) || any(greaterThan(uv, vec2(1.0)))) return vec3(1e9, 0.0, 0.0);
    vec2 texel = 1.5 / vec2(textureSize(waterline_distances, 0));
    float away_m = textureLod(waterline_distances, uv, 0.0).r;
    vec2 gradient = vec2(textureLod(waterline_distances, uv + vec2(texel.x, 0.0), 0.0).r - textureLod(waterline_distances, uv - vec2(texel.x, 0.0), 0.0).r,
                         textureLod(waterline_distances, uv + vec2(0.0, texel.y), 0.0).r - textureLod(waterline_distances, uv - vec2(0.0, texel.y), 0.0).r);
    float size = length(gradient);
    return vec3(away_m, size > 0.0 ? gradient / size : vec2(0.0));
}

// [ring_slope]
// Of the longest ring wave's length, or of its reach, that of another one.
float ring_part(float longest, int i) {
    for (int j = 0; j < i; ++j) longest *= RING_RATIO;
    return longest;
}
float ring_length(int i) { return ring_part(waterline_map.length_m, i); }

// Largest slope of a ring wave. An obstacle sends part of the waves that meet it back in circles: more of them towards
// where they come from. Short waves fade sooner; none is drawn that would be shorter than two distances `spacing`.
float ring_steepness(int i, vec3 from, float spacing) {
    float length_m = ring_length(i), reach_m = ring_part(waterline_map.reach_m, i);
    float facing = 0.65 + 0.35 * dot(from.yz, waterline_map.from_wind);
    float wide = inversesqrt(1.0 + from.x / length_m);  // a circle grows, and its height with the root of that
    float texel_m = waterline_map.side_m / float(textureSize(waterline_distances, 0).x);
    return waterline_map.slope * facing * wide * exp(-from.x / reach_m) * drawn_share(length_m, max(spacing, texel_m));
}

// Slope of the rings along x and z.
vec2 ring_slope(vec2 at, float spacing) {
    vec3 from = from_waterline(at);
    vec2 slope = vec2(0.0);
    for (int i = 0; i < RING_WAVES; ++i)
        slope += ring_steepness(i, from, spacing) * sin(6.2831853 * from.x / ring_length(i) - waterline_map.phase[i]) * from.yz;
    return slope;
}
// [/ring_slope]

// 1 at an object, 0 from foam_m on.
float waterline_foam(vec2 at) {
    return waterline_map.foam_m > 0.0 ? 1.0 - smoothstep(0.0, waterline_map.foam_m, from_waterline(at).x) : 0.0;
}
#else
vec2 ring_slope(vec2 at, float spacing) { return vec2(0.0); }
float waterline_foam(vec2 at) { return 0.0; }
#endif
