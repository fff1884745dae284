// The surface of a body that the Sun lights.
#include "10_atmosphere/sea.glsl"
#include "17_planets/air_shell.glsl"
#include "17_planets/body_inputs.glsl"
#include "17_planets/clouds.glsl"
#include "17_planets/flow.glsl"
#include "17_planets/map_lookup.glsl"
#include "17_planets/night_lights.glsl"
#include "17_planets/rings.glsl"
#include "17_planets/surface_laws.glsl"
#include "05_shadow_maps/sphere_visibility.glsl"
#include "common/light.glsl"

uniform sampler2D night_map, water_map;
uniform sampler2D body_map, next_map, normal_map;

// The normal that the map of normals tilts; `up` is the smooth one. East is undefined at the poles, where the tilt fades.
vec3 tilted_normal(vec3 up, vec2 uv, float footprint_rad, float strength) {
    vec3 tilt = 2.0 * map_texel(normal_map, uv, footprint_rad).xyz - 1.0;
    float around = length(up.xz);
    vec3 east = around > 1e-4 ? vec3(up.z, 0.0, -up.x) / around : vec3(1.0, 0.0, 0.0), north = cross(up, east);
    strength *= smoothstep(0.02, 0.25, around);
    return normalize(up * max(tilt.z, 0.05) + strength * (tilt.x * east + tilt.y * north));
}

// Share of the Sun's disc left by another body and the rings.
float sun_seen(vec3 at, vec3 to_sun) {
    float seen = 1.0;
    if (body.other_radius > 0.0)
        seen = sphere_visibility(body.to_body * body.other - at, body.other_radius, to_sun, shadow_sun_rad());
#ifdef BODY_RINGS
    seen *= ring_shadow(body.rings, at, to_sun, shadow_sun_rad());
#endif
    return seen;
}

#ifndef BODY_STAR
const float ice_f0 = 0.018, ice_exponent = 40.0;  // of water ice, with an index of 1.31; slopes of 9 degrees

// Radiance towards `to_eye`. `round_at` is the place in round space, from the centre; a pixel covers `pixel_m` across the ray.
vec3 seen_surface(vec3 round_at, vec3 to_eye, vec3 to_sun, float pixel_m) {
    vec3 round_up = round_at / body.radius;
    vec3 up = normalize(vec3(round_up.x, round_up.y / (1.0 - body.flattening), round_up.z));
    vec3 at = vec3(round_at.x, round_at.y * (1.0 - body.flattening), round_at.z);
    float facing = max(dot(up, to_eye), 0.0), cosine = dot(up, to_sun);
    float footprint_rad = footprint_of(pixel_m, body.radius, facing);
    vec2 uv = map_uv(round_up);
#ifdef BODY_FLOW
    vec4 texel = flowed(body_map, next_map, uv, footprint_rad, body.flow_days, body.flow_period);
#else
    vec4 texel = map_texel(body_map, uv, footprint_rad);
#endif
    // The tint is the dust's: ice between it stays white.
    float least = min(texel.r, min(texel.g, texel.b)), most = max(texel.r, max(texel.g, texel.b));
    vec3 grey = vec3(dot(body.surface.tint, vec3(1.0 / 3.0)) * mix(least, most, 0.75));
    vec3 albedo = mix(texel.rgb * body.surface.tint, grey, body.surface.ice * smoothstep(0.3, 0.5, least));
    float relief = planets.relief * body.surface.relief;
#ifdef BODY_EARTH
    float water = map_texel(water_map, uv, footprint_rad).r;
    relief *= 1.0 - water;
#endif
    relief *= smoothstep(0.0, 0.3, facing);  // at the limb crests hide the slopes behind them
    vec3 normal = relief > 0.0 ? tilted_normal(up, uv, footprint_rad, relief) : up;
    float tilted_cosine = dot(normal, to_sun), mu = max(dot(normal, to_eye), 0.03);  // a slope that faces away at the limb is seen past its crest
    // Behind the smooth terminator a slope is in the shadow of the ground before it.
    if (relief > 0.0) tilted_cosine = min(tilted_cosine, tilted_cosine * smoothstep(-0.04, 0.06, cosine));
    float cos_phase = clamp(dot(to_eye, to_sun), -1.0, 1.0);
    vec3 low = mix(body.surface.terminator, vec3(1.0), smoothstep(0.0, 0.45, cosine));
    vec3 sun = body.sunlight * low * sun_seen(at, to_sun);
#ifdef BODY_EARTH
    Place place = Place(0.0, cosine);
    vec3 through = sunlight_at(cosine) * sun_seen(at, to_sun) * cloud_shadow(round_up, to_sun, footprint_rad);
    vec3 sky = skylight_on(place) / 3.14159265;
    vec3 light = albedo * (body.sunlight * through * max(tilted_cosine, 0.0) + sky);
    if (water > 0.01 && cosine > -0.1) {
        vec3 gloss = sea_light(place, up, up, -to_eye, to_sun, planets.waves, vec3(0.0)) * through;
        light = mix(light, albedo * (body.sunlight * through * max(cosine, 0.0) + sky) + gloss, water);
    }
    // The map's yellow is its makers'. Sodium and white lamps together are a warm white.
    float lamps = luminance(map_texel(night_map, uv, footprint_rad).rgb);
    vec3 city = planets.night * lamps * vec3(1.14, 0.98, 0.79);
    return light + night_lights(city, cosine, clouds_over(round_up, footprint_rad));
#else
#ifdef BODY_AIR
    // Where air bends light around the edge, its own transmittance says how much arrives.
    if (cosine > -0.2) sun *= mix(vec3(1.0), sunlight_at(max(cosine, 0.0)), step(0.5, float(body.surface.law != LAW_WRAPPED)));
#endif
    // Smooth ice mirrors the sun in its facets: J. Blinn's lobe, 1977, with ice's Fresnel reflectance; the map's alpha says
    // where. In units of a white surface that faces the sun.
    vec3 middle = normalize(to_eye + to_sun);
    float facet = max(dot(normal, middle), 0.0), fresnel = schlick(max(dot(to_eye, middle), 0.0), ice_f0);
    float gloss = body.surface.gloss * texel.a * fresnel * 0.125 * (ice_exponent + 8.0) * pow(facet, ice_exponent) * max(tilted_cosine, 0.0);
    return sun * (reflected(body.surface, albedo, tilted_cosine, mu, cos_phase) + gloss);
#endif
}
#endif
