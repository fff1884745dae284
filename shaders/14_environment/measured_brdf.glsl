// A measured isotropic BRDF: MeasuredBrdf of chapters/14_environment/measured_brdf.h as a volume.
#include "04_surface_maps/microfacets.glsl"

uniform sampler3D paint_measured;  // phi_d, theta_d, square root of theta_h

// [measured]
// BRDF per steradian. With cosines alone, phi_d and 180 degrees - phi_d are told apart, but not left and right.
vec3 measured_brdf(float n_dot_l, float n_dot_v, float l_dot_v) {
    float cos_d = sqrt(max(0.5 + 0.5 * l_dot_v, 0.0)), sin_d = sqrt(max(0.5 - 0.5 * l_dot_v, 0.0));
    float cos_h = min((n_dot_l + n_dot_v) / max(2.0 * cos_d, 1e-6), 1.0), sin_h = sqrt(1.0 - cos_h * cos_h);
    float cos_phi = clamp((n_dot_v - n_dot_l) / max(2.0 * sin_h * sin_d, 1e-6), -1.0, 1.0);
    vec3 angles = vec3(0.5 * acos(cos_phi), acos(min(cos_d, 1.0)), acos(max(cos_h, 0.0))) / (0.5 * pi);
    return textureLod(paint_measured, vec3(angles.xy, sqrt(angles.z)), 0.0).rgb;
}
// [/measured]
