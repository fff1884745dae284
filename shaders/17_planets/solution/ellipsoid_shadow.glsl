// Solution of 17.ellipsoid_shadow.
#include "05_shadow_maps/sphere_visibility.glsl"

float ellipsoid_shadow(vec3 point, vec3 pole, float radius, float flattening, vec3 to_sun, float sun_rad) {
    float more = flattening / (1.0 - flattening);  // 1 / (1 - flattening) - 1, without losing digits
    vec3 at = point + more * dot(point, pole) * pole;
    vec3 towards = normalize(to_sun + more * dot(to_sun, pole) * pole);
    return sphere_visibility(-at, radius, towards, sun_rad);
}
