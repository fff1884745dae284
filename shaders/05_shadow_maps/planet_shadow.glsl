// Analytic shadows between a sphere and its ring: GLSL of the module SphereShadow.
#include "05_shadow_maps/ringed_planet.h"
#include "05_shadow_maps/sphere_shadow.glsl"
#include "05_shadow_maps/sphere_visibility.glsl"

layout(scalar) uniform SphereShadowBlock {
    float width;
    float power;
    float sun_deg;
} sphere_shadow;
layout(scalar) uniform SphereShadowPlanetBlock { RingedPlanet sphere_shadow_planet; };
uniform sampler2D sphere_shadow_ring;  // u from the inner to the outer radius; alpha: opacity along its normal

// Transmittance of an infinitely thin ring; `point` is relative to its centre. No light passes within the ring's plane.
// `alpha` is 1 - exp(-tau) along the normal; the optical depth along the ray is tau / |slope|. A sun of angle 2 sun_rad
// averages the ring over its width: the mip with texels of that width.
float ring_transmittance(vec3 point, vec3 normal, vec3 to_light, float inner, float outer, float sun_rad) {
    float slope = dot(to_light, normal);
    if (abs(slope) < 1e-6) return 1.0;
    float t = -dot(point, normal) / slope;
    float r = length(point + t * to_light);
    // Points of the ring are not exactly in its plane.
    if (t <= 1e-4 * outer || r < inner || r > outer) return 1.0;
    float texel = (outer - inner) / float(textureSize(sphere_shadow_ring, 0).x);
    float lod = log2(max(2.0 * sun_rad * t / texel, 1.0));
    float alpha = textureLod(sphere_shadow_ring, vec2((r - inner) / (outer - inner), 0.5), lod).a;
    return pow(clamp(1.0 - alpha, 0.0, 1.0), 1.0 / abs(slope));
}

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
