// Shadows between a sphere and its ring, without a map: what the module SphereShadow gives to shaders.
#include "05_shadow_maps/hidden_share.glsl"
#include "05_shadow_maps/ringed_planet.h"
#include "05_shadow_maps/sphere_shadow.glsl"

layout(scalar) uniform SphereShadowBlock {
    float width;
    float power;
    float sun_deg;
} sphere_shadow;
layout(scalar) uniform SphereShadowPlanetBlock { RingedPlanet sphere_shadow_planet; };
uniform sampler2D sphere_shadow_ring;  // u from the inner to the outer radius; alpha is what it hides, seen along its normal

// [sphere_visibility]
// What of the sun's disc the sphere leaves. `sun_rad` is half the angle that the disc fills. How far the sphere's edge is
// from the sun's middle is a small difference of two angles that need not be small; the GPU's arc functions may be wrong
// by 4,096 units in the last place (Vulkan specification, Precision and Operation of SPIR-V Instructions), more than the
// whole sun. So: the sine of the difference, from sines and cosines that are ratios of lengths.
float sphere_visibility(vec3 to_center, float radius, vec3 to_light, float sun_rad) {
    float away = length(to_center), along = dot(to_center, to_light), across = length(cross(to_center, to_light));
    float to_edge = sqrt(max((away - radius) * (away + radius), 1e-12 * radius * radius));  // where sight touches it
    float away_squared = max(away * away, radius * radius);
    float gap_sine = (across * to_edge - along * radius) / away_squared;
    float gap_cosine = (along * to_edge + across * radius) / away_squared;
    if (gap_cosine <= 0.0) return 1.0;  // on the other side of the sky
    // The sphere's edge is curved as a disc's whose radius is its tangent.
    float disc = min(radius / (to_edge * sun_rad), 1e6);
    return 1.0 - hidden_share(disc, max(gap_sine / sun_rad, -disc));
}
// [/sphere_visibility]

// [ring_transmittance]
// What of the light comes through a ring that is infinitely thin. `point` is seen from the ring's middle. In the ring's
// plane there is no way through it: neither for a point of the ring itself, nor for light along it. `alpha` hides
// 1 - exp(-tau) of the light along the normal, and tau / |slope| is the optical depth along the way. A sun that fills an
// angle of 2 sun_rad sees as much of the ring at once: a mip whose texels are as wide.
float ring_transmittance(vec3 point, vec3 normal, vec3 to_light, float inner, float outer, float sun_rad) {
    float slope = dot(to_light, normal);
    if (abs(slope) < 1e-6) return 1.0;
    float t = -dot(point, normal) / slope;
    float r = length(point + t * to_light);
    // A point of the ring is not exactly in its plane.
    if (t <= 1e-4 * outer || r < inner || r > outer) return 1.0;
    float texel = (outer - inner) / float(textureSize(sphere_shadow_ring, 0).x);
    float lod = log2(max(2.0 * sun_rad * t / texel, 1.0));
    float alpha = textureLod(sphere_shadow_ring, vec2((r - inner) / (outer - inner), 0.5), lod).a;
    return pow(clamp(1.0 - alpha, 0.0, 1.0), 1.0 / abs(slope));
}
// [/ring_transmittance]

// [planet_visibility]
float planet_visibility(vec3 position, vec3 to_light) {
    RingedPlanet planet = sphere_shadow_planet;
    vec3 to_center = planet.center - position;
    float visible = 1.0, sun_rad = 0.0;
#if SPHERE_SHADOW_METHOD == SPHERE_SHADOW_METHOD_EXACT
    sun_rad = 0.5 * radians(sphere_shadow.sun_deg);
#endif
    if (planet.radius > 0.0) {
#if SPHERE_SHADOW_METHOD == SPHERE_SHADOW_METHOD_HARD
        visible = sphere_shadow_hard(to_center, planet.radius, to_light);
#elif SPHERE_SHADOW_METHOD == SPHERE_SHADOW_METHOD_POWER
        visible = sphere_shadow_power(to_center, planet.radius, to_light, sphere_shadow.width * planet.radius,
                                      sphere_shadow.power);
#elif SPHERE_SHADOW_METHOD == SPHERE_SHADOW_METHOD_EXACT
        visible = sphere_visibility(to_center, planet.radius, to_light, sun_rad);
#endif
    }
#if SPHERE_SHADOW_METHOD != SPHERE_SHADOW_METHOD_NONE
    if (planet.outer > 0.0)
        visible *= ring_transmittance(-to_center, planet.normal, to_light, planet.inner, planet.outer, sun_rad);
#endif
    return visible;
}
// [/planet_visibility]
