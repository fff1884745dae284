// Optical depth from a place out of the air without a loop: of molecules and dust by Smith and Smith's fit, or with ONEIL by
// O'Neil's; of the layer by its thickness over the cosine where a ray goes through its middle.
#include "10_atmosphere/air.glsl"
#include "10_atmosphere/optical_depth.glsl"

// [polynomial]
// S. O'Neil, "Accurate atmospheric scattering", GPU Gems 2, 2005, chapter 16: fitted to air whose scale height is a quarter
// of its own height, which is 2.5% of the planet's radius. Anything else it gets wrong near the horizon.
float polynomial_depth(float height, float slope, float scale_height) {
    if (scale_height <= 0.0) return 0.0;
    float x = 1.0 - slope;
    float power = -0.00287 + x * (0.459 + x * (3.83 + x * (-6.80 + x * 5.25)));
    return scale_height * exp(-height / scale_height + min(power, 20.0));
}
// [/polynomial]

// Vertically, from a height on, in metres as dense as the middle.
float layer_above(float height) {
    if (air.layer_width <= 0.0) return 0.0;
    float x = clamp((height - air.layer_center) / air.layer_width, -1.0, 1.0);
    return air.layer_width * (x < 0.0 ? 0.5 - x - 0.5 * x * x : 0.5 - x + 0.5 * x * x);
}

float layer_upwards(float height, float slope) {
    float middle = max(height, air.layer_center);
    float sine = (air.radius + height) / (air.radius + middle);
    float squared = 1.0 - sine * sine * (1.0 - slope * slope);
    return layer_above(height) / max(sqrt(max(squared, 0.0)), 0.03);
}

float layer_depth(float height, float slope) {
    if (slope >= 0.0) return layer_upwards(height, slope);
    float down = (air.radius + height) * slope * slope / (1.0 + sqrt(max(1.0 - slope * slope, 0.0)));
    return max(2.0 * layer_upwards(max(height - down, 0.0), 0.0) - layer_upwards(height, -slope), 0.0);
}

// The slope is above the horizon's.
vec3 closed_depth(float height, float slope) {
    height = max(height, 0.0);
#ifdef ONEIL
    float molecules = polynomial_depth(height, slope, air.rayleigh_height);
    float dust = polynomial_depth(height, slope, air.mie_height);
#else
    float molecules = optical_depth(height, slope, air.radius, air.rayleigh_height);
    float dust = optical_depth(height, slope, air.radius, air.mie_height);
#endif
    return air.rayleigh * molecules + air.mie_extinction * dust + air.layer * layer_depth(height, slope);
}
