// Optical depth from a place out of the air without a loop: of molecules and dust by Smith and Smith's fit, or with ONEIL by
// O'Neil's; of the layer, whose density is linear in height, by the length of the ray on either side of its middle.
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

// [layer]
float layer_at(float height) { return density_at(height).z; }

// Through one side of the layer, between two heights, on a ray that rises: in metres as dense as the middle. What counts is how
// far a place on the ray lies from where the ray's line is lowest. By that length heights grow nearly as a parabola, density
// with them, and Simpson's rule is exact.
float layer_between(float height, float slope, float lower, float upper) {
    lower = max(lower, height);
    upper = min(upper, air.top);
    if (upper <= lower) return 0.0;
    float start = (air.radius + height) * slope;
    vec2 shells = vec2(lower, upper);
    vec2 ways = sqrt(max(start * start + (shells - height) * (2.0 * air.radius + shells + height), 0.0));
    float middle = height_at(height, slope, 0.5 * (ways.x + ways.y) - start);
    return (ways.y - ways.x) / 6.0 * (layer_at(lower) + 4.0 * layer_at(middle) + layer_at(upper));
}

float layer_upwards(float height, float slope) {
    if (air.layer_width <= 0.0) return 0.0;
    return layer_between(height, slope, air.layer_center - air.layer_width, air.layer_center) +
           layer_between(height, slope, air.layer_center, air.layer_center + air.layer_width);
}
// [/layer]

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
