// Jupiter's winds, and a map of its clouds carried by them.
#include "17_planets/flow_blend.glsl"
#include "17_planets/map_lookup.glsl"

// Zonal wind in m/s every 5° of latitude from 80° S on, in the system of the magnetic field, to some 10 m/s. Read in their
// sources: 116 to 162 at 7° S, 103 of the hot spots at 6° N, 135 to 146 at 24° N, 30 at 35° N; the lesson names them. The others
// from memory of C. Porco et al., Science 299, 2003, figure 3.
const float zonal_wind[33] = float[](0.0, 5.0, 10.0, 0.0, 15.0, 5.0, 20.0, 0.0, 25.0, 30.0, -15.0, 40.0, -55.0, 20.0, 130.0, 95.0,
                                     85.0, 105.0, 40.0, -20.0, 60.0, 140.0, 0.0, 30.0, -10.0, 10.0, 20.0, 0.0, 15.0, 5.0, 10.0, 0.0, 0.0);
const vec2 red_spot = vec2(0.372, 0.606), red_spot_deg = vec2(9.5, 5.5);  // on our map; half its axes
const float red_spot_speed = 110.0;  // m/s at its edge, anticlockwise: six days a turn (Porco et al. 2003)
const float flow_radius_m = 71.492e6;

// Metres per second, east and north.
vec2 wind(vec2 uv) {
    float latitude = 180.0 * (0.5 - uv.y), at = clamp((latitude + 80.0) / 5.0, 0.0, 31.999);
    int i = int(at);
    vec2 speed = vec2(mix(zonal_wind[i], zonal_wind[i + 1], smoothstep(0.0, 1.0, at - float(i))), 0.0);
    vec2 from_spot = vec2(360.0 * (fract(uv.x - red_spot.x + 0.5) - 0.5), 180.0 * (red_spot.y - uv.y)) / red_spot_deg;
    float away = dot(from_spot, from_spot), spot = exp(-0.5 * away * away);
    vec2 around = red_spot_speed * vec2(-from_spot.y, from_spot.x) * vec2(1.0, red_spot_deg.y / red_spot_deg.x);
    return mix(speed, around, spot);
}

// Of the map's coordinates, a day.
vec2 flow_speed(vec2 uv) {
    vec2 metres = 86400.0 * wind(uv);
    float around = max(sin(3.14159265 * clamp(uv.y, 0.0, 1.0)), 0.05);
    return vec2(metres.x / (6.2831853 * flow_radius_m * around), -metres.y / (3.14159265 * flow_radius_m));
}

// [flowed]
vec4 flowed(sampler2D map, vec2 uv, float footprint_rad, float days, float period_days) {
#if PLANETS_FLOW == PLANETS_FLOW_FROZEN
    return map_texel(map, uv, footprint_rad);
#elif PLANETS_FLOW == PLANETS_FLOW_SCROLLED
    // One speed for all: that of the mean wind, 30 m/s.
    return map_texel(map, vec2(uv.x - 30.0 * 86400.0 * days / (6.2831853 * flow_radius_m), uv.y), footprint_rad);
#elif PLANETS_FLOW == PLANETS_FLOW_TWO_FRAMES
    float t = fract(days / period_days);
    vec4 places = flow_places(uv, period_days * flow_speed(uv), t);
    return mix(map_texel(map, places.xy, footprint_rad), map_texel(map, places.zw, footprint_rad), flow_weight(t));
#else
    // Back to the place where these clouds were when the map was photographed: 64 steps of the midpoint rule against the wind.
    for (int i = 0; i < 64; ++i) uv -= days / 64.0 * flow_speed(uv - 0.5 * days / 64.0 * flow_speed(uv));
    return map_texel(map, uv, footprint_rad);
#endif
}
// [/flowed]
