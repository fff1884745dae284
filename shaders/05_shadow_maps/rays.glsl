// Visible share of a lamp by ray tracing, the reference for shadows.
#include "05_shadow_maps/bvh.glsl"
#include "05_shadow_maps/sampling.glsl"

layout(scalar) uniform RaysBlock { int truth_samples; } rays;

uint rays_seed = 0u;  // per-pixel seed; set by seed_of() first

// Disc lamp facing the lit point. `to_middle` and `radius` are in metres; for a lamp at infinity `to_middle` has unit
// length and `radius` is the tangent of the angular radius.
struct Lamp {
    vec3 to_middle;
    float radius;
    float most;  // ray length in distances to the disc: 1, or unbounded
};

// False after lavapipe has cut loops short (it ends an invocation's loops after 65,535 iterations in all, and each
// later one after one), so that results may be wrong. The count of two is hidden from compilers.
bool loops_turn() {
    uint two = 2u * min(uint(rays.truth_samples), 1u), turned = 0u;
    for (; turned < two; ++turned) {}
    return turned == two;
}

// Visible share of the lamp's disc from `origin`, 0 to 1: mean over the knob's number of rays. NaN if a driver has cut
// loops short.
float lamp_visibility(Lamp lamp, vec3 origin, uint seed) {
    float away = length(lamp.to_middle);
    if (away == 0.0) return 1.0;  // inside the lamp
    vec3 x, y;
    basis_of(lamp.to_middle / away, x, y);
    uint count = lamp.radius > 0.0 ? uint(rays.truth_samples) : 1u, seen = 0u, i = 0u;
    for (; i < count; ++i) {
        vec2 at = lamp.radius * on_disc(sobol_point(rays_state.first_sample + i, seed));
        if (!any_hit(Ray(origin, 0.0, lamp.to_middle + at.x * x + at.y * y, lamp.most))) ++seen;
    }
    return i == count ? float(seen) / float(count) : uintBitsToFloat(0x7fc00000u);
}
