// B. Hapke, "Bidirectional reflectance spectroscopy. 1. Theory", Journal of Geophysical Research 86(B4), 1981, with the
// opposition surge of part 4 (Icarus 67, 1986); no large-scale roughness. The reference for airless surfaces.

// Single-scattering albedo, a Henyey-Greenstein function that sends light back, and a surge of half width h. Chosen so that a
// ball of it has the Moon's brightness at half phase; the lesson says how near.
const float hapke_w = 0.28, hapke_back = 0.24, hapke_h = 0.06, hapke_surge = 1.0;

float hapke_h_function(float mu) { return (1.0 + 2.0 * mu) / (1.0 + 2.0 * mu * sqrt(1.0 - hapke_w)); }

// Radiance over that of a white Lambertian surface that faces the sun; 0 where the sun or the camera is below the horizon.
float hapke_radiance(float mu0, float mu, float cos_phase) {
    if (mu0 <= 0.0 || mu <= 0.0) return 0.0;
    float half_tangent = sqrt(max(1.0 - cos_phase, 0.0) / max(1.0 + cos_phase, 1e-6));
    float surge = hapke_surge / (1.0 + half_tangent / hapke_h);
    float b = hapke_back, d = 1.0 + b * b - 2.0 * b * cos_phase, once = (1.0 - b * b) / (d * sqrt(d));
    float often = hapke_h_function(mu0) * hapke_h_function(mu) - 1.0;
    return 0.25 * hapke_w * mu0 / (mu0 + mu) * ((1.0 + surge) * once + often);
}
