// Waves on a sphere, and the normal of the displaced sphere. A wave is a vec4: w is its height over the sphere, as a
// share of the radius, xyz its gradient there, in the space around.

// Plane waves along the six axes of an icosahedron: their sum has its symmetry on the sphere, and no pole. Heights are 0
// to 1; the larger the exponent, the narrower the peaks and the wider the valleys. `n` has unit length.
vec4 waves(vec3 n, float frequency, float exponent) {
    const float a = 0.5257311121, b = 0.8506508084;
    const vec3 axes[6] = vec3[](vec3(0, a, b), vec3(0, -a, b), vec3(a, b, 0), vec3(-a, b, 0), vec3(b, 0, a), vec3(b, 0, -a));
    float sum = 0.0;
    vec3 slope = vec3(0.0);
    for (int i = 0; i < 6; ++i) {
        float along = frequency * dot(n, axes[i]);
        sum += cos(along);
        slope -= frequency * sin(along) * axes[i];
    }
    float u = max(sum / 12.0 + 0.5, 1e-6), power = pow(u, exponent);
    return vec4(exponent * power / u / 12.0 * slope, power);
}

// [normal]
// The unit normal of the surface (1 + h(n)) n. Along the sphere the height changes by the tangential part of its gradient,
// over a distance that is 1 + h times as long on the displaced surface.
vec3 normal_above(vec3 n, vec4 height) {
    vec3 along = height.xyz - dot(height.xyz, n) * n;
    return normalize(n - along / (1.0 + height.w));
}
// [/normal]
