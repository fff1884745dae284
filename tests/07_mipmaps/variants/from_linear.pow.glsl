// right
vec3 linear_to_srgb(vec3 linear) {
    vec3 result;
    for (int i = 0; i < 3; ++i) {
        float c = min(max(linear[i], 0.0), 1.0);
        result[i] = c > 0.0031308 ? 1.055 * pow(c, 0.41666666) - 0.055 : c * 12.92;
    }
    return result;
}

vec4 normal_from_linear(vec3 mean) {
    float squared = dot(mean, mean);
    if (squared < 1e-8) return vec4(0.5, 0.5, 1.0, sqrt(1.0 - sqrt(squared)));
    float size = sqrt(squared);
    return vec4(0.5 + 0.5 * mean / size, sqrt(1.0 - min(size, 1.0)));
}

float roughness_from_linear(float mean) { return pow(max(mean, 0.0), 0.25); }
