// How much of a lamp a point sees, by rays: the truth of shadows.
#include "05_shadow_maps/bvh.glsl"
#include "05_shadow_maps/sampling.glsl"

layout(scalar) uniform RaysBlock { int truth_samples; } rays;

uint rays_seed = 0u;  // another one for every pixel: set it first, by seed_of()

// [lamp]
// A disc that faces the point it lights. `radius` is in metres where `to_middle` is; of a lamp far away, as the sun,
// `to_middle` has length 1 and `radius` is the tangent of half the angle that it fills.
struct Lamp {
    vec3 to_middle;
    float radius;
    float most;  // how far rays go, in lengths of their way to the disc: 1, or on and on
};
// [/lamp]

// Lavapipe ends all loops of an invocation after 65,535 iterations together, and each later loop after one. False:
// that has happened, and loop results may be wrong. Compilers must not see that the count is two.
bool loops_turn() {
    uint two = 2u * min(uint(rays.truth_samples), 1u), turned = 0u;
    for (; turned < two; ++turned) {}
    return turned == two;
}

// [lamp_visibility]
// The share of the lamp's disc that is seen from `origin`, 0 to 1: the mean of as many rays as the knob says. NaN,
// rather than a wrong number, where a driver has ended their loops.
float lamp_visibility(Lamp lamp, vec3 origin, uint seed) {
    float away = length(lamp.to_middle);
    if (away == 0.0) return 1.0;  // in the lamp itself
    vec3 x, y;
    basis_of(lamp.to_middle / away, x, y);
    uint count = lamp.radius > 0.0 ? uint(rays.truth_samples) : 1u, seen = 0u, i = 0u;
    for (; i < count; ++i) {
        vec2 at = lamp.radius * on_disc(sobol_point(rays_state.first_sample + i, seed));
        if (!any_hit(Ray(origin, 0.0, lamp.to_middle + at.x * x + at.y * y, lamp.most))) ++seen;
    }
    return i == count ? float(seen) / float(count) : uintBitsToFloat(0x7fc00000u);
}
// [/lamp_visibility]
