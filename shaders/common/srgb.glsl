// The sRGB transfer function (IEC 61966-2-1). Input outside [0, 1] is clamped; NaN becomes 0.
vec3 encode_srgb(vec3 linear) {
    vec3 c = clamp(mix(linear, vec3(0.0), isnan(linear)), 0.0, 1.0);
    vec3 low = 12.92 * c;
    vec3 high = 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055;
    return mix(low, high, greaterThan(c, vec3(0.0031308)));
}

// Inverse: codes from 0 to 1 to linear light.
vec3 decode_srgb(vec3 code) {
    vec3 low = code / 12.92, high = pow((max(code, 0.0) + 0.055) / 1.055, vec3(2.4));
    return mix(low, high, greaterThan(code, vec3(0.04045)));
}

// Rounding to the nearest of 256 codes, since devices round differently: an H200 by up to a sixteenth of a code.
vec3 nearest_code(vec3 code) { return floor(255.0 * code + 0.5) / 255.0; }
