// The sRGB transfer function (IEC 61966-2-1). Input outside [0, 1] is clamped; NaN becomes 0.
vec3 encode_srgb(vec3 linear) {
    vec3 c = clamp(mix(linear, vec3(0.0), isnan(linear)), 0.0, 1.0);
    vec3 low = 12.92 * c;
    vec3 high = 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055;
    return mix(low, high, greaterThan(c, vec3(0.0031308)));
}
