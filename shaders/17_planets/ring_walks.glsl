// Light that a ring's particles scatter more than once, by random walks: the reference, slow and without a fit.
#include "17_planets/single_scattering.glsl"

// M. Jarzynski and M. Olano, JCGT 9(3), 2020: pcg, as a sequence. 0 to 1, without 1.
float ring_random(inout uint state) {
    state = state * 747796405u + 2891336453u;
    uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return float(((word >> 22u) ^ word) >> 8u) / 16777216.0;
}

// A direction after one scattering: L. Henyey and J. Greenstein's function inverted, back or, a fiftieth, forward.
vec3 ring_scattered(vec3 along, inout uint state) {
    bool back = ring_random(state) < 0.98;
    float g = back ? 0.45 : 0.7, s = (1.0 - g * g) / (1.0 - g + 2.0 * g * ring_random(state));
    float cosine = (back ? -1.0 : 1.0) * clamp((1.0 + g * g - s * s) / (2.0 * g), -1.0, 1.0);
    float sine = sqrt(1.0 - cosine * cosine), turn = 6.2831853 * ring_random(state);
    vec3 side = normalize(cross(along, abs(along.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0)));
    return normalize(cosine * along + sine * (cos(turn) * side + sin(turn) * cross(along, side)));
}

// Radiance towards `to_eye` after two or more scatterings, in units of a white surface that faces the sun. `to_sun.y` is
// above 0. Every free path ends within the layer, at a weight; at each end the walk looks at the eye.
vec3 scattered_often(float depth, vec3 albedo, vec3 to_sun, vec3 to_eye, uint walks, uint seed) {
    vec3 sum = vec3(0.0);
    uint state = seed;
    for (uint i = 0u; i < walks; ++i) {
        vec3 along = -to_sun, weight = vec3(1.0);
        float at = 0.0;  // optical depth below the side that the sun lights
        for (int order = 1; order <= 48; ++order) {  // llvmpipe ends all loops after 65,535 rounds: 1,024 walks
            float down = -along.y, slant = max(abs(down), 1e-4);
            float ahead = (down > 0.0 ? depth - at : at) / slant, met = 1.0 - exp(-ahead);
            at += down * -log(1.0 - met * ring_random(state));
            at = clamp(at, 0.0, depth);
            weight *= met * albedo;
            if (order > 1) {
                float left = (to_eye.y > 0.0 ? at : depth - at) / abs(to_eye.y);
                sum += weight * ring_particle_phase(-dot(along, to_eye)) * exp(-left);
            }
            if (max(weight.r, max(weight.g, weight.b)) < 1e-3) break;
            along = ring_scattered(along, state);
        }
    }
    return sum * to_sun.y / (4.0 * abs(to_eye.y) * float(walks));
}
