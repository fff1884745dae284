// The slopes and the normal of Gerstner waves.

// [gerstner_normal]
mat3 gerstner_slopes(vec2 at, vec2 k, float amplitude, float steepness, float phase) {
    float t = dot(k, at) - phase, across = -steepness * amplitude * sin(t), up = amplitude * cos(t);
    vec2 d = normalize(k);
    vec3 by_phase = vec3(d.x * across, up, d.y * across);
    return mat3(k.x * by_phase, vec3(0.0), k.y * by_phase);
}

vec3 gerstner_normal(mat3 slopes) {
    vec3 normal = cross(slopes[2] + vec3(0.0, 0.0, 1.0), slopes[0] + vec3(1.0, 0.0, 0.0));
    float size = length(normal);
    return size > 0.0 ? normal / size : vec3(0.0, 1.0, 0.0);
}
// [/gerstner_normal]
