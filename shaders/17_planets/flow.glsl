// Jupiter's winds, and maps of its clouds carried by them.
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

#if PLANETS_FLOW_FRAMES == PLANETS_FLOW_FRAMES_FIVE
// Vortices of the sequence: where the map has an oval, half of its width in degrees, and m/s at its edge, anticlockwise. Their
// bands carry them along. The speeds are invented: a turn takes four days.
const vec4 ovals[5] = vec4[](vec4(0.4557, 0.6129, 2.6, 50.0), vec4(0.2920, 0.7300, 2.8, 50.0), vec4(0.4136, 0.7270, 2.8, 50.0),
                             vec4(0.2243, 0.2757, 2.6, -50.0), vec4(0.7214, 0.2757, 2.6, -50.0));
#endif

// Of a row of the map, in metres per second.
float zonal_wind_at(float v) {
    float latitude = 180.0 * (0.5 - v), at = clamp((latitude + 80.0) / 5.0, 0.0, 31.999);
    int i = int(at);
    return mix(zonal_wind[i], zonal_wind[i + 1], smoothstep(0.0, 1.0, at - float(i)));
}

// Metres per second, east and north, as the map's coordinates a day.
vec2 on_map(vec2 speed, float v) {
    vec2 metres = 86400.0 * speed;
    float around = max(sin(3.14159265 * clamp(v, 0.0, 1.0)), 0.05);
    return vec2(metres.x / (6.2831853 * flow_radius_m * around), -metres.y / (3.14159265 * flow_radius_m));
}

// Wind with a vortex in it: its middle on the map, half its axes in degrees, m/s at its edge, anticlockwise, and of its middle.
vec2 with_vortex(vec2 speed, vec2 uv, vec2 middle, vec2 half_deg, float edge_speed, float drift) {
    vec2 from = vec2(360.0 * (fract(uv.x - middle.x + 0.5) - 0.5), 180.0 * (middle.y - uv.y)) / half_deg;
    float away = dot(from, from), inside = exp(-0.5 * away * away);
    vec2 around = edge_speed * vec2(-from.y, from.x) * vec2(1.0, half_deg.y / half_deg.x);
    return mix(speed, vec2(drift, 0.0) + around, inside);
}

// Metres per second, east and north.
vec2 wind(vec2 uv, float days) {
    vec2 speed = with_vortex(vec2(zonal_wind_at(uv.y), 0.0), uv, red_spot, red_spot_deg, red_spot_speed, 0.0);
#if PLANETS_FLOW_FRAMES == PLANETS_FLOW_FRAMES_FIVE
    for (int i = 0; i < 5; ++i) {
        float drift = zonal_wind_at(ovals[i].y), east = days * on_map(vec2(drift, 0.0), ovals[i].y).x;
        speed = with_vortex(speed, uv, ovals[i].xy + vec2(east, 0.0), ovals[i].zz, ovals[i].w, drift);
    }
#endif
    return speed;
}

// Of the map's coordinates, a day.
vec2 flow_speed(vec2 uv, float days) { return on_map(wind(uv, days), uv.y); }

// [flowed]
// The clouds of two maps, `period_days` apart, the later of which may be the same one.
vec4 flowed(sampler2D map, sampler2D next, vec2 uv, float footprint_rad, float days, float period_days) {
    float t = fract(days / period_days);
#if PLANETS_FLOW == PLANETS_FLOW_FROZEN
    return map_texel(map, uv, footprint_rad);
#elif PLANETS_FLOW == PLANETS_FLOW_SCROLLED
    // One speed for all: that of the mean wind, 30 m/s.
    return map_texel(map, vec2(uv.x - 30.0 * 86400.0 * days / (6.2831853 * flow_radius_m), uv.y), footprint_rad);
#elif PLANETS_FLOW == PLANETS_FLOW_NEAREST
    return t < 0.5 ? map_texel(map, uv, footprint_rad) : map_texel(next, uv, footprint_rad);
#elif PLANETS_FLOW == PLANETS_FLOW_CROSS_FADE
    return mix(map_texel(map, uv, footprint_rad), map_texel(next, uv, footprint_rad), t);
#elif PLANETS_FLOW == PLANETS_FLOW_TWO_FRAMES
    vec4 places = flow_places(uv, period_days * flow_speed(uv, days), t);
    return mix(map_texel(map, places.xy, footprint_rad), map_texel(next, places.zw, footprint_rad), flow_weight(t));
#else
    // Back to the place where these clouds were when the first map was taken: 64 steps of the midpoint rule against the wind.
    float step_days = days / 64.0;
    for (int i = 0; i < 64; ++i) {
        float now = days - float(i) * step_days, middle = now - 0.5 * step_days;
        uv -= step_days * flow_speed(uv - 0.5 * step_days * flow_speed(uv, now), middle);
    }
    return map_texel(map, uv, footprint_rad);
#endif
}
// [/flowed]
