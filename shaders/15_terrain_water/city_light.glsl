// A wall with windows, lit by the sun and the sky, and at night from within.
#include "10_atmosphere/ground_light.glsl"
#include "10_atmosphere/view_path.glsl"
#include "15_terrain_water/city_data.h"

layout(scalar) uniform CityBlock { float lit; } city;
layout(scalar) uniform CityLightBlock { vec2 city_light; };  // radiance of a lit window, a pixel's angle

float random_of(uvec3 v) {
    v = v * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v ^= v >> 16u;
    v.x += v.y * v.z;
    return float(v.x >> 8u) / 16777216.0;
}

// A window of 1.5 by 1.6 m in every cell of 2.9 by 3.3 m of wall. Where cells are smaller than pixels their mean is shown:
// single windows would be speckle.
//
// `on_wall`: metres along the wall and up, and the height of the box; `thinned`: share of its light that a lamp's surface
// keeps; `seen_m`: length of the path to the eye.
vec3 city_light_of(vec3 position, vec3 normal, vec3 on_wall, uint kind, uint number, float thinned, float seen_m, vec3 to_sun) {
    vec2 cell = on_wall.xy / vec2(2.9, 3.3), whole = floor(cell), within = cell - whole;
    float cells_px = 2.9 / max(seen_m * city_light.y, 1e-4), sharp = smoothstep(0.8, 2.5, cells_px);
    vec2 edge = smoothstep(vec2(0.24, 0.26), vec2(0.30, 0.32), within) * (1.0 - smoothstep(vec2(0.70, 0.72), vec2(0.76, 0.78), within));
    bool wall = normal.y < 0.5 && kind != CITY_LAMP;
    float window = wall && on_wall.y < on_wall.z - 1.2 ? mix(0.23, edge.x * edge.y, sharp) : 0.0;

    float tone = random_of(uvec3(number, 1u, 7u)), shade = random_of(uvec3(number, 2u, 9u));
    vec3 paint = mix(vec3(0.42, 0.36, 0.29), vec3(0.30, 0.31, 0.33), tone) * (0.55 + 0.7 * shade);
    if (kind == CITY_HOUSE && tone > 0.7) paint = vec3(0.36, 0.19, 0.13) * (0.7 + 0.5 * shade);
    if (normal.y > 0.5) paint = kind == CITY_HOUSE ? mix(vec3(0.27, 0.12, 0.08), vec3(0.16), step(0.5, shade)) : vec3(0.17);

    Path here = path_from(position, to_sun, to_sun);
    Place place = Place(max(here.height, 0.0), here.sun);
    vec3 sun = sunlight_on(place), sky = skylight_on(place);
    float open = mix(0.35, 1.0, smoothstep(0.0, 30.0, on_wall.y)) * (0.55 + 0.45 * normal.y);
    float facing = max(dot(normal, to_sun), 0.0);
    if (facing > 0.0) facing *= sun_left_on_wall(position, normal, to_sun, on_wall.y);
    vec3 arriving = sun * facing + sky * open;
    vec3 light = paint / 3.14159265 * arriving;
    // Glass mirrors the sky, darker than it is.
    vec3 glass = 0.22 * sky / 3.14159265 + 0.01 * sun;
    light = mix(light, glass, 0.8 * window);

    if (city_light.x > 0.0) {
        float which = random_of(uvec3(uint(whole.x) + 31u * uint(abs(normal.x) * 7.0 + 4.0), uint(max(whole.y, 0.0)), number));
        float late = 0.5 + random_of(uvec3(number, 5u, 3u)), on = clamp(city.lit * late, 0.0, 1.0);
        // From afar rows of rooms differ, then whole houses.
        float rows = random_of(uvec3(uint(max(cell.x, 0.0)) / 3u, uint(max(cell.y, 0.0)) / 3u, number));
        float mean = on * mix(1.0, 0.15 + 1.7 * rows, smoothstep(0.8, 2.5, 3.0 * cells_px));
        float bright = mix(mean, which < on ? 0.4 + 1.2 * which / max(on, 1e-3) : 0.0, sharp);
        vec3 warm = mix(vec3(1.0, 0.62, 0.28), vec3(0.85, 0.92, 1.0), step(0.72, random_of(uvec3(number, 11u, 13u))));
        light += window * bright * city_light.x * warm;
        light += paint * city_light.x * 0.10 * vec3(1.0, 0.7, 0.4) * exp(-on_wall.y / 9.0);  // the street below
        if (kind == CITY_LAMP) light = thinned * city_light.x * 6.0 * vec3(1.0, 0.66, 0.32);
    }
    return light;
}
