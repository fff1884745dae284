// Rings: their light by each method, and their shadow.
#include "17_planets/body_data.h"
#include "17_planets/ring_phase.glsl"
#include "17_planets/ring_walks.glsl"
#include "17_planets/single_scattering.glsl"

// Layers: colour of the particles (their single-scattering albedo) with the optical depth; and the tables back, forward, unlit. u from the inner to the
// outer edge.
uniform sampler2DArray ring_tables;

vec4 ring_texel(int layer, float u, float lod) { return textureLod(ring_tables, vec3(u, 0.5, float(layer)), lod); }

float ring_level(Rings rings, float width_m) {
    float texel = (rings.outer - rings.inner) / float(textureSize(ring_tables, 0).x);
    return log2(max(width_m / texel, 1.0));
}

// Transmittance of the rings towards `point`, from the planet's centre in the body's axes. The sun's disc averages a
// part of them as wide as itself. In the rings' plane nothing is between.
float ring_shadow(Rings rings, vec3 point, vec3 to_sun, float sun_rad) {
    if (abs(to_sun.y) < 1e-6) return 1.0;
    float t = -point.y / to_sun.y, r = length(point.xz + t * to_sun.xz);
    if (t <= 0.0 || r < rings.inner || r > rings.outer) return 1.0;
    float lod = ring_level(rings, 2.0 * sun_rad * t / max(abs(to_sun.y), 0.02));
    return exp(-ring_texel(0, (r - rings.inner) / (rings.outer - rings.inner), lod).a / abs(to_sun.y));
}

// Light towards the camera, premultiplied, in units of a white surface that faces the sun, and alpha. `point` is in the rings' plane;
// a pixel covers `width_m` of their radius. Directions of unit length, the body's axes.
vec4 ring_light(Rings rings, vec3 point, vec3 to_eye, vec3 to_sun, float width_m) {
    float r = length(point.xz);
    if (r < rings.inner - width_m || r > rings.outer + width_m) return vec4(0.0);
    float u = (r - rings.inner) / (rings.outer - rings.inner), lod = ring_level(rings, width_m);
    float mu = max(abs(to_eye.y), 1e-4), mu0 = max(abs(to_sun.y), 1e-4), cos_phase = dot(to_eye, to_sun);
    vec4 strip = ring_texel(0, u, lod);
    float inside = smoothstep(rings.inner - width_m, rings.inner, r) * (1.0 - smoothstep(rings.outer, rings.outer + width_m, r));
    float depth = strip.a * inside, hidden = 1.0 - exp(-depth / mu);
#if PLANETS_RINGS == PLANETS_RINGS_ALPHA
    // A painted disc: a Lambertian surface weighted by its opacity.
    return vec4(hidden * mu0 * rings.brightness * strip.rgb, hidden);
#elif PLANETS_RINGS == PLANETS_RINGS_TABLES
    vec3 light = ring_phase(ring_texel(1, u, lod).rgb, ring_texel(2, u, lod).rgb, ring_texel(3, u, lod).rgb, cos_phase,
                            to_sun.y, to_eye.y);
    return vec4(inside * rings.brightness * light, hidden);
#else
    bool lit = to_sun.y * to_eye.y > 0.0;
    float once = lit ? scattered_back(depth, mu0, mu) : scattered_through(depth, mu0, mu);
#if PLANETS_RINGS == PLANETS_RINGS_SINGLE_SCATTERING
    float sent = ring_particle_phase(cos_phase) + scattered_more(depth, strip.r, lit);
    return vec4(rings.brightness * strip.rgb * sent * once, hidden);
#else
    float side = to_sun.y < 0.0 ? -1.0 : 1.0;
    vec3 sun = vec3(to_sun.x, mu0, to_sun.z), eye = vec3(to_eye.x, to_eye.y * side < 0.0 ? -mu : mu, to_eye.z);
    uvec2 pixel = uvec2(gl_GlobalInvocationID.xy);
    vec3 often = depth > 0.0 ? scattered_often(depth, strip.rgb, sun, eye, uint(planets.walks), pixel.y * 16411u + pixel.x * 7u) : vec3(0.0);
    return vec4(rings.brightness * (strip.rgb * ring_particle_phase(cos_phase) * once + often), hidden);
#endif
#endif
}
