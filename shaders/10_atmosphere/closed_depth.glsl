// Optical depth from a point out of the air without a loop: of molecules and dust by Smith and Smith's fit, or with
// ONEIL by O'Neil's; of the layer, with its density linear in height, by the length of the ray on either side of its
// middle.
#include "10_atmosphere/air.glsl"
#include "10_atmosphere/optical_depth.glsl"

// S. O'Neil, "Accurate atmospheric scattering", GPU Gems 2, 2005, chapter 16: fitted to air whose scale height is a quarter
// of its own height, which is 2.5% of the planet's radius. Anything else it gets wrong near the horizon.
float polynomial_depth(float height, float slope, float scale_height) {
    float x = 1.0 - slope;
    float power = -0.00287 + x * (0.459 + x * (3.83 + x * (-6.80 + x * 5.25)));
    return scale_height > 0.0 ? scale_height * exp(-height / scale_height + min(power, 20.0)) : 0.0;
}

vec3 layer_at(vec3 heights) { return max(1.0 - abs(heights - air.layer_center) / air.layer_width, 0.0); }

// The layer's part on one side of the lowest point of a ray's line, from a point `from` metres away and of height
// `lower`. Along it heights grow nearly as a parabola, the density with them, and Simpson's rule for each half of the
// layer is exact. `height` and `start` are of any point on the line.
float layer_beyond(float height, float start, float from, float lower) {
    vec3 shells = clamp(air.layer_center + air.layer_width * vec3(-1.0, 0.0, 1.0), lower, air.top);
    vec3 ways = max(sqrt(max(start * start + (shells - height) * (2.0 * air.radius + shells + height), 0.0)), from);
    vec2 middles = 0.5 * (ways.xy + ways.yz);
    vec2 k = height * (2.0 * air.radius + height) + (middles - start) * (middles + start);
    vec2 between = layer_at((k / (air.radius + sqrt(max(air.radius * air.radius + k, 0.0)))).xyy).xy;
    vec3 ends = layer_at(shells);
    return dot(ways.yz - ways.xy, ends.xy + ends.yz + 4.0 * between) / 6.0;
}

// Along a ray out of the air, in metres as dense as the middle.
float layer_depth(float height, float slope) {
    if (air.layer_width <= 0.0) return 0.0;
    float start = (air.radius + height) * slope, away = abs(start);
    float beyond = layer_beyond(height, start, away, height);
    if (slope >= 0.0) return beyond;
    float down = (air.radius + height) * slope * slope / (1.0 + sqrt(max(1.0 - slope * slope, 0.0)));
    return max(2.0 * layer_beyond(height, start, 0.0, max(height - down, 0.0)) - beyond, 0.0);
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
