// Solution of 07.to_linear.

// IEC 61966-2-1.
vec3 srgb_to_linear(vec3 code) {
    vec3 high = pow((max(code, 0.0) + 0.055) / 1.055, vec3(2.4));
    return mix(code / 12.92, high, greaterThan(code, vec3(0.04045)));
}

// The length is kept in alpha as chapter 04 does.
vec3 normal_to_linear(vec4 code) {
    vec3 n = 2.0 * code.rgb - 1.0;
    n = dot(n, n) > 1e-12 ? normalize(n) : vec3(0.0, 0.0, 1.0);
    return n * (1.0 - code.a * code.a);
}

// Variances add: M. Olano and D. Baker, "LEAN Mapping", I3D 2010, section 3; alpha = r^2: B. Burley, 2012.
float roughness_to_linear(float r) {
    return (r * r) * (r * r);
}
