// Ray-traced visibility of lights at a point and around it, for shadow_error().
#include "03_attenuation/light_data.h"
#include "05_shadow_maps/rays.glsl"
#include "05_shadow_maps/shadow_data.h"
#include "05_shadow_maps/shadow_error.h"

// `to_light`: unit length, for directional lights.
Lamp lamp_of(ShadowLight light, vec3 position, vec3 to_light) {
    if (light.kind == LIGHT_DIRECTIONAL) return Lamp(to_light, 0.5 * light.size, on_and_on);
    return Lamp(light.position - position, 0.5 * light.size, 1.0);
}

// visibility_in_map() by rays.
float visibility_by_rays(ShadowLight light, vec3 position, vec3 facing, vec3 to_light) {
    if (light.views == 0u) return 1.0;  // no shadow
    vec3 origin = above(position, facing);
    return lamp_visibility(lamp_of(light, origin, to_light), origin, rays_seed);
}

const uint rays_around = 16u;

// `radius_m`: reach of the filter perpendicular to the light, half its kernel on the map plus a texel. Samples lie in
// the surface's plane, so that a slope does not count as a neighbour's shadow; the reach grows with the surface's tilt.
ShadowTruth shadow_truth(ShadowLight light, vec3 position, vec3 facing, vec3 to_light, float radius_m) {
    ShadowTruth truth;
    truth.visibility = visibility_by_rays(light, position, facing, to_light);
    truth.least = truth.visibility;
    truth.most = truth.visibility;
    vec3 x, y, origin = above(position, facing);
    basis_of(to_light, x, y);
    float tilt = max(dot(facing, to_light), 1e-3);
    for (uint i = 0u; i < rays_around; ++i) {
        vec2 at = radius_m * on_disc(sobol_point(i, rays_seed + 1u));
        vec3 across = at.x * x + at.y * y;
        vec3 neighbour = origin + across - to_light * (dot(across, facing) / tilt);
        Lamp lamp = lamp_of(light, neighbour, to_light);
        float visible = any_hit(Ray(neighbour, 0.0, lamp.to_middle, lamp.most)) ? 0.0 : 1.0;
        truth.least = min(truth.least, visible);
        truth.most = max(truth.most, visible);
    }
    RayHit hit;
    Lamp lamp = lamp_of(light, origin, to_light);
    bool blocked = closest_hit(Ray(origin, 0.0, lamp.to_middle, lamp.most), hit);
    truth.blocker_m = blocked ? hit.t * length(lamp.to_middle) : -1.0;
    if (!loops_turn()) truth.visibility = uintBitsToFloat(0x7fc00000u);
    return truth;
}
