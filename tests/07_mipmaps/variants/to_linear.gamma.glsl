// wrong: srgb_to_linear(
vec3 srgb_to_linear(vec3 code) { return pow(code, vec3(2.2)); }

vec3 normal_to_linear(vec4 code) {
    vec3 n = 2.0 * code.rgb - 1.0;
    n = dot(n, n) > 1e-12 ? normalize(n) : vec3(0.0, 0.0, 1.0);
    return n * (1.0 - code.a * code.a);
}

float roughness_to_linear(float r) { return r * r * r * r; }
