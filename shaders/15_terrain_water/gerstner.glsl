// One Gerstner wave.

// F. Gerstner, "Theorie der Wellen", 1802; as M. Finch has it, "Effective Water Simulation from Physical Models", GPU Gems,
// 2004, chapter 1.
vec3 gerstner(vec2 at, vec2 k, float amplitude, float steepness, float phase) {
    float t = dot(k, at) - phase;
    vec2 along = normalize(k) * steepness * amplitude * cos(t);
    return vec3(along.x, amplitude * sin(t), along.y);
}
