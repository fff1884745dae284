// Mean reflectance of rough water from above.
const float WATER_INDEX = 1.333;  // refractive index

// [rough_reflectance]
// C. Bruneton et al., "Real-time Realistic Ocean Lighting", Eurographics 2010, equation 23. `smooth_share` is the
// reflectance of level water at that cosine, `deviation` the standard deviation of the slopes along the view: one axis.
float rough_reflectance(float smooth_share, float cosine, float deviation) {
    const float f0 = 0.0204;
    float turned = pow(max(1.0 - cosine, 1e-3), 5.0 * exp(-2.69 * deviation) - 5.0);
    return f0 + (smooth_share - f0) * turned / (1.0 + 22.7 * pow(deviation, 1.5));
}
// [/rough_reflectance]
