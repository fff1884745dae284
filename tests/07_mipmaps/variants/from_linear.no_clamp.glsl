// wrong: takes pow(-0.1
vec3 linear_to_srgb(vec3 linear) {
    return mix(12.92 * linear, 1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055, greaterThan(linear, vec3(0.0031308)));
}

vec4 normal_from_linear(vec3 mean) {
    float size = length(mean);
    vec3 n = size > 1e-4 ? mean / size : vec3(0.0, 0.0, 1.0);
    return vec4(0.5 + 0.5 * n, sqrt(max(1.0 - size, 0.0)));
}

float roughness_from_linear(float mean) { return sqrt(sqrt(max(mean, 0.0))); }
