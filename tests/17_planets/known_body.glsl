// For tests of a pixel's footprint: a body with maps that return it as colour, or the place that is read.
#pragma replaces "10_atmosphere/ground_light.glsl"
#pragma replaces "17_planets/body_inputs.glsl"
#pragma replaces "17_planets/limb_fade.glsl"
#pragma replaces "17_planets/sun_surface.glsl"
#include "10_atmosphere/sun_closed.glsl"
#include "17_planets/body_data.h"
#include "17_planets/map_lookup.glsl"

#define PLANETS_METHOD 0
#define PLANETS_METHOD_LAMBERT 0
#define PLANETS_METHOD_WRAPPED 1
#define PLANETS_METHOD_LOMMEL_SEELIGER 2
#define PLANETS_METHOD_MINNAERT 3
#define PLANETS_METHOD_HAPKE 4
#define PLANETS_METHOD_OWN 5
#ifndef PLANETS_PARALLAX
#define PLANETS_PARALLAX 0
#endif
#define PLANETS_PARALLAX_NONE 0
#define PLANETS_PARALLAX_OFFSET 1
#define PLANETS_PARALLAX_MARCH 2
#define PLANETS_PARALLAX_TRUTH 3
#define PLANETS_FLOW 0
#define PLANETS_FLOW_FROZEN 0
#define PLANETS_FLOW_SCROLLED 1
#define PLANETS_FLOW_NEAREST 2
#define PLANETS_FLOW_CROSS_FADE 3
#define PLANETS_FLOW_TWO_FRAMES 4
#define PLANETS_FLOW_FRAMES 0
#define PLANETS_FLOW_FRAMES_FIVE 1
#define PLANETS_RINGS 0
#define PLANETS_RINGS_ALPHA 0
#define PLANETS_RINGS_TABLES 1
#define PLANETS_RINGS_SINGLE_SCATTERING 2
#define ATMOSPHERE_METHOD 0
#define ATMOSPHERE_METHOD_CLOSED 0
#define ATMOSPHERE_METHOD_TABLES 1
#define ATMOSPHERE_METHOD_TRUTH 2
#define ATMOSPHERE_ORDERS 0
#define ATMOSPHERE_ORDERS_SINGLE 0
#define ATMOSPHERE_ORDERS_MULTIPLE 1
#ifdef KNOWN_TEXEL
#define map_texel(map, uv, footprint_rad) vec4(KNOWN_TEXEL(uv))
#elif defined(MAP_BY_PLACE)
#define map_texel(map, uv, footprint_rad) vec4((uv).x)
#else
#define map_texel(map, uv, footprint_rad) vec4(footprint_rad)
#endif

struct CheckKnownPlanets {
    int air_steps, parallax_steps;
    float relief, height_m, clouds, night, waves;
};
#ifndef KNOWN_RELIEF
#define KNOWN_RELIEF 0.0
#endif
#ifndef KNOWN_HEIGHT_M
#define KNOWN_HEIGHT_M 0.0
#endif
const CheckKnownPlanets planets = CheckKnownPlanets(8, 16, KNOWN_RELIEF, KNOWN_HEIGHT_M, 1.0, 0.0, 0.0);
BodyNow body;

vec3 sunlight_on(Place place) { return vec3(0.0); }
vec3 skylight_on(Place place) { return vec3(0.0); }
float shadow_sun_rad() { return 1e-3; }
float shadow_flattening() { return 0.0; }
float limb_fade(float opacity, float mu, float width) { return opacity; }
vec3 sun_surface(vec3 place, float mu, float moment, float footprint_rad) { return vec3(footprint_rad); }

// A white body of that radius, lit from where it is seen best.
void check_known_body(float radius) {
    body.radius = radius;
    body.flattening = body.other_radius = body.cloud_turn = 0.0;
    body.surface.relief = body.surface.gloss = body.surface.ice = 0.0;
    body.sunlight = body.surface.tint = body.surface.terminator = vec3(1.0);
}
vec3 check_to_eye_at(float mu) { return vec3(sqrt(1.0 - mu * mu), 0.0, mu); }
const vec3 check_overhead = vec3(0.0, 0.0, 1.0);
