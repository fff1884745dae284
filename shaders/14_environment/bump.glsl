// Bumps of a surface without texture coordinates: noise in space, whose gradient turns the normal.
#include "11_fractals/lattice.glsl"

float bump_corner(ivec3 cell) { return lattice(cell.xy + ivec2(7919, 104729) * cell.z); }

// Value noise and its gradient, smooth by t² (3 - 2 t).
vec4 bump_noise(vec3 p) {
    ivec3 cell = ivec3(floor(p));
    vec3 f = p - vec3(cell), s = f * f * (3.0 - 2.0 * f), slope = 6.0 * f * (1.0 - f);
    vec4 found = vec4(0.0);
    for (int i = 0; i < 8; ++i) {
        ivec3 corner = ivec3(i & 1, i >> 1 & 1, i >> 2);
        vec3 near = vec3(corner), w = mix(1.0 - s, s, near), dw = mix(-slope, slope, near);
        float height = bump_corner(cell + corner);
        found += height * vec4(dw.x * w.y * w.z, w.x * dw.y * w.z, w.x * w.y * dw.z, w.x * w.y * w.z);
    }
    return found;
}

// J. Blinn, "Simulation of Wrinkled Surfaces", SIGGRAPH 1978: the normal less the gradient's part along the surface.
// `bumps_per_m` bumps in a metre, `depth` of a bump as a share of its width. Bumps below two pixels are left out.
vec3 bumped(vec3 normal, vec3 position, float bumps_per_m, float depth) {
    float pixels = 1.0 / max(bumps_per_m * max(length(dFdx(position)), length(dFdy(position))), 1e-9);
    vec3 gradient = depth * clamp(pixels - 1.0, 0.0, 1.0) * bump_noise(position * bumps_per_m).xyz;
    return normalize(normal - (gradient - dot(gradient, normal) * normal));
}
