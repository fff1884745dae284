// Texture coordinates that change with time, as for lava and water: a wave across both, and a steady flow along v.
#include "04_surface_maps/knobs.glsl"

// [moving_uv]
vec2 moving_uv(vec2 uv, float time_s) {
    const float tau = 6.2831853;
    return uv + maps.wobble * sin(tau * (uv.yx + vec2(0.31, 0.23) * time_s)) + vec2(0.0, maps.scroll * time_s);
}
// [/moving_uv]
