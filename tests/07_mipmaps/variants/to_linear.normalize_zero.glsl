// wrong: normalizes a vector of length 0
vec3 srgb_to_linear(vec3 code) {
    return mix(code / 12.92, pow((code + 0.055) / 1.055, vec3(2.4)), greaterThan(code, vec3(0.04045)));
}

vec3 normal_to_linear(vec4 code) { return normalize(2.0 * code.rgb - 1.0) * (1.0 - code.a * code.a); }

float roughness_to_linear(float r) { return r * r * r * r; }
