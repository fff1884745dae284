// right
float channel(float c) { return c <= 0.04045 ? c * (1.0 / 12.92) : pow((c + 0.055) / 1.055, 2.4); }

vec3 srgb_to_linear(vec3 code) { return vec3(channel(code.r), channel(code.g), channel(code.b)); }

vec3 normal_to_linear(vec4 code) {
    vec3 n = code.xyz * 2.0 - 1.0;
    float size = length(n);
    if (size < 1e-6) {
        n = vec3(0.0, 0.0, 1.0);
        size = 1.0;
    }
    return n / size * (1.0 - code.a * code.a);
}

float roughness_to_linear(float r) {
    float alpha = r * r;
    return alpha * alpha;
}
